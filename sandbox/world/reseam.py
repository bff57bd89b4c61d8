"""The seam table as rows come and go: laid out as in a world that is built from nothing.

First the rows that shapes came with, in the order of the shapes, then those of tiles. Shapes without any point at what
those before them came with.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sandbox.tables import Integers, Records, extended, plain, without
from sandbox.world.flush import find_tiles
from sandbox.world.records import SEAM, SEAMED, STATIC
from sandbox.world.runs import run_starts, runs
from sandbox.world.shape_rows import Rows
from sandbox.world.state import State
from sandbox.world.tile_rows import Tiling
from sandbox.world.tiling import neighbours, tiling_of


def add_seams(state: State, bodies: Rows, shapes: Rows, seams: Rows) -> Integers:
    """Make room for shapes that will come after all others, and point them there; they count their `bodies` and the
    rows in `seams` from 0. Returns the tiles that have to be joined anew then."""
    tiling, first = tiling_of(state), len(state.shapes)
    fresh = find_tiles(bodies, shapes) if (bodies["type"] == STATIC).any() else np.zeros(0, np.int64)
    shapes["seam_start"] += tiling.own
    if len(seams):
        _insert(state, tiling, seams)
    if len(fresh) == 0:
        return fresh
    single = fresh[shapes["part"][fresh] == 0]
    counts = shapes["vertex_count"][single]
    known = plain(state.shapes)
    alone = tiling.joined if len(tiling.joined) == 1 else tiling.joined[:0]
    if len(single) and len(tiling.joined) + len(single) > 1:
        counts = np.concatenate([known["vertex_count"][alone], counts])
        starts = len(state.seams) + run_starts(counts)
        state.seams = extended(state.seams, plain(SEAM.zeros(int(counts.sum()))))
        known["seam_start"][alone], shapes["seam_start"][single] = starts[: len(alone)], starts[len(alone) :]
    tiling.rows = np.concatenate([tiling.rows, first + fresh])
    tiling.joined = np.concatenate([tiling.joined, first + single])
    return np.concatenate([alone, first + fresh])


def _insert(state: State, tiling: Tiling, seams: Rows) -> None:
    """Put rows that shapes come with before those of the tiles."""
    behind = plain(state.seams)[tiling.own :].copy()
    state.seams = extended(state.seams, seams)
    rows, tiling.own = plain(state.seams), tiling.own + len(seams)
    rows[tiling.own - len(seams) : tiling.own], rows[tiling.own :] = seams, behind
    if len(behind):
        plain(state.shapes)["seam_start"][tiling.joined] += len(seams)


def remove_seams(state: State, left: NDArray[np.bool_], shape_rows: Integers) -> Integers:
    """Take out the rows of the shapes that are not `left`, before those go; `shape_rows` are the new rows of shapes.

    Returns the tiles that have to be joined anew then, by their new rows.
    """
    tiling, shapes = tiling_of(state), plain(state.shapes)
    going = tiling.rows[~left[tiling.rows]]
    beside = neighbours(state, going)
    gone = np.flatnonzero(~left)
    own = gone[own_seams(shapes[gone])]
    single = going[shapes["part"][going] == 0] if len(tiling.joined) > 1 else going[:0]
    if len(own) or len(single):
        _take_out(state, tiling, np.concatenate([own, single]))
        tiling.own -= int(shapes["vertex_count"][own].sum())
    tiling.rows = shape_rows[tiling.rows[left[tiling.rows]]]
    before, tiling.joined = tiling.joined, shape_rows[tiling.joined[left[tiling.joined]]]
    if len(before) > 1 and len(tiling.joined) < 2:
        _disband(state, tiling, before[left[before]], left)
    again: Integers = shape_rows[beside[left[beside]]]
    return again


def _take_out(state: State, tiling: Tiling, shapes: Integers) -> None:
    """Take out the rows of some shapes, and point the others to where theirs are then."""
    rows = plain(state.shapes)
    kept = np.ones(len(state.seams), np.bool_)
    kept[runs(rows["seam_start"][shapes], rows["vertex_count"][shapes])] = False
    places = np.append(0, np.cumsum(kept))
    state.seams = without(state.seams, kept)
    rows["seam_start"] = places[rows["seam_start"]]


def _disband(state: State, tiling: Tiling, alone: Integers, left: NDArray[np.bool_]) -> None:
    """One tile, or none, is joined to nothing."""
    state.seams = without(state.seams, np.arange(len(state.seams)) < tiling.own)
    shapes = plain(state.shapes)
    for row in alone.tolist():
        before = shapes[:row][left[:row]]
        shapes["traits"][row] &= ~SEAMED
        shapes["seam_start"][row] = before["vertex_count"][own_seams(before)].sum()


def own_seams(shapes: Records | Rows) -> NDArray[np.bool_]:
    """Which shapes have rows that came with them: parts of concave polygons, and links of chains."""
    seamed = (shapes["traits"] & SEAMED) != 0
    return np.asarray(seamed & ((shapes["part"] > 0) | (shapes["vertex_count"] < 3)))
