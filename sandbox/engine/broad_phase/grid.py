"""The uniform grid: where boxes lie, so that those near a place are found without looking at all.

A box lies in exactly one cell: the one that holds its middle, on the level whose cells are wider than the box. So two
boxes overlap only if their cells, seen on the coarser of the two levels, are the same or neighbours. That keeps the
grid O(n) where a single cell size fails: dust on a huge ground (two levels), bodies scattered over a million metres
(cells are hashed, empty ones cost nothing), and a fast body with a long box (a coarser level, still one cell). Cells
are laid into buckets by counting sort; cells next to each other in a row are next to each other in memory.
"""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel, kernel
from sandbox.tables import Integers, Records

LEVELS = 96
"""Cells from 2**-40 to 2**55 times the base cell, which fits the most common size of shape."""
LOWEST = -40
SPARSE = 8
"""Levels with more boxes than this are looked into cell by cell; the boxes of the others are gone through."""
LEVEL_SPACE = (2 + SPARSE) * LEVELS
_SLACK = 1.01
_ROUNDING = 1e-14
_CELL_BITS = (1 << 26) - 1
_ROW_STRIDE = 40503001
_LEVEL_STRIDE = 9973


@kernel
def fill_grid(
    boxes: Records, base: float, finest: int, ordered: Records, heads: Integers, levels: Integers
) -> tuple[int, int]:
    """Lay `boxes` into cells: (levels with many boxes, boxes on the others).

    `base` is the width of the cells of level 0 in metres, `finest` the lowest level in use. `ordered` gets the boxes
    bucket by bucket: bucket k is `ordered[heads[k] : heads[k + 1]]`. `levels` (`LEVEL_SPACE` items) gets the levels
    with many boxes, ascending; from `2 * LEVELS` on, the rows in `ordered` of the boxes on levels with few.
    """
    population = levels[LEVELS : 2 * LEVELS]
    used = _assign_cells(boxes, base, finest, population, levels, heads)
    _order_by_bucket(boxes, ordered, heads)
    return used, _list_sparse_levels(ordered, population, levels[2 * LEVELS :])


@kernel
def _box_size(box: Records) -> float:
    """Longer side of a box and a little more: the slack covers the rounding of the middle far from the origin."""
    width = box.upper_x - box.lower_x
    height = box.upper_y - box.lower_y
    reach = abs(box.lower_x) + abs(box.upper_x) + abs(box.lower_y) + abs(box.upper_y)
    return float((width if width > height else height) * _SLACK + _ROUNDING * reach)


@kernel
def octave(size: float) -> int:
    """Smallest n with size < 2**n, within the range of levels."""
    n = math.frexp(size)[1]
    n = n if n > LOWEST else LOWEST
    return n if n < LOWEST + LEVELS - 1 else LOWEST + LEVELS - 1


@kernel
def base_cell(boxes: Records, levels: Integers) -> float:
    """Width of the cells of level 0 in metres: it just fits all boxes of the octave in which most boxes lie, and those
    of the next one if there are many."""
    population = levels[LEVELS : 2 * LEVELS]
    largest = levels[2 * LEVELS : 3 * LEVELS]
    for k in range(LEVELS):
        population[k] = 0
    low = 0.0
    high = 0.0
    top = 0.0
    k = 0
    for i in range(boxes.shape[0]):
        size = _box_size(boxes[i])
        if not low <= size < high:  # most are in the octave of the one before
            n = octave(size)
            low = math.ldexp(0.5, n)
            high = 2.0 * low if LOWEST < n < LOWEST + LEVELS - 1 else 0.0
            k = n - LOWEST
            top = _box_size(boxes[largest[k]]) if population[k] > 0 else 0.0
        if population[k] == 0 or size > top:
            top = size
            largest[k] = i
        population[k] += 1
    most = 0
    for k in range(LEVELS):
        most = k if population[k] > population[most] else most
    if most + 1 < LEVELS and population[most + 1] > SPARSE:
        most += 1
    base = _box_size(boxes[largest[most]]) if population[most] > 0 else 0.0
    return base if base > 0.0 else 1.0


@inlined_kernel
def box_level(box: Records, base: float) -> int:
    """Lowest level whose cells are wider than a box. Level 0 has those of the level below as well: to look into a few
    fuller cells is cheaper than to ask one more level."""
    ratio = _box_size(box) / base
    return 0 if 0.25 < ratio <= 1.0 else octave(ratio)


@inlined_kernel
def place(box: Records, level: int, inverse: float) -> None:
    """Give a box its cell on a level with `inverse` cells a metre."""
    box.level = level
    box.cell_x = math.floor(0.5 * (box.lower_x + box.upper_x) * inverse)
    box.cell_y = math.floor(0.5 * (box.lower_y + box.upper_y) * inverse)


@inlined_kernel
def first_cell(lower: float, inverse: float) -> int:
    """The first cell along an axis, on a level with `inverse` cells a metre, that may hold the middle of a box which
    reaches as far as `lower` (m): middles are at most half a cell outside of what they overlap."""
    return math.floor(lower * inverse - 0.5)


@inlined_kernel
def last_cell(upper: float, inverse: float) -> int:
    """The last such cell, for `upper` (m)."""
    return math.floor(upper * inverse + 0.5)


@kernel
def _assign_cells(
    boxes: Records, base: float, finest: int, population: Integers, levels: Integers, heads: Integers
) -> int:
    """Give every box its level and cell, and count those of each bucket in `heads`; list in `levels` the levels with
    many boxes, ascending, and return how many."""
    for k in range(LEVELS):
        population[k] = 0
    for k in range(heads.shape[0]):
        heads[k] = 0
    inverse = 0.0
    known = LOWEST - 1
    for i in range(boxes.shape[0]):
        box = boxes[i]
        level = box_level(box, base)
        level = level if level > finest else finest
        if level != known:
            known = level
            inverse = cells_per_metre(base, level)
        place(box, level, inverse)
        population[level - LOWEST] += 1
        heads[bucket(box.cell_x, box.cell_y, level, heads)] += 1
    used = 0
    for k in range(LEVELS):
        if population[k] > SPARSE:
            levels[used] = k + LOWEST
            used += 1
    return used


@kernel
def _list_sparse_levels(ordered: Records, population: Integers, sparse: Integers) -> int:
    """List the boxes of levels with few boxes: to go through them all is cheaper than to look into cells."""
    count = 0
    for i in range(ordered.shape[0]):
        if population[ordered[i].level - LOWEST] <= SPARSE:
            sparse[count] = i
            count += 1
    return count


@inlined_kernel
def cells_per_metre(base: float, level: int) -> float:
    return math.ldexp(1.0, -int(level)) / base


@inlined_kernel
def bucket(cell_x: int, cell_y: int, level: int, heads: Integers) -> int:
    """Bucket of a cell; the row is kept contiguous, rows and levels are spread."""
    row = (cell_y & _CELL_BITS) * _ROW_STRIDE
    return int(((cell_x & _CELL_BITS) + row + level * _LEVEL_STRIDE) & (heads.shape[0] - 2))


@kernel
def _order_by_bucket(boxes: Records, ordered: Records, heads: Integers) -> None:
    """Counting sort: bucket k is `ordered[heads[k]:heads[k + 1]]`, in the order of the shapes. `heads` has counts."""
    total = 0
    for k in range(heads.shape[0]):
        total += heads[k]
        heads[k] = total
    for i in range(boxes.shape[0] - 1, -1, -1):
        box = boxes[i]
        k = bucket(box.cell_x, box.cell_y, box.level, heads)
        heads[k] -= 1
        ordered[heads[k]] = box


@inlined_kernel
def boxes_overlap(a: Records, b: Records) -> bool:
    """Whether two boxes share a point: the widest gap between them is none. One branch for all bounds: each alone
    would be a coin toss to the processor."""
    gap_x = _larger(a.lower_x - b.upper_x, b.lower_x - a.upper_x)
    gap_y = _larger(a.lower_y - b.upper_y, b.lower_y - a.upper_y)
    return bool(_larger(gap_x, gap_y) <= 0.0)


@inlined_kernel
def _larger(one: float, other: float) -> float:
    return one if one > other else other


@kernel
def head_count(shapes: int) -> int:
    """Buckets of the grid: a power of two, about two a shape, and one more to close the last."""
    buckets = 128
    while buckets < 2 * shapes:
        buckets *= 2
    return buckets + 1
