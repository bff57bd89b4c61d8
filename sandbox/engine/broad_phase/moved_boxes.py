"""The grid after it was built: boxes that have moved since are taken out of it and kept in lists, one for each bucket.

A box that leaves its cell costs the same however many others there are, as in a grid of linked lists; the others stay
side by side in memory.
"""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.broad_phase.grid import (
    LEVELS,
    LOWEST,
    SPARSE,
    box_level,
    boxes_overlap,
    bucket,
    cells_per_metre,
    first_cell,
    last_cell,
    place,
)
from sandbox.engine.broad_phase.pairs import pairs_on_level, propose
from sandbox.engine.records.colliders import Grid
from sandbox.tables import Records

END, ORDERED, ABSENT = -1, -2, -3
"""What `grid.moved_next` says of a box, if not which one follows it in its list: it is the last one, it lies in
`grid.ordered`, or it is new."""


@kernel
def forget_moved(shapes: int, grid: Grid) -> None:
    """The grid has just been built of the boxes of so many shapes: none has moved."""
    info = grid.info[0]
    info.shapes = info.known = shapes
    info.moved = info.others = 0
    for k in range(grid.moved_heads.shape[0]):
        grid.moved_heads[k] = END
    for i in range(shapes):
        grid.moved_next[i] = ORDERED
        grid.outgrown[i] = 0


@kernel
def remove_box(i: int, grid: Grid) -> None:
    """Take the fat box of a shape out of the grid."""
    fat = grid.fat_boxes[i]
    following = grid.moved_next[i]
    if following == ABSENT:
        return
    if following == ORDERED:
        k = bucket(fat.cell_x, fat.cell_y, fat.level, grid.heads)
        for n in range(grid.heads[k], grid.heads[k + 1]):
            box = grid.ordered[n]
            if box.shape_index == i:  # nothing overlaps what ends before it begins
                box.lower_x = box.lower_y = math.inf
                box.upper_x = box.upper_y = -math.inf
        return
    k = _list_of(fat, grid)
    _count(k, -1, grid)
    if grid.moved_heads[k] == i:
        grid.moved_heads[k] = following
        return
    j = grid.moved_heads[k]
    while grid.moved_next[j] != i:
        j = grid.moved_next[j]
    grid.moved_next[j] = following


@kernel
def insert_box(i: int, grid: Grid) -> None:
    """Put the fat box of a shape into the list of its bucket."""
    fat = grid.fat_boxes[i]
    info = grid.info[0]
    level = box_level(fat, info.cell)
    place(fat, level, cells_per_metre(info.cell, level))
    k = _list_of(fat, grid)
    _count(k, 1, grid)
    grid.moved_next[i] = grid.moved_heads[k]
    grid.moved_heads[k] = i


@inlined_kernel
def _count(k: int, more: int, grid: Grid) -> None:
    info = grid.info[0]
    info.moved += more
    info.others += more if k == grid.heads.shape[0] - 1 else 0


@inlined_kernel
def _list_of(fat: Records, grid: Grid) -> int:
    """The list of a box: its bucket, or the last one, which everybody looks into, if its level had few boxes."""
    if grid.levels[LEVELS + fat.level - LOWEST] <= SPARSE:
        return int(grid.heads.shape[0] - 1)
    return bucket(fat.cell_x, fat.cell_y, fat.level, grid.heads)


@kernel
def query_pairs(box: Records, filters: Records, grid: Grid, pairs: Records, count: int) -> int:
    """Append the pairs of a shape's box with all fat boxes in the grid that it overlaps; return the new count.

    Cell by cell, or with all of them if it covers more cells than that.
    """
    info = grid.info[0]
    cells = 0.0
    for k in range(info.used):
        inverse = cells_per_metre(info.cell, grid.levels[k])
        cells += (2.0 + (box.upper_x - box.lower_x) * inverse) * (2.0 + (box.upper_y - box.lower_y) * inverse)
    if not cells <= info.shapes:
        for j in range(info.shapes):
            if boxes_overlap(box, grid.fat_boxes[j]):
                count = propose(filters, box.shape_index, j, pairs, count)
        return count
    ordered = grid.ordered
    sparse = grid.levels[2 * LEVELS :]
    for k in range(info.used):
        inverse = cells_per_metre(info.cell, grid.levels[k])
        count = pairs_on_level(box, ordered, filters, inverse, grid.levels[k], grid.heads, pairs, count)
        if info.moved > 0:
            count = _pairs_with_moved(box, filters, inverse, grid.levels[k], grid, pairs, count)
    for k in range(info.sparse):
        if boxes_overlap(box, ordered[sparse[k]]):
            count = propose(filters, box.shape_index, ordered[sparse[k]].shape_index, pairs, count)
    j = grid.moved_heads[grid.heads.shape[0] - 1]
    while j != END:
        if boxes_overlap(box, grid.fat_boxes[j]):
            count = propose(filters, box.shape_index, j, pairs, count)
        j = grid.moved_next[j]
    return count


@kernel
def _pairs_with_moved(
    box: Records,
    filters: Records,
    inverse: float,
    level: int,
    grid: Grid,
    pairs: Records,
    count: int,
) -> int:
    """As `pairs_on_level`, for the boxes in the lists."""
    last_x = last_cell(box.upper_x, inverse)
    for y in range(first_cell(box.lower_y, inverse), last_cell(box.upper_y, inverse) + 1):
        for x in range(first_cell(box.lower_x, inverse), last_x + 1):
            j = grid.moved_heads[bucket(x, y, level, grid.heads)]
            while j != END:
                other = grid.fat_boxes[j]
                if boxes_overlap(box, other) and other.cell_x == x and other.cell_y == y and other.level == level:
                    count = propose(filters, box.shape_index, j, pairs, count)
                j = grid.moved_next[j]
    return count
