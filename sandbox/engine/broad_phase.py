"""Stage: the uniform grid proposes pairs.

A shape lies in exactly one cell: the one that holds the middle of its box, on the level whose cells are wider than
the box. So two boxes overlap only if their cells, seen on the coarser of the two levels, are the same or neighbours.
That keeps the grid O(n) where a single cell size fails: dust on a huge ground (two levels), bodies scattered over a
million metres (cells are hashed, empty ones cost nothing), and a fast body with a long box (a coarser level, still
one cell). Cells are laid into buckets by counting sort; cells next to each other in a row are next to each other in
memory.
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.world.records import Integers, Records

LEVELS = 96
"""Cells from 2**-40 m (below the smallest shape) to 2**55 m."""
_LOWEST = -40
_SLACK = 1.01
_ROUNDING = 1e-14
_CELL_BITS = (1 << 26) - 1
_ROW_STRIDE = 40503001
_LEVEL_STRIDE = 9973


@kernel
def find_pairs(boxes: Records, ordered: Records, heads: Integers, levels: Integers, pairs: Records) -> int:
    """Write every pair of overlapping boxes that may collide, each once, shape_a < shape_b; return how many.

    Pairs past the capacity of `pairs` are counted but not written. `ordered`, `heads` and `levels` are scratch.
    The order of the pairs follows the grid: see `sort_pairs`.
    """
    used = _assign_cells(boxes, levels)
    _order_by_bucket(boxes, ordered, heads)
    count = 0
    for i in range(ordered.shape[0]):
        count = _pairs_on_own_level(ordered, i, heads, pairs, count)
        for k in range(used):
            if levels[k] > ordered[i].level:
                count = _pairs_on_coarser_level(ordered, i, levels[k], heads, pairs, count)
    return count


@kernel
def _assign_cells(boxes: Records, levels: Integers) -> int:
    """Give every box its level and cell; list the levels in use in `levels`, ascending, and return how many."""
    for k in range(LEVELS):
        levels[k] = 0
    for i in range(boxes.shape[0]):
        box = boxes[i]
        width = box.upper_x - box.lower_x
        height = box.upper_y - box.lower_y
        x = 0.5 * (box.lower_x + box.upper_x)
        y = 0.5 * (box.lower_y + box.upper_y)
        # The slack covers the rounding of the middle, which grows with the distance from the origin.
        size = (width if width > height else height) * _SLACK + _ROUNDING * (abs(x) + abs(y))
        level = math.frexp(size)[1]
        level = level if level > _LOWEST else _LOWEST
        level = level if level < _LOWEST + LEVELS - 1 else _LOWEST + LEVELS - 1
        inverse = math.ldexp(1.0, -int(level))
        box.level = level
        box.cell_x = math.floor(x * inverse)
        box.cell_y = math.floor(y * inverse)
        levels[level - _LOWEST] = 1
    used = 0
    for k in range(LEVELS):
        if levels[k] == 1:
            levels[used] = k + _LOWEST
            used += 1
    return used


@kernel
def _bucket(cell_x: int, cell_y: int, level: int, heads: Integers) -> int:
    """Bucket of a cell; the row is kept contiguous, rows and levels are spread."""
    row = (cell_y & _CELL_BITS) * _ROW_STRIDE
    return int(((cell_x & _CELL_BITS) + row + level * _LEVEL_STRIDE) & (heads.shape[0] - 2))


@kernel
def _order_by_bucket(boxes: Records, ordered: Records, heads: Integers) -> None:
    """Counting sort: bucket k is `ordered[heads[k]:heads[k + 1]]`, in the order of the shapes."""
    for k in range(heads.shape[0]):
        heads[k] = 0
    for i in range(boxes.shape[0]):
        box = boxes[i]
        heads[_bucket(box.cell_x, box.cell_y, box.level, heads)] += 1
    total = 0
    for k in range(heads.shape[0]):
        total += heads[k]
        heads[k] = total
    for i in range(boxes.shape[0] - 1, -1, -1):
        box = boxes[i]
        k = _bucket(box.cell_x, box.cell_y, box.level, heads)
        heads[k] -= 1
        ordered[heads[k]] = box


@kernel
def _pairs_on_own_level(ordered: Records, i: int, heads: Integers, pairs: Records, count: int) -> int:
    """Pairs of box i with later boxes of its own cell and with half of the neighbour cells."""
    box = ordered[i]
    x = box.cell_x
    y = box.cell_y
    level = box.level
    own = _bucket(x, y, level, heads)
    count = _pairs_in_cell(ordered, i, i + 1, heads[own + 1], x, y, level, pairs, count)
    for step_x, step_y in ((1, 0), (-1, 1), (0, 1), (1, 1)):
        k = _bucket(x + step_x, y + step_y, level, heads)
        count = _pairs_in_cell(ordered, i, heads[k], heads[k + 1], x + step_x, y + step_y, level, pairs, count)
    return count


@kernel
def _pairs_on_coarser_level(ordered: Records, i: int, level: int, heads: Integers, pairs: Records, count: int) -> int:
    """Pairs of box i with the boxes of a coarser level: their middles are at most half a cell outside of it."""
    box = ordered[i]
    inverse = math.ldexp(1.0, -int(level))
    first_x = math.floor(box.lower_x * inverse - 0.5)
    first_y = math.floor(box.lower_y * inverse - 0.5)
    last_x = math.floor(box.upper_x * inverse + 0.5)
    last_y = math.floor(box.upper_y * inverse + 0.5)
    for y in range(first_y, last_y + 1):
        for x in range(first_x, last_x + 1):
            k = _bucket(x, y, level, heads)
            count = _pairs_in_cell(ordered, i, heads[k], heads[k + 1], x, y, level, pairs, count)
    return count


@kernel
def _pairs_in_cell(
    ordered: Records, i: int, first: int, end: int, x: int, y: int, level: int, pairs: Records, count: int
) -> int:
    """Pairs of box i with the boxes of one cell within `ordered[first:end]`; other cells may share the bucket."""
    box = ordered[i]
    for j in range(first, end):
        other = ordered[j]
        # One branch for the four bounds: each alone would be a coin toss to the processor.
        apart_x = (box.lower_x > other.upper_x) | (other.lower_x > box.upper_x)
        if apart_x | (box.lower_y > other.upper_y) | (other.lower_y > box.upper_y):
            continue
        if other.cell_x != x or other.cell_y != y or other.level != level:
            continue
        if box.moves + other.moves == 0 or box.body == other.body:
            continue
        if not may_collide(box.category, box.mask, box.group, other.category, other.mask, other.group):
            continue
        if count < pairs.shape[0]:
            pair = pairs[count]
            first_shape = box.shape_index < other.shape_index
            pair.shape_a = box.shape_index if first_shape else other.shape_index
            pair.shape_b = other.shape_index if first_shape else box.shape_index
        count += 1
    return count


@kernel
def may_collide(category_a: int, mask_a: int, group_a: int, category_b: int, mask_b: int, group_b: int) -> bool:
    """Collision filter: a shared group decides by its sign; otherwise each mask must accept the other's category."""
    if group_a == group_b and group_a != 0:
        return group_a > 0
    return (category_a & mask_b) != 0 and (category_b & mask_a) != 0


@kernel
def sort_pairs(pairs: Records, count: int, buffer: Records, heads: Integers, shapes: int) -> None:
    """Sort `pairs[:count]` by (shape_a, shape_b): two stable counting passes. `heads` needs `shapes + 1` items."""
    _counting_pass(pairs, count, buffer, heads, shapes, False)
    _counting_pass(buffer, count, pairs, heads, shapes, True)


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
