"""The boxes that something swept along a straight way could meet, near ones first, through the cells of the grid.

A box reaches at most half a cell out of the cell that holds its middle. So on each level the walk visits the cells
that the way meets when it is widened by half a cell and by what is swept. It goes line by line, across the longer
side of the way, and turns to the next level when a line begins past `limit`. A level of which it would visit more cells
than there are boxes is gone through directly, so that no ray costs more than looking at every box. The levels of both
parts of the grid, of what is kept and of what is loose, come one after the other.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.broad_phase.grid import bucket
from sandbox.engine.queries.boxes import ROUNDING
from sandbox.engine.queries.records import QueryGrid
from sandbox.tables import Records

_ANY_CELL = 1 << 62


class _Axis(NamedTuple):
    """A sweep and a populated region along one axis: start, translation and bounds (m), `inverse` cells per metre."""

    start: float
    translation: float
    lower: float
    upper: float
    region_lower: float
    region_upper: float
    inverse: float


@kernel
def begin_walk(
    walk: Records, question: Records, x: float, y: float, translation_x: float, translation_y: float, grow: float
) -> None:
    """Start at (x, y) and go by the translation, with the bounds of the query shape, `grow` metres wider."""
    grow = grow + ROUNDING * (abs(x) + abs(y) + abs(translation_x) + abs(translation_y) + question.extent)
    walk.x = x
    walk.y = y
    walk.translation_x = translation_x
    walk.translation_y = translation_y
    walk.limit = 1.0
    walk.lower_x = question.lower_x - grow
    walk.lower_y = question.lower_y - grow
    walk.upper_x = question.upper_x + grow
    walk.upper_y = question.upper_y + grow
    walk.first_stage = 0
    walk.end_stage = question.region_count
    walk.stage = -1
    walk.lines_left = 0
    walk.cell = 1
    walk.last_cell = 0
    walk.first = 0
    walk.end = question.sparse_count


@inlined_kernel
def stay_among_kept(walk: Records, index: Records) -> None:
    """Of what follows, a walk that begins meets only boxes that are kept."""
    walk.end = index.kept_sparse
    walk.end_stage = index.kept_regions


@inlined_kernel
def stay_among_loose(walk: Records, index: Records) -> None:
    """Of what follows, a walk that begins meets only boxes that are loose."""
    walk.first = index.kept_sparse
    walk.first_stage = index.kept_regions


@kernel
def next_box(walk: Records, grid: QueryGrid) -> int:
    """Row in `grid.ordered` of the next box that the sweep meets, each once; -1 when there is none left."""
    ordered, sparse = grid.ordered, grid.sparse
    while True:
        end = walk.end
        for i in range(walk.first, end):
            row = sparse[i] if walk.stage < 0 else i
            if meets_sweep(walk, ordered[row]) and (walk.stage < 0 or _in_found_cells(walk, ordered[row])):
                walk.first = i + 1
                return row
        if not _find_run(walk, grid):
            return -1


@inlined_kernel
def meets_sweep(walk: Records, box: Records) -> bool:
    """The separating-axis test of a box and the part of the way within `limit`: along x, y, and across the way."""
    low_x = box.lower_x - walk.upper_x - walk.x
    low_y = box.lower_y - walk.upper_y - walk.y
    high_x = box.upper_x - walk.lower_x - walk.x
    high_y = box.upper_y - walk.lower_y - walk.y
    end_x = walk.limit * walk.translation_x
    end_y = walk.limit * walk.translation_y
    apart_x = ((end_x if end_x < 0.0 else 0.0) > high_x) | ((end_x if end_x > 0.0 else 0.0) < low_x)
    apart_y = ((end_y if end_y < 0.0 else 0.0) > high_y) | ((end_y if end_y > 0.0 else 0.0) < low_y)
    side = abs(walk.translation_x * (low_y + high_y) - walk.translation_y * (low_x + high_x))
    reach = abs(walk.translation_x) * (high_y - low_y) + abs(walk.translation_y) * (high_x - low_x)
    return bool(not (apart_x | apart_y | (side > reach)))


@inlined_kernel
def _in_found_cells(walk: Records, box: Records) -> bool:
    """Whether a box lies in the cells that were looked up: other cells may share their buckets."""
    in_x = (box.cell_x >= walk.low_x) & (box.cell_x <= walk.high_x)
    in_y = (box.cell_y >= walk.low_y) & (box.cell_y <= walk.high_y)
    return bool(in_x & in_y & (box.level == walk.level))


@kernel
def _find_run(walk: Records, grid: QueryGrid) -> bool:
    """Find the next run of boxes to look at: of a cell, of cells in a row, or all; False when the walk is over."""
    regions = grid.regions
    while walk.cell > walk.last_cell:
        if walk.lines_left == 0:
            walk.stage = walk.first_stage if walk.stage < walk.first_stage else walk.stage + 1
        stage: Any = walk.stage
        if stage >= walk.end_stage:
            return False
        region: Any = regions[stage]
        if walk.lines_left > 0:
            _begin_line(walk, region)
        elif _begin_region(walk, region):
            walk.first = region.first_box
            walk.end = region.first_box + region.boxes
            return True
    _look_up(walk, grid, regions[int(walk.stage)])
    return True


@kernel
def _begin_region(walk: Records, region: Records) -> bool:
    """Plan the lines of a level; True when its boxes shall be gone through directly."""
    inverse = region.cells_per_metre
    walk.level = region.level
    high = (walk.upper_y - walk.lower_y) * inverse
    walk.by_columns = 1 if abs(walk.translation_x) > abs(walk.translation_y) and high < 2.0 else 0
    axis = _along_x(walk, region) if walk.by_columns == 1 else _along_y(walk, region)
    first, last = _cells(axis, walk.limit)
    walk.turn = 1 if axis.translation >= 0.0 else -1
    walk.line = first if walk.turn > 0 else last
    walk.lines_left = last - first + 1
    if walk.lines_left <= region.count:
        return False
    walk.lines_left = 0
    walk.low_x = -_ANY_CELL
    walk.low_y = -_ANY_CELL
    walk.high_x = _ANY_CELL
    walk.high_y = _ANY_CELL
    return True


@kernel
def _along_x(walk: Records, region: Records) -> _Axis:
    """The sweep and the region along x."""
    return _Axis(
        walk.x, walk.translation_x, walk.lower_x, walk.upper_x, region.lower_x, region.upper_x, region.cells_per_metre
    )


@kernel
def _along_y(walk: Records, region: Records) -> _Axis:
    """The sweep and the region along y."""
    return _Axis(
        walk.y, walk.translation_y, walk.lower_y, walk.upper_y, region.lower_y, region.upper_y, region.cells_per_metre
    )


@kernel
def _cells(axis: _Axis, limit: float) -> tuple[int, int]:
    """First and last line of cells along one axis that the sweep meets within the region; last < first if none."""
    end = limit * axis.translation
    low = (axis.start + (end if end < 0.0 else 0.0) + axis.lower) * axis.inverse - 0.5
    high = (axis.start + (end if end > 0.0 else 0.0) + axis.upper) * axis.inverse + 0.5
    return _clipped(low, high, axis.region_lower * axis.inverse, axis.region_upper * axis.inverse)


@kernel
def _clipped(low: float, high: float, least: float, most: float) -> tuple[int, int]:
    """Cells from `low` to `high`, but only where the level has boxes."""
    low = low if low > least else least
    high = high if high < most else most
    if low > high:
        return 1, 0
    return math.floor(low), math.floor(high)


@kernel
def _begin_line(walk: Records, region: Records) -> None:
    """Find the cells of the next line."""
    if walk.by_columns == 1:
        begin, end = _fractions(walk, _along_x(walk, region))
        _span(walk, begin, end, _along_y(walk, region))
        walk.low_x = walk.line
        walk.high_x = walk.line
    else:
        begin, end = _fractions(walk, _along_y(walk, region))
        _span(walk, begin, end, _along_x(walk, region))
        walk.low_y = walk.line
        walk.high_y = walk.line
    walk.line += walk.turn
    walk.lines_left -= 1
    if begin > walk.limit:
        walk.lines_left = 0


@kernel
def _fractions(walk: Records, axis: _Axis) -> tuple[float, float]:
    """From where to where on the way the widened sweep meets the line across an axis: fractions from 0 on."""
    inverse = axis.inverse
    speed = axis.translation * inverse
    if speed == 0.0:
        return 0.0, 1.0
    near = walk.line if axis.translation > 0.0 else walk.line + 1
    ahead = axis.upper * inverse + 0.5 if axis.translation > 0.0 else axis.lower * inverse - 0.5
    behind = axis.lower * inverse - 0.5 if axis.translation > 0.0 else axis.upper * inverse + 0.5
    begin = (near - ahead - axis.start * inverse) / speed
    end = (near + walk.turn - behind - axis.start * inverse) / speed
    return begin if begin > 0.0 else 0.0, end if end > 0.0 else 0.0


@kernel
def _span(walk: Records, begin: float, end: float, axis: _Axis) -> None:
    """Cells of a line along an axis between two fractions of the way, none if it begins past the limit."""
    inverse = axis.inverse
    walk.cell = 1
    walk.last_cell = 0
    if begin > walk.limit:
        return
    at_begin = axis.start + begin * axis.translation
    at_end = axis.start + (end if end < walk.limit else walk.limit) * axis.translation
    low = at_begin if at_begin < at_end else at_end
    high = at_begin if at_begin > at_end else at_end
    low = (low + axis.lower) * inverse - 0.5
    high = (high + axis.upper) * inverse + 0.5
    first, last = _clipped(low, high, axis.region_lower * inverse, axis.region_upper * inverse)
    walk.cell = first
    walk.last_cell = last


@kernel
def _look_up(walk: Records, grid: QueryGrid, region: Records) -> None:
    """The run of boxes in the next cell of a column, or in the cells of a row: their buckets are neighbours."""
    heads: Any = grid.heads[region.first_head : region.first_head + region.heads]
    if walk.by_columns == 1:
        k = bucket(walk.low_x, walk.cell, walk.level, heads)
        walk.low_y = walk.cell
        walk.high_y = walk.cell
        count = 1
    else:
        k = bucket(walk.cell, walk.low_y, walk.level, heads)
        room = heads.shape[0] - 1 - k
        count = walk.last_cell - walk.cell + 1
        count = count if count < room else room
        walk.low_x = walk.cell
        walk.high_x = walk.cell + count - 1
    walk.first = region.first_box + heads[k]
    walk.end = region.first_box + heads[k + count]
    walk.cell += count
