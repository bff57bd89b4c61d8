"""The tiles of a state, who of them lies beside whom, and joining some of them anew."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np

from sandbox.tables import Integers, Records, plain
from sandbox.world.flush import check_crowd, find_tiles, join_some
from sandbox.world.records import SEAMED
from sandbox.world.runs import runs
from sandbox.world.shape_rows import first_shape
from sandbox.world.state import State
from sandbox.world.tile_outlines import Outlines
from sandbox.world.tile_pairs import meeting_tiles
from sandbox.world.tile_rows import Bounds, Tiling, bounds_of

Bodies: TypeAlias = tuple[int, ...]
"""Rows of the body table, ascending."""
_NEAR = 1e-5
"""Farther apart than tiles may be that meet, in metres."""


def tiling_of(state: State) -> Tiling:
    """The tiles of a state, found once."""
    if state.tiling is None:
        shapes = plain(state.shapes)
        rows = find_tiles(plain(state.bodies), shapes)
        joined = rows[shapes["part"][rows] == 0]
        state.tiling = Tiling(rows, joined, len(state.seams) - int(shapes["vertex_count"][joined].sum()))
    return state.tiling


def neighbours(state: State, tiles: Integers) -> Integers:
    """The tiles with rows in the seam table whose boxes meet those of other `tiles`: how they join may change."""
    near = _around(state, tiles)
    if len(near) == len(tiles):  # nobody else
        return tiles[:0]
    outlines = Outlines.of(state.bodies, state.shapes, state.vertices, near)
    found = [near[two] for _, two in meeting_tiles(outlines, np.searchsorted(near, tiles))]
    beside = np.setdiff1d(np.concatenate(found), tiles)
    single: Integers = beside[plain(state.shapes)["part"][beside] == 0]
    return single


def rejoin(state: State, tiles: Integers) -> Bodies:
    """Find out anew how some tiles with rows in the seam table abut others.

    Returns the bodies of those that abut nothing now and did before, or the other way.
    """
    if len(tiles) == 0:
        return ()
    shapes = plain(state.shapes)
    before = shapes["traits"][tiles]
    shapes["traits"][tiles] &= ~SEAMED
    plain(state.seams)[runs(shapes["seam_start"][tiles], shapes["vertex_count"][tiles])] = 0
    near = _around(state, tiles)
    if len(near) > 1:
        outlines = Outlines.of(state.bodies, state.shapes, state.vertices, near)
        join_some(state.bodies, state.shapes, state.seams, outlines, np.searchsorted(near, tiles))
    changed = tiles[shapes["traits"][tiles] != before]
    return tuple(np.unique(shapes["body"][changed]).tolist())


def rejoin_around(state: State, tiles: Integers, left: Integers | None = None) -> Bodies:
    """Find out anew how `tiles` and all beside them abut others, and those that they have `left`; as `rejoin`."""
    if len(tiles) == 0:
        return ()
    single = tiles[plain(state.shapes)["part"][tiles] == 0]
    beside = neighbours(state, tiles)
    return rejoin(state, np.unique(np.concatenate([single, beside, beside[:0] if left is None else left])))


def check_room(state: State, bodies: Records, shapes: Records, vertices: Records) -> None:
    """Raise `CapacityError` if tiles of further bodies would lie in a crowd with each other and those that are there.

    `shapes` count their `bodies` and `vertices` from 0.
    """
    fresh = find_tiles(bodies, shapes)
    if len(fresh):
        outlines = Outlines.of(bodies, shapes, vertices, fresh)
        near = _may_meet(state, bounds_of(outlines))
        check_crowd(outlines.with_others(Outlines.of(state.bodies, state.shapes, state.vertices, near)))


def tiles_of(state: State, body: int) -> Integers:
    """The tiles of one body."""
    rows = tiling_of(state).rows
    first, end = (first_shape(state.shapes, row) for row in (body, body + 1))
    return rows[slice(*np.searchsorted(rows, (first, end)))].copy()


def note_moved(state: State, tiles: Integers) -> None:
    """Some tiles lie elsewhere now."""
    if len(tiles) == 0:
        return
    tiling = tiling_of(state)
    places = np.searchsorted(tiling.rows, tiles)
    known = places < len(tiling.boxes)
    tiling.boxes.put(places[known], Outlines.of(state.bodies, state.shapes, state.vertices, tiles[known]))


def _around(state: State, tiles: Integers) -> Integers:
    """Some tiles and all that may meet them: their rows, ascending."""
    if len(tiles) == 0:
        return tiles
    tiling = _with_boxes(state)
    return _may_meet(state, tiling.boxes.bounds(np.searchsorted(tiling.rows, tiles)))


def _may_meet(state: State, bounds: Bounds) -> Integers:
    """The tiles that reach into a box, or nearly."""
    tiling = _with_boxes(state)
    return tiling.rows[tiling.boxes.near(bounds, _NEAR)]


def _with_boxes(state: State) -> Tiling:
    """The tiles of a state, with the boxes of all."""
    tiling = tiling_of(state)
    known = len(tiling.boxes)
    if known < len(tiling.rows):
        fresh = tiling.rows[known:]
        tiling.boxes.add(Outlines.of(state.bodies, state.shapes, state.vertices, fresh))
    return tiling
