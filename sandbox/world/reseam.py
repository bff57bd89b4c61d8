"""The seam table as rows come and go: laid out as in a world that is built from nothing.

First the rows that shapes came with, in the order of the shapes, then those of tiles. Shapes without any point at what
those before them came with.
"""

from __future__ import annotations

import numpy as np

from sandbox.tables import Integers, extended, plain, without
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
    shapes["seam_start"][single] = len(state.seams) + run_starts(counts)
    state.seams = extended(state.seams, plain(SEAM.zeros(int(counts.sum()))))
    tiling.add(first + fresh, first + single)
    return first + fresh


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
    own = _own_seams(tiling, shapes, gone)
    single = going[shapes["part"][going] == 0]
    if len(own) or len(single):
        _take_out(state, own, single)
        tiling.own -= int(shapes["vertex_count"][own].sum())
    tiling.remove(rows)
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


def _own_seams(tiling: Tiling, shapes: Rows, rows: Integers) -> Integers:
    """Those of some shapes that have rows that came with them: parts of concave polygons, links of chains, and what
    abuts others in a body that moves."""
    seamed = rows[(shapes["traits"][rows] & SEAMED) != 0]
    first, end = (np.searchsorted(tiling.joined, seamed, side) for side in ("left", "right"))
    own: Integers = seamed[first == end]
    return own
