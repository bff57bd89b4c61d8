"""The seam table as rows come and go: laid out as in a world that is built from nothing.

First the rows that shapes came with, in the order of the shapes, then those of tiles. Shapes without any point at what
those before them came with.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sandbox.tables import Integers, Records, extended, plain, without
from sandbox.world.flush import find_tiles
from sandbox.world.new_rows import NewRows
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
    alone = tiling.joined.copy() if len(tiling.joined) == 1 else tiling.joined[:0]
    if len(single) and len(tiling.joined) + len(single) > 1:
        counts = np.concatenate([known["vertex_count"][alone], counts])
        starts = len(state.seams) + run_starts(counts)
        state.seams = extended(state.seams, plain(SEAM.zeros(int(counts.sum()))))
        known["seam_start"][alone], shapes["seam_start"][single] = starts[: len(alone)], starts[len(alone) :]
    tiling.add(first + fresh, first + single)
    return np.concatenate([alone, first + fresh])


def _insert(state: State, tiling: Tiling, seams: Rows) -> None:
    """Put rows that shapes come with before those of the tiles."""
    behind = plain(state.seams)[tiling.own :].copy()
    state.seams = extended(state.seams, seams)
    rows, tiling.own = plain(state.seams), tiling.own + len(seams)
    rows[tiling.own - len(seams) : tiling.own], rows[tiling.own :] = seams, behind
    if len(behind):
        plain(state.shapes)["seam_start"][tiling.joined] += len(seams)


def remove_seams(state: State, rows: NewRows) -> Integers:
    """Take out the rows of the shapes that are not left, before those go; `rows` are the new ones of shapes.

    Returns the tiles that have to be joined anew then, by their new rows.
    """
    tiling, shapes = tiling_of(state), plain(state.shapes)
    going = tiling.going(rows)
    beside = neighbours(state, going)
    gone = rows.first + np.flatnonzero(~rows.left)
    own = gone[own_seams(shapes[gone])]
    single = going[shapes["part"][going] == 0] if len(tiling.joined) > 1 else going[:0]
    if len(own) or len(single):
        _take_out(state, own, single)
        tiling.own -= int(shapes["vertex_count"][own].sum())
    before = tiling.joined[rows[tiling.joined] >= 0] if len(single) else tiling.joined
    tiling.remove(rows)
    if len(single) and len(tiling.joined) < 2:
        _disband(state, tiling, before, rows)
    again: Integers = rows[beside]
    return again[again >= 0]


def _take_out(state: State, own: Integers, single: Integers) -> None:
    """Take out the rows of some shapes that came with theirs, and of some tiles; point the others to where theirs are
    then."""
    going = np.concatenate([own, single])
    shapes = plain(state.shapes)[0 if len(own) else going.min() :]  # no shape before a tile has rows behind its own
    places = runs(plain(state.shapes)["seam_start"][going], plain(state.shapes)["vertex_count"][going])
    first = int(places.min())
    kept = np.ones(len(state.seams) - first, np.bool_)
    kept[places - first] = False
    state.seams = without(state.seams, kept, first)
    moved = np.flatnonzero(shapes["seam_start"] > first)
    shapes["seam_start"][moved] = (first + np.append(0, np.cumsum(kept)))[shapes["seam_start"][moved] - first]


def _disband(state: State, tiling: Tiling, alone: Integers, rows: NewRows) -> None:
    """One tile, or none, is joined to nothing."""
    state.seams = without(state.seams, np.arange(len(state.seams)) < tiling.own)
    shapes = plain(state.shapes)
    left = rows[np.arange(len(rows))] >= 0
    for row in alone.tolist():
        before = shapes[:row][left[:row]]
        shapes["traits"][row] &= ~SEAMED
        shapes["seam_start"][row] = before["vertex_count"][own_seams(before)].sum()


def own_seams(shapes: Records | Rows) -> NDArray[np.bool_]:
    """Which shapes have rows that came with them: parts of concave polygons, and links of chains."""
    seamed = (shapes["traits"] & SEAMED) != 0
    return np.asarray(seamed & ((shapes["part"] > 0) | (shapes["vertex_count"] < 3)))
