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

from sandbox._jit import ZERO, inlined_kernel, kernel
from sandbox.engine.bounds import ACTIVE, DRIVEN, SLEEPS
from sandbox.tables import Integers, Records

LEVELS = 96
"""Cells from 2**-40 to 2**55 times the base cell, which fits the most common size of shape."""
_LOWEST = -40
_SPARSE = 8
LEVEL_SPACE = (2 + _SPARSE) * LEVELS
_SLACK = 1.01
_ROUNDING = 1e-14
_CELL_BITS = (1 << 26) - 1
_ROW_STRIDE = 40503001
_LEVEL_STRIDE = 9973


@kernel
def find_pairs(
    boxes: Records, owners: Records, ordered: Records, heads: Integers, levels: Integers, pairs: Records
) -> int:
    """Write every pair of overlapping boxes that may collide, each once, shape_a < shape_b; return how many.

    Pairs past the capacity of `pairs` are counted but not written. `ordered`, `heads` and `levels` (`LEVEL_SPACE`
    items) are scratch. The order of the pairs follows the grid: see `sort_pairs`.
    """
    population = levels[LEVELS : 2 * LEVELS]
    sparse = levels[2 * LEVELS :]
    base = _base_cell(boxes, population)
    used = _assign_cells(boxes, base, population, levels)
    _order_by_bucket(boxes, ordered, heads)
    sparse_count = _list_sparse_levels(ordered, population, sparse)
    count = ZERO
    for i in range(ordered.shape[0]):
        count = _pairs_on_own_level(ordered, owners, i, heads, pairs, count)
        count = _pairs_on_sparse_levels(ordered, owners, i, sparse, sparse_count, pairs, count)
        for k in range(used):
            if levels[k] > ordered[i].level:
                count = _pairs_on_coarser_level(ordered, owners, i, base, levels[k], heads, pairs, count)
    return count


@kernel
def _box_size(box: Records) -> float:
    """Longer side of a box and a little more: the slack covers the rounding of the middle far from the origin."""
    width = box.upper_x - box.lower_x
    height = box.upper_y - box.lower_y
    reach = abs(box.lower_x) + abs(box.upper_x) + abs(box.lower_y) + abs(box.upper_y)
    return float((width if width > height else height) * _SLACK + _ROUNDING * reach)


@kernel
def _octave(size: float) -> int:
    """Smallest n with size < 2**n, within the range of levels."""
    n = math.frexp(size)[1]
    n = n if n > _LOWEST else _LOWEST
    return n if n < _LOWEST + LEVELS - 1 else _LOWEST + LEVELS - 1


@kernel
def _base_cell(boxes: Records, population: Integers) -> float:
    """Width of the cells of level 0 in metres: it just fits all boxes of the octave in which most boxes lie."""
    for k in range(LEVELS):
        population[k] = 0
    for i in range(boxes.shape[0]):
        population[_octave(_box_size(boxes[i])) - _LOWEST] += 1
    most = 0
    for k in range(LEVELS):
        most = k if population[k] > population[most] else most
    base = 0.0
    for i in range(boxes.shape[0]):
        size = _box_size(boxes[i])
        if size > base and _octave(size) - _LOWEST == most:
            base = size
    return base if base > 0.0 else 1.0


@kernel
def _assign_cells(boxes: Records, base: float, population: Integers, levels: Integers) -> int:
    """Give every box its level and cell; list in `levels` those with many boxes, ascending, and return how many."""
    for k in range(LEVELS):
        population[k] = 0
    for i in range(boxes.shape[0]):
        box = boxes[i]
        ratio = _box_size(box) / base
        level = 0 if 0.5 < ratio <= 1.0 else _octave(ratio)
        inverse = _cells_per_metre(base, level)
        box.level = level
        box.cell_x = math.floor(0.5 * (box.lower_x + box.upper_x) * inverse)
        box.cell_y = math.floor(0.5 * (box.lower_y + box.upper_y) * inverse)
        population[level - _LOWEST] += 1
    used = 0
    for k in range(LEVELS):
        if population[k] > _SPARSE:
            levels[used] = k + _LOWEST
            used += 1
    return used


@kernel
def _list_sparse_levels(ordered: Records, population: Integers, sparse: Integers) -> int:
    """List the boxes of levels with few boxes: to go through them all is cheaper than to look into cells."""
    count = 0
    for i in range(ordered.shape[0]):
        if population[ordered[i].level - _LOWEST] <= _SPARSE:
            sparse[count] = i
            count += 1
    return count


@inlined_kernel
def _cells_per_metre(base: float, level: int) -> float:
    return math.ldexp(1.0, -int(level)) / base


@inlined_kernel
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
def _pairs_on_own_level(ordered: Records, owners: Records, i: int, heads: Integers, pairs: Records, count: int) -> int:
    """Pairs of box i with later boxes of its own cell and with half of the neighbour cells."""
    box = ordered[i]
    x = box.cell_x
    y = box.cell_y
    level = box.level
    own = _bucket(x, y, level, heads)
    count = _pairs_in_cell(ordered, owners, i, i + 1, heads[own + 1], x, y, level, pairs, count)
    for dx, dy in ((1, 0), (-1, 1), (0, 1), (1, 1)):
        k = _bucket(x + dx, y + dy, level, heads)
        count = _pairs_in_cell(ordered, owners, i, heads[k], heads[k + 1], x + dx, y + dy, level, pairs, count)
    return count


@kernel
def _pairs_on_sparse_levels(
    ordered: Records, owners: Records, i: int, sparse: Integers, sparse_count: int, pairs: Records, count: int
) -> int:
    """Pairs of box i with the boxes of coarser levels that hold few boxes."""
    box = ordered[i]
    for k in range(sparse_count):
        other = ordered[sparse[k]]
        if other.level > box.level and _overlap(box, other):
            count = _propose(owners, box.shape_index, other.shape_index, pairs, count)
    return count


@kernel
def _pairs_on_coarser_level(
    ordered: Records, owners: Records, i: int, base: float, level: int, heads: Integers, pairs: Records, count: int
) -> int:
    """Pairs of box i with the boxes of a coarser level: their middles are at most half a cell outside of it."""
    box = ordered[i]
    inverse = _cells_per_metre(base, level)
    first_x = math.floor(box.lower_x * inverse - 0.5)
    first_y = math.floor(box.lower_y * inverse - 0.5)
    last_x = math.floor(box.upper_x * inverse + 0.5)
    last_y = math.floor(box.upper_y * inverse + 0.5)
    for y in range(first_y, last_y + 1):
        for x in range(first_x, last_x + 1):
            k = _bucket(x, y, level, heads)
            count = _pairs_in_cell(ordered, owners, i, heads[k], heads[k + 1], x, y, level, pairs, count)
    return count


@inlined_kernel
def _pairs_in_cell(
    ordered: Records,
    owners: Records,
    i: int,
    first: int,
    end: int,
    x: int,
    y: int,
    level: int,
    pairs: Records,
    count: int,
) -> int:
    """Pairs of box i with the boxes of one cell within `ordered[first:end]`; other cells may share the bucket."""
    box = ordered[i]
    for j in range(first, end):
        other = ordered[j]
        if not _overlap(box, other):
            continue
        if other.cell_x == x and other.cell_y == y and other.level == level:
            count = _propose(owners, box.shape_index, other.shape_index, pairs, count)
    return count


@inlined_kernel
def _overlap(a: Records, b: Records) -> bool:
    """Whether two boxes share a point. One branch for all bounds: each alone would be a coin toss to the processor."""
    apart_x = (a.lower_x > b.upper_x) | (b.lower_x > a.upper_x)
    apart_y = (a.lower_y > b.upper_y) | (b.lower_y > a.upper_y)
    return bool(not (apart_x | apart_y))


@kernel
def _propose(owners: Records, i: int, j: int, pairs: Records, count: int) -> int:
    """Append the pair of shapes i and j, if they may collide and it matters; return the new count.

    It matters if one of them is active, or if one sleeps and the other is driven into it.
    """
    a = owners[i]
    b = owners[j]
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
    """Sort `pairs[:count]` by (shape_a, shape_b): two stable counting passes. `heads` needs `shapes + 1` items."""
    for turn in range(2):
        if turn == 0:
            _counting_pass(pairs, count, buffer, heads, shapes, turn == 1)
        else:
            _counting_pass(buffer, count, pairs, heads, shapes, turn == 1)


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
