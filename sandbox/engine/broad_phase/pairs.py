"""Stage: the uniform grid (`grid.py`) proposes pairs."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.broad_phase.grid import (
    LEVELS,
    LOWEST,
    base_cell,
    boxes_overlap,
    bucket,
    cells_per_metre,
    fill_grid,
    first_cell,
    last_cell,
)
from sandbox.engine.broad_phase.proxies import ACTIVE, DRIVEN, SLEEPS
from sandbox.tables import Integers, Records

_FEW = 4
"""Pairs are sorted by themselves where there are more than so many shapes for each."""


class Window(NamedTuple):
    """A part of the plane (m)."""

    lower_x: float
    lower_y: float
    upper_x: float
    upper_y: float


class Cells(NamedTuple):
    """Cells of a level that lie side by side in a row, from `first` to `last`."""

    first: int
    last: int
    row: int
    level: int


@kernel
def find_pairs(
    boxes: Records,
    filters: Records,
    ordered: Records,
    heads: Integers,
    levels: Integers,
    grid_info: Records,
    pairs: Records,
) -> int:
    """Lay boxes into the grid and write every pair of them that overlaps and may collide, each once, shape_a < shape_b;
    return how many.

    Pairs past the capacity of `pairs` are counted but not written. `ordered`, `heads` and `levels` (`LEVEL_SPACE`
    items) get the grid, `grid_info` (one row) what is known of it. The order of the pairs follows the grid: see
    `sort_pairs`.
    """
    sparse = levels[2 * LEVELS :]
    base = base_cell(boxes, levels)
    used, sparse_count = fill_grid(boxes, base, LOWEST, ordered, heads, levels)
    info = grid_info[0]
    info.cell = base
    info.used = used
    info.sparse = sparse_count
    count = 0
    for i in range(ordered.shape[0]):
        count = _pairs_on_own_level(ordered, filters, i, heads, pairs, count)
        count = _pairs_on_sparse_levels(ordered, filters, i, sparse, sparse_count, pairs, count)
    for k in range(used):
        inverse = cells_per_metre(base, levels[k])
        for i in range(ordered.shape[0]):
            if levels[k] > ordered[i].level:
                box = ordered[i]
                window = Window(box.lower_x, box.lower_y, box.upper_x, box.upper_y)
                count = pairs_on_level(box, window, ordered, filters, inverse, levels[k], heads, pairs, count)
    return count


@kernel
def _pairs_on_own_level(ordered: Records, filters: Records, i: int, heads: Integers, pairs: Records, count: int) -> int:
    """Pairs of box i with later boxes of its own cell and with half of the neighbour cells."""
    box = ordered[i]
    x = box.cell_x
    y = box.cell_y
    beside = Cells(x, x + 1, y, box.level)
    count = _pairs_in_cells(box, ordered, filters, beside, heads, i + 1, pairs, count)
    above = Cells(x - 1, x + 1, y + 1, box.level)
    return _pairs_in_cells(box, ordered, filters, above, heads, 0, pairs, count)


@kernel
def _pairs_on_sparse_levels(
    ordered: Records, filters: Records, i: int, sparse: Integers, sparse_count: int, pairs: Records, count: int
) -> int:
    """Pairs of box i with the boxes of coarser levels that hold few boxes."""
    box = ordered[i]
    for k in range(sparse_count):
        other = ordered[sparse[k]]
        if other.level > box.level and boxes_overlap(box, other):
            count = propose(filters, box.shape_index, other.shape_index, pairs, count)
    return count


@kernel
def pairs_on_level(
    box: Records,
    window: Window,
    ordered: Records,
    filters: Records,
    inverse: float,
    level: int,
    heads: Integers,
    pairs: Records,
    count: int,
) -> int:
    """Pairs of a box with the boxes of another level, which has `inverse` cells a metre, as far as they overlap in a
    window: their middles are at most half a cell outside of it."""
    first_x = first_cell(window.lower_x, inverse)
    last_x = last_cell(window.upper_x, inverse)
    for y in range(first_cell(window.lower_y, inverse), last_cell(window.upper_y, inverse) + 1):
        count = _pairs_in_cells(box, ordered, filters, Cells(first_x, last_x, y, level), heads, 0, pairs, count)
    return count


@inlined_kernel
def _pairs_in_cells(
    box: Records,
    ordered: Records,
    filters: Records,
    cells: Cells,
    heads: Integers,
    start: int,
    pairs: Records,
    count: int,
) -> int:
    """Pairs of a box with the boxes of cells in a row, in the first one only with those from `ordered[start]` on.

    Their buckets lie side by side as well, but that the first one of all follows the last one. Other cells may share
    them.
    """
    buckets = heads.shape[0] - 1
    first = bucket(cells.first, cells.row, cells.level, heads)
    end = first + cells.last - cells.first + 1
    if end - first >= buckets:
        first = 0
        end = buckets
    i = heads[first]
    i = i if i > start else start
    stop = heads[end if end < buckets else buckets]
    while True:
        for j in range(i, stop):
            other = ordered[j]
            if (
                boxes_overlap(box, other)
                and other.cell_y == cells.row
                and other.level == cells.level
                and cells.first <= other.cell_x <= cells.last
            ):
                count = propose(filters, box.shape_index, other.shape_index, pairs, count)
        if end <= buckets:
            return count
        end -= buckets
        i = 0
        stop = heads[end]


@kernel
def propose(filters: Records, i: int, j: int, pairs: Records, count: int) -> int:
    """Append the pair of shapes i and j, if they may collide and it matters; return the new count.

    It matters if one of them is active, or if one sleeps and the other is driven into it.
    """
    a = filters[i]
    b = filters[j]
    moves = a.moves | b.moves
    if a.body == b.body or not ((moves & ACTIVE) != 0 or moves == SLEEPS | DRIVEN):
        return count
    if not may_collide(a.category, a.mask, a.group, b.category, b.mask, b.group):
        return count
    if count < pairs.shape[0]:
        pairs[count].shape_a = i if i < j else j
        pairs[count].shape_b = j if i < j else i
    return count + 1


@kernel
def may_collide(category_a: int, mask_a: int, group_a: int, category_b: int, mask_b: int, group_b: int) -> bool:
    """Collision filter: a shared group decides by its sign; otherwise each mask must accept the other's category."""
    if group_a == group_b and group_a != 0:
        return group_a > 0
    return (category_a & mask_b) != 0 and (category_b & mask_a) != 0


@kernel
def sort_pairs(pairs: Records, count: int, buffer: Records, heads: Integers, shapes: int) -> None:
    """Sort `pairs[:count]` by (shape_a, shape_b): two stable counting passes. `heads` needs `shapes + 1` items.

    A few pairs among many shapes are sorted by themselves: counting goes through all shapes four times.
    """
    if _FEW * count < shapes:
        sort_few_pairs(pairs, count)
        return
    for turn in range(2):
        if turn == 0:
            _counting_pass(pairs, count, buffer, heads, shapes, turn == 1)
        else:
            _counting_pass(buffer, count, pairs, heads, shapes, turn == 1)


@kernel
def sort_few_pairs(pairs: Records, count: int) -> None:
    """Sort pairs by (shape_a, shape_b): Shell's method with Knuth's gaps (The Art of Computer Programming 3, 5.2.1)."""
    gap = 1
    while 3 * gap + 1 < count:
        gap = 3 * gap + 1
    while gap > 0:
        for n in range(gap, count):
            a = pairs[n].shape_a
            b = pairs[n].shape_b
            k = n - gap
            while k >= 0 and not comes_before(pairs[k], a, b):
                pairs[k + gap] = pairs[k]
                k -= gap
            pairs[k + gap].shape_a = a
            pairs[k + gap].shape_b = b
        gap //= 3


@inlined_kernel
def comes_before(pair: Records, shape_a: int, shape_b: int) -> bool:
    """Whether a pair, or the contact of one, has its place before another pair of shapes."""
    first = pair.shape_a
    return bool(first < shape_a or (first == shape_a and pair.shape_b < shape_b))


@kernel
def _counting_pass(source: Records, count: int, target: Records, heads: Integers, shapes: int, by_first: bool) -> None:
    for k in range(shapes + 1):
        heads[k] = 0
    for i in range(count):
        heads[source[i].shape_a if by_first else source[i].shape_b] += 1
    total = 0
    for k in range(shapes + 1):
        total += heads[k]
        heads[k] = total
    for i in range(count - 1, -1, -1):
        k = source[i].shape_a if by_first else source[i].shape_b
        heads[k] -= 1
        target[heads[k]] = source[i]
