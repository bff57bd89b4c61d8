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
from sandbox.engine.broad_phase.pairs import Window, pairs_on_level, propose
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
    for level in range(LEVELS):
        grid.moved_on[level] = 0
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
    _count(fat, k, -1, grid)
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
    _count(fat, k, 1, grid)
    grid.moved_next[i] = grid.moved_heads[k]
    grid.moved_heads[k] = i


@inlined_kernel
def _count(fat: Records, k: int, more: int, grid: Grid) -> None:
    """So many boxes more in list k, like `fat`."""
    info = grid.info[0]
    grid.moved_on[fat.level - LOWEST] += more
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

    Cell by cell, or with all of them if it covers more cells than that. What lies outside of all that the grid was
    built of, as what has fallen off a level, looks into no cell of levels on which nothing has moved.
    """
    info = grid.info[0]
    whole = Window(box.lower_x, box.lower_y, box.upper_x, box.upper_y)
    window = _clipped(whole, info)
    if not _cells_to_look_into(window, whole, grid) <= info.shapes:
        for j in range(info.shapes):
            if boxes_overlap(box, grid.fat_boxes[j]):
                count = propose(filters, box.shape_index, j, pairs, count)
        return count
    ordered = grid.ordered
    for k in range(info.used):
        level = grid.levels[k]
        inverse = cells_per_metre(info.cell, level)
        if not _is_empty(window):
            count = pairs_on_level(box, window, ordered, filters, inverse, level, grid.heads, pairs, count)
        if grid.moved_on[level - LOWEST] > 0:
            count = _pairs_with_moved(box, filters, inverse, level, grid, pairs, count)
    sparse = grid.levels[2 * LEVELS :]
    for k in range(info.sparse):
        if boxes_overlap(box, ordered[sparse[k]]):
            count = propose(filters, box.shape_index, ordered[sparse[k]].shape_index, pairs, count)
    j = grid.moved_heads[grid.heads.shape[0] - 1]
    while j != END:
        if boxes_overlap(box, grid.fat_boxes[j]):
            count = propose(filters, box.shape_index, j, pairs, count)
        j = grid.moved_next[j]
    return count


@inlined_kernel
def _cells_to_look_into(window: Window, whole: Window, grid: Grid) -> float:
    """How many cells a query looks into, at most: those of what has moved in all of its box, of the others within a
    window."""
    info = grid.info[0]
    cells = 0.0
    for k in range(info.used):
        inverse = cells_per_metre(info.cell, grid.levels[k])
        cells += 0.0 if _is_empty(window) else _cells_in(window, inverse)
        cells += _cells_in(whole, inverse) if grid.moved_on[grid.levels[k] - LOWEST] > 0 else 0.0
    return cells


@inlined_kernel
def _cells_in(window: Window, inverse: float) -> float:
    return (2.0 + (window.upper_x - window.lower_x) * inverse) * (2.0 + (window.upper_y - window.lower_y) * inverse)


@inlined_kernel
def _is_empty(window: Window) -> bool:
    return window.lower_x > window.upper_x or window.lower_y > window.upper_y


@inlined_kernel
def _clipped(box: Window, info: Records) -> Window:
    """What of a box lies within the bounds of the boxes that the grid was built of."""
    return Window(
        box.lower_x if box.lower_x > info.lower_x else info.lower_x,
        box.lower_y if box.lower_y > info.lower_y else info.lower_y,
        box.upper_x if box.upper_x < info.upper_x else info.upper_x,
        box.upper_y if box.upper_y < info.upper_y else info.upper_y,
    )


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
