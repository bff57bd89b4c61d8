"""Stage: the grid where most shapes stay where they are. They keep a grid of their own, which those that move ask.

What rests proposes no pairs with what rests. So the grid of the resting shapes is laid only when somebody has woken
or fallen asleep, and a step asks it for the neighbours of the few that move. Where there are many that stay where they
are until something is changed from outside, they are kept apart: who falls asleep costs as much as sleeps.
"""

from __future__ import annotations

import math
from typing import Any

from sandbox._jit import kernel
from sandbox.engine.active.active_set import AWAKE
from sandbox.engine.broad_phase.grid import LEVELS, LOWEST, base_cell, boxes_overlap, cells_per_metre, fill_grid
from sandbox.engine.broad_phase.pairs import find_pairs, pairs_on_level, propose
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.colliders import Colliders, Grid, RestingGrid
from sandbox.tables import Integers, Records

SHARE = 4
"""The grid is split when there are more resting shapes than one for so many that move."""
LEAST = 64
"""Fewer resting shapes than this are not worth it."""
LOOSE, ALL = 1, 2
"""What `order_shapes` has put in order: the shapes that may move or sleep, or all."""


@kernel
def order_shapes(shapes: Records, active: ActiveSet) -> int:
    """Put the rows of the shapes that may move first into `active.shapes`, then the other loose ones, then the others.

    Returns what had to be put in order: 0, `LOOSE` or `ALL`. `active.info` then knows how many move, and whether and
    where the grid is split.
    """
    info = active.info[0]
    if info.shapes_generation == info.generation:
        return 0
    count = shapes.shape[0]
    found = LOOSE
    if info.fixed_generation > info.shapes_generation:
        found = ALL
        _put_loose_aside(shapes, active)
    info.shapes_generation = info.generation
    moving = 0
    for i in active.loose_shapes[: info.loose]:
        if active.activity[shapes[i].body] == AWAKE:
            active.shapes[moving] = i
            moving += 1
    resting = moving
    for i in active.loose_shapes[: info.loose]:
        if active.activity[shapes[i].body] != AWAKE:
            active.shapes[resting] = i
            resting += 1
    info.moving = moving
    rests = count - moving
    info.split = 1 if rests >= LEAST and SHARE * rests > moving else 0
    fixed = count - info.loose
    info.apart = fixed if info.split == 1 and fixed >= LEAST else 0
    return found


@kernel
def _put_loose_aside(shapes: Records, active: ActiveSet) -> None:
    """List the loose shapes, and put the others last into `active.shapes`."""
    loose = 0
    for i in range(shapes.shape[0]):
        if active.activity[shapes[i].body] != 0:
            active.loose_shapes[loose] = i
            loose += 1
    active.info[0].loose = loose
    last = loose
    for i in range(shapes.shape[0]):
        if active.activity[shapes[i].body] == 0:
            active.shapes[last] = i
            last += 1


@kernel
def outdated_shapes(info: Records, changed: int, shapes: int) -> int:
    """How many of `active.shapes`, from the first one on, may have other boxes than when they were bounded last, if
    `order_shapes` has returned `changed`."""
    if changed == ALL:
        return shapes
    moving: int = info.moving
    loose: int = info.loose
    return moving if info.split == 1 and changed == 0 else loose


@kernel
def find_all_pairs(colliders: Colliders, active: ActiveSet, shapes: int, changed: int, grid: Grid) -> int:
    """As `find_pairs` for so many shapes, into `grid.pairs`; `changed` is what `order_shapes` has returned.

    If the grid is split, `grid.ordered` has the boxes of the shapes kept apart first, then those of the other resting
    shapes, then those of the moving ones.
    """
    info = active.info[0]
    if info.split == 0:
        info.apart_generation = 0
        heads = grid.heads[: bucket_count(shapes) + 1]
        some: Any = colliders.boxes[:shapes]
        ordered: Any = grid.ordered[:shapes]
        return find_pairs(some, colliders.filters, ordered, heads, grid.levels, grid.pairs)
    if changed != 0:
        _lay_resting(colliders, active, shapes, grid)
    moving = active.shapes[: info.moving]
    _gather(colliders.boxes, moving, grid.spare_boxes)
    lively: Any = grid.spare_boxes[: info.moving]
    last: Any = grid.ordered[shapes - info.moving : shapes]
    heads = grid.heads[: bucket_count(info.moving) + 1]
    count = find_pairs(lively, colliders.filters, last, heads, grid.levels, grid.pairs)
    for i in moving:
        count = pairs_with_resting(colliders.boxes[i], colliders.filters, info, grid, shapes, grid.pairs, count)
    return count


@kernel
def _lay_resting(colliders: Colliders, active: ActiveSet, shapes: int, grid: Grid) -> None:
    """Lay the resting shapes into their grids; those kept apart only if they are not there yet."""
    info = active.info[0]
    end = shapes - info.apart
    still: Any = grid.ordered[info.apart : shapes - info.moving]
    _lay(colliders.boxes, active.shapes[info.moving : end], grid.spare_boxes, still, grid.resting)
    if info.apart == 0:
        info.apart_generation = 0
    elif info.apart_generation != info.fixed_generation:
        info.apart_generation = info.fixed_generation
        apart: Any = grid.ordered[: info.apart]
        _lay(colliders.boxes, active.shapes[end:shapes], grid.spare_boxes, apart, grid.apart)


@kernel
def _lay(boxes: Records, rows: Integers, spare: Records, ordered: Records, grid: RestingGrid) -> None:
    _gather(boxes, rows, spare)
    those: Any = spare[: rows.shape[0]]
    info = grid.info[0]
    heads = grid.heads[: bucket_count(rows.shape[0]) + 1]
    info.cell = base_cell(those, grid.levels)
    used, sparse = fill_grid(those, info.cell, LOWEST, ordered, heads, grid.levels)
    info.used = used
    info.sparse = sparse
    _bound(those, info)


@kernel
def _bound(boxes: Records, info: Records) -> None:
    """Note the bounds of all boxes: who is far from every one of them need not look into cells."""
    info.lower_x = info.lower_y = math.inf
    info.upper_x = info.upper_y = -math.inf
    for k in range(boxes.shape[0]):
        box = boxes[k]
        info.lower_x = box.lower_x if box.lower_x < info.lower_x else info.lower_x
        info.lower_y = box.lower_y if box.lower_y < info.lower_y else info.lower_y
        info.upper_x = box.upper_x if box.upper_x > info.upper_x else info.upper_x
        info.upper_y = box.upper_y if box.upper_y > info.upper_y else info.upper_y


@kernel
def bucket_count(shapes: int) -> int:
    buckets = 128
    while buckets < 2 * shapes:
        buckets *= 2
    return buckets


@kernel
def _gather(boxes: Records, rows: Integers, spare: Records) -> None:
    for k in range(rows.shape[0]):
        spare[k] = boxes[rows[k]]


@kernel
def pairs_with_resting(
    box: Records, filters: Records, info: Records, grid: Grid, shapes: int, pairs: Records, count: int
) -> int:
    """Pairs of a moving box with resting ones, where the grid of so many shapes is split; return the new count."""
    still: Any = grid.ordered[info.apart : shapes - info.moving]
    if still.shape[0] > 0:
        count = _pairs_with(box, still, filters, grid.resting, pairs, count)
    if info.apart > 0:
        apart: Any = grid.ordered[: info.apart]
        count = _pairs_with(box, apart, filters, grid.apart, pairs, count)
    return count


@kernel
def _pairs_with(box: Records, still: Records, filters: Records, grid: RestingGrid, pairs: Records, count: int) -> int:
    """Pairs of a box with those of a grid: cell by cell, or with all of them if it covers more cells than that; none if
    it lies outside of all."""
    info = grid.info[0]
    if not boxes_overlap(box, info):
        return count
    heads = grid.heads[: bucket_count(still.shape[0]) + 1]
    sparse = grid.levels[2 * LEVELS :]
    cells = 0.0
    for k in range(info.used):
        inverse = cells_per_metre(info.cell, grid.levels[k])
        cells += (2.0 + (box.upper_x - box.lower_x) * inverse) * (2.0 + (box.upper_y - box.lower_y) * inverse)
    if cells > still.shape[0]:
        for k in range(still.shape[0]):
            if boxes_overlap(box, still[k]):
                count = propose(filters, box.shape_index, still[k].shape_index, pairs, count)
        return count
    for k in range(info.used):
        inverse = cells_per_metre(info.cell, grid.levels[k])
        count = pairs_on_level(box, still, filters, inverse, grid.levels[k], heads, pairs, count)
    for k in range(info.sparse):
        if boxes_overlap(box, still[sparse[k]]):
            count = propose(filters, box.shape_index, still[sparse[k]].shape_index, pairs, count)
    return count
