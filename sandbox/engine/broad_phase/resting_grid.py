"""Stage: the grid where most shapes stay where they are. They keep a grid of their own, which those that move ask.

What rests proposes no pairs with what rests. So the grid of the resting shapes is laid only when somebody has woken
or fallen asleep, and a step asks it for the neighbours of the few that move.
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import kernel
from sandbox.engine.active.active_set import AWAKE
from sandbox.engine.broad_phase.grid import LEVELS, LOWEST, base_cell, boxes_overlap, cells_per_metre, fill_grid
from sandbox.engine.broad_phase.pairs import find_pairs, pairs_on_level, propose
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.colliders import Colliders, Grid
from sandbox.tables import Integers, Records

SHARE = 4
"""The grid is split when there are more resting shapes than one for so many that move."""
LEAST = 64
"""Fewer resting shapes than this are not worth it."""


@kernel
def order_shapes(shapes: Records, active: ActiveSet) -> bool:
    """Put the rows of the shapes that may move first into `active.shapes`, then the others, if they are not already.

    Returns whether something has changed. `active.info` then knows how many move and whether the grid is split.
    """
    info = active.info[0]
    if info.shapes_generation == info.generation:
        return False
    info.shapes_generation = info.generation
    count = shapes.shape[0]
    moving = 0
    for i in range(count):
        if active.activity[shapes[i].body] == AWAKE:
            active.shapes[moving] = i
            moving += 1
    resting = moving
    for i in range(count):
        if active.activity[shapes[i].body] != AWAKE:
            active.shapes[resting] = i
            resting += 1
    info.moving = moving
    rests = count - moving
    info.split = 1 if rests >= LEAST and SHARE * rests > moving else 0
    return True


@kernel
def find_all_pairs(colliders: Colliders, active: ActiveSet, shapes: int, changed: bool, grid: Grid) -> int:
    """As `find_pairs` for so many shapes, into `grid.pairs`; `changed` if their order has.

    If the grid is split, `grid.ordered` has the boxes of the resting shapes first, then those of the moving ones.
    """
    info = active.info[0]
    split = info.split == 1
    moving = active.shapes[: info.moving]
    resting = active.shapes[info.moving : shapes]
    rested = resting.shape[0] if split else 0
    still: Any = grid.ordered[:rested]
    lively: Any = grid.ordered[rested:shapes]
    some: Any = colliders.boxes[:shapes]
    heads = grid.heads[: bucket_count(shapes) + 1]
    resting_heads = grid.resting_heads[: bucket_count(shapes) + 1]
    if split:
        if changed:
            _gather(colliders.boxes, resting, grid.spare_boxes)
            those: Any = grid.spare_boxes[:rested]
            info.cell = base_cell(those, grid.resting_levels)
            used, sparse = fill_grid(those, info.cell, LOWEST, still, resting_heads, grid.resting_levels)
            info.used = used
            info.sparse = sparse
        _gather(colliders.boxes, moving, grid.spare_boxes)
        some = grid.spare_boxes[: moving.shape[0]]
        heads = grid.heads[: bucket_count(moving.shape[0]) + 1]
    count = find_pairs(some, colliders.filters, lively, heads, grid.levels, grid.pairs)
    if split:
        for i in moving:
            count = pairs_with_resting(
                colliders.boxes[i],
                still,
                colliders.filters,
                info,
                resting_heads,
                grid.resting_levels,
                grid.pairs,
                count,
            )
    return count


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
    box: Records,
    still: Records,
    filters: Records,
    info: Records,
    heads: Integers,
    levels: Integers,
    pairs: Records,
    count: int,
) -> int:
    """Pairs of a moving box with resting ones: cell by cell, or with all of them if it covers more cells than that."""
    sparse = levels[2 * LEVELS :]
    cells = 0.0
    for k in range(info.used):
        inverse = cells_per_metre(info.cell, levels[k])
        cells += (2.0 + (box.upper_x - box.lower_x) * inverse) * (2.0 + (box.upper_y - box.lower_y) * inverse)
    if cells > still.shape[0]:
        for k in range(still.shape[0]):
            if boxes_overlap(box, still[k]):
                count = propose(filters, box.shape_index, still[k].shape_index, pairs, count)
        return count
    for k in range(info.used):
        inverse = cells_per_metre(info.cell, levels[k])
        count = pairs_on_level(box, still, filters, inverse, levels[k], heads, pairs, count)
    for k in range(info.sparse):
        if boxes_overlap(box, still[sparse[k]]):
            count = propose(filters, box.shape_index, still[sparse[k]].shape_index, pairs, count)
    return count
