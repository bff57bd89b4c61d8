"""Shapes that abut: which of their edges are covered by others, so that nothing catches on them.

A floor of boxes is one surface, but the separating-axis test sees one box at a time. For each sharp polygon and line
this finds the stretches of its edges that show (`tile_edges.py`) and, where another one goes on from a corner, between
which normals that corner lies (`tile_corners.py`): rows of the seam table, as concave polygons and chains have them.
What is static is one whole, and its rows hold until a static body is moved; those of a body that moves hold for good.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.errors import CapacityError
from sandbox.tables import Integers, Records, plain
from sandbox.world.records import BODY, ONE_WAY, SEAM, SEAMED, STATIC
from sandbox.world.runs import run_starts, runs
from sandbox.world.tile_corners import sides_at_corners
from sandbox.world.tile_edges import shown_edges
from sandbox.world.tile_ends import at_vertices, with_round_ends
from sandbox.world.tile_outlines import Corners, Outlines, Tiles
from sandbox.world.tile_pairs import count_meeting, count_near, meeting_tiles

CROWD, NEIGHBOURS = 16_000_000, 100
"""So many pairs of edges are joined, and for each tile as many as it would have with so many others like it: in a
plane 19 are near to it, three layers of them are 49. Some 1,050 boxes in one place make as many, and take up to 3 s."""
PARTED = 8
"""So many times as many may be near to each other, where what lies aslant is parted from its neighbours."""


def with_room_for_tiles(bodies: Records, shapes: Records, seams: Records) -> Records:
    """The seam table with further rows for every static tile that may come to abut another one."""
    tiles = find_tiles(plain(bodies), plain(shapes))
    tiles = tiles[(shapes.traits[tiles] & SEAMED) == 0]
    counts = shapes.vertex_count[tiles]
    shapes.seam_start[tiles] = len(seams) + np.cumsum(counts) - counts
    rows = SEAM.zeros(len(seams) + int(counts.sum()))
    rows[: len(seams)] = seams
    return rows


def join_tiles(bodies: Records, shapes: Records, vertices: Records, seams: Records) -> None:
    """Find out anew which static tiles abut, and write it into the seam table and the traits of the shapes.

    Raises `CapacityError` where too many lie in one place, before they are gone through.
    """
    tiles = find_tiles(plain(bodies), plain(shapes))
    own = shapes.part[tiles] == 0
    shapes.traits[tiles[own]] &= ~SEAMED
    if len(tiles) < 2 or not own.any():
        return
    outlines = Outlines.of(bodies, shapes, vertices, tiles)
    check_crowd(outlines)
    join_some(bodies, shapes, seams, outlines, np.flatnonzero(own))


def join_parts(moves: NDArray[np.bool_], shapes: Records, vertices: Records) -> Records:
    """The rows of the seam table for shapes that abut others of their body, of the bodies that move.

    `shapes` get their `traits` and the `seam_start` of their rows; `vertices` are in the frames of the bodies.
    """
    if len(shapes) < 2:
        return SEAM.zeros(0)
    tiles = np.flatnonzero(moves[shapes.body] & _may_abut(shapes))
    tiles = tiles[np.bincount(shapes.body[tiles], minlength=len(moves))[shapes.body[tiles]] > 1]
    own = shapes.part[tiles] == 0
    counts = shapes.vertex_count[tiles[own]]
    shapes.seam_start[tiles[own]] = run_starts(counts)
    seams = SEAM.zeros(int(counts.sum()))
    if len(seams):
        bodies = BODY.zeros(len(moves))
        bodies.rotation_cos = 1.0
        outlines = Outlines.of(bodies, shapes, vertices, tiles, shapes.body[tiles])
        check_crowd(outlines)
        join_some(bodies, shapes, seams, outlines, np.flatnonzero(own))
    return seams


def check_crowd(outlines: Outlines) -> None:
    """Raise `CapacityError` if so many tiles lie in one place that to join them would take minutes."""
    tiles, edges = len(outlines.starts), len(outlines.x)
    limit = CROWD + NEIGHBOURS * int((outlines.counts * outlines.counts).sum())
    if edges * edges <= limit:
        return
    near = count_near(outlines)
    if near > PARTED * limit or (near > limit and count_meeting(outlines, limit) > limit):
        raise CapacityError(
            f"{tiles:,} polygons and lines that lie over each other or side by side make {near:,} pairs of edges, of "
            f"which {limit:,} may meet. Too many are in one place: spread them, or leave out those that others cover"
        )


def join_some(bodies: Records, shapes: Records, seams: Records, outlines: Outlines, asking: Tiles) -> None:
    """Write how some tiles abut others; `outlines` has all that may. So far they are joined to nothing."""
    tiles = outlines.shapes
    for one, two in meeting_tiles(outlines, asking):
        alike = _alike(shapes, tiles[one], tiles[two])
        _join(bodies, shapes, seams, outlines, one[alike], two[alike])


def find_tiles(bodies: Any, shapes: Any) -> Integers:
    """Static shapes that may abut others."""
    owner = shapes["body"]
    static = (bodies["type"][owner] == STATIC) & (bodies["frozen_step"][owner] < 0)
    return np.flatnonzero(static & _may_abut(shapes))


def _may_abut(shapes: Any) -> NDArray[np.bool_]:
    """Polygons with sharp corners and lines, round or not, that are solid from all sides."""
    counts, radius = shapes["vertex_count"], shapes["radius"]
    solid = (shapes["sensor"] == 0) & ((shapes["traits"] & ONE_WAY) == 0)
    fits: NDArray[np.bool_] = solid & ((counts == 2) | ((counts >= 3) & (radius == 0.0)))
    return fits


def _alike(shapes: Records, one: Integers, two: Integers) -> NDArray[np.bool_]:
    """Which pairs collide with the same things."""
    alike: NDArray[np.bool_] = shapes.category[one] == shapes.category[two]
    alike &= (shapes.mask[one] == shapes.mask[two]) & (shapes.group[one] == shapes.group[two])
    return alike


def _join(bodies: Records, shapes: Records, seams: Records, outlines: Outlines, one: Tiles, two: Tiles) -> None:
    """Fill in the rows of the tiles in `one`, given with all beside them: those that are partly covered."""
    if len(one) == 0:
        return
    corners, first, last = shown_edges(outlines, one, two)
    before, after = with_round_ends(outlines, one, two, *sides_at_corners(outlines, one, two, first, last))
    changed = (first != 0.0) | (last != 1.0)
    changed |= _differ(outlines, before, outlines.before[corners]) | _differ(outlines, after, corners)
    tiles = np.unique(one)
    counts = outlines.counts[tiles]
    seamed = np.logical_or.reduceat(changed, run_starts(counts))
    shapes.traits[outlines.shapes[tiles[seamed]]] |= SEAMED
    written = np.repeat(seamed, counts)
    tiles = tiles[seamed]
    before, after, first, last = at_vertices(
        outlines, tiles, (before[written], after[written], first[written], last[written])
    )
    rows, counts = outlines.shapes[tiles], outlines.vertices[tiles]
    place = runs(shapes.seam_start[rows], counts)
    body = np.repeat(shapes.body[rows], counts)
    for side, edges in (("before", before), ("after", after)):
        x, y = outlines.normals(edges)
        cos, sin = bodies.rotation_cos[body], bodies.rotation_sin[body]
        seams[f"{side}_x"][place], seams[f"{side}_y"][place] = cos * x + sin * y, cos * y - sin * x
    seams.shown_from[place], seams.shown_to[place] = first, last


def _differ(outlines: Outlines, edges: Corners, others: Corners) -> NDArray[np.bool_]:
    (x, y), (other_x, other_y) = outlines.normals(edges), outlines.normals(others)
    differ: NDArray[np.bool_] = (x != other_x) | (y != other_y)
    return differ
