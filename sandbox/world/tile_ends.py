"""From the outlines of tiles to the vertices of cores: a line has two, each between two corners of its outline."""

from __future__ import annotations

import numpy as np

from sandbox.tables import Floats
from sandbox.world.runs import run_starts, runs
from sandbox.world.tile_corners import NONE
from sandbox.world.tile_edges import NEAR
from sandbox.world.tile_outlines import Corners, Outlines, Tiles

Found = tuple[Corners, Corners, Floats, Floats]
"""The edges before and after corners, as `sides_at_corners` has them, and from where to where the edges from there on
show."""
_ON_A_QUARTER = 8
"""At so many places less one a quarter of a round end is asked whether it lies within other tiles."""


def with_round_ends(
    outlines: Outlines, one: Tiles, two: Tiles, before: Corners, after: Corners
) -> tuple[Corners, Corners]:
    """The edges before and after the corners of the tiles in `one`; those of a round line its own where it juts out.

    A corner of its outline may lie within the whole and the quarter of the round end beyond it not, or in part: then
    all of that leads out.
    """
    tiles = np.unique(one)
    corners, own = outlines.corners(tiles), np.repeat(tiles, outlines.counts[tiles])
    asking = np.flatnonzero((before == NONE) & (outlines.vertices[own] == 2) & ~outlines.flat[own])
    if not len(asking):
        return before, after
    corner = corners[asking]
    arriving, at_side = outlines.before[corner], (corner - outlines.starts[own[asking]]) % 2 == 0
    side, radius = np.where(at_side, corner, arriving), 0.5 * outlines.lengths[np.where(at_side, arriving, corner)]
    starts = np.searchsorted(one, own[asking])
    counts = np.searchsorted(one, own[asking], side="right") - starts
    asked, others = np.repeat(np.arange(len(asking)), counts), two[runs(starts, counts)]
    (from_x, from_y), (to_x, to_y), (side_x, side_y) = (outlines.normals(edges) for edges in (arriving, corner, side))
    juts = np.zeros(len(asking), np.bool_)
    for k in range(1, _ON_A_QUARTER):
        half = k / _ON_A_QUARTER  # the tangent of half the angle: no cosine, which differs from machine to machine
        c, s = (1.0 - half * half) / (1.0 + half * half), 2.0 * half / (1.0 + half * half)
        x = outlines.x[corner] + radius * (c * from_x + s * to_x - side_x)
        y = outlines.y[corner] + radius * (c * from_y + s * to_y - side_y)
        within, _ = outlines.within(x[asked], y[asked], others, NEAR)
        juts |= np.bincount(asked[within], minlength=len(asking)) == 0
    before[asking[juts]], after[asking[juts]] = arriving[juts], corner[juts]
    return before, after


def at_vertices(outlines: Outlines, tiles: Tiles, found: Found) -> Found:
    """What holds at the vertices of some tiles, from what was found at all of their corners.

    At the free end of a line all directions away from it lead out. Where another tile goes on from one of its two
    corners or both, at most one of them juts out of the whole, and that one tells; the other turns inwards, and the
    sides speak for themselves.
    """
    counts = outlines.vertices[tiles]
    of_line = np.repeat(counts == 2, counts)
    if not of_line.any():
        return found
    before, after, first, last = found
    corners, number = outlines.corners(tiles), runs(np.zeros(len(tiles), np.int64), counts)
    place = np.repeat(run_starts(outlines.counts[tiles]), counts) + np.where(of_line, 2 * number, number)
    across = np.where(of_line, np.searchsorted(corners, outlines.before[corners[place]]), place)
    edge, side, end = outlines.before[corners[across]], corners[place], corners[across]
    open_end = of_line & (before[across] == edge) & (after[across] == end) & (before[place] == end)
    open_end &= after[place] == side
    juts = outlines.bend(before[across], after[across]) > outlines.bend(before[place], after[place])
    chosen = np.where(juts, across, place)
    return (
        np.where(open_end, edge, before[chosen]),
        np.where(open_end, side, after[chosen]),
        first[place],
        last[place],
    )
