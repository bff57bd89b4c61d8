"""Stage: the grid where most shapes stay where they are. They keep a grid of their own, which those that move ask.

What rests proposes no pairs with what rests. So the grid of the resting shapes is laid only when somebody has woken
or fallen asleep, and a step asks it for the neighbours of the few that move.
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import ZERO, kernel
from sandbox.engine.active.active_set import STIRS
from sandbox.engine.broad_phase.grid import LEVELS, LOWEST, base_cell, boxes_overlap, cells_per_metre, fill_grid
from sandbox.engine.broad_phase.pairs import find_pairs, pairs_on_level, propose
from sandbox.tables import Integers, Records

SHARE = 4
"""The grid is parted when less than one in so many shapes moves."""
LEAST = 64
"""Fewer shapes than this are not worth it."""


@kernel
def part_shapes(shapes: Records, census: Records, stirs: Integers, parts: Integers) -> bool:
    """Put the rows of the shapes that may move first into `parts`, then the others, if that is not how it is already.

    Returns whether something has changed. `census` then knows how many move and whether the grid is parted.
    """
    if census.laid == census.era:
        return False
    census.laid = census.era
    count = shapes.shape[0]
    moving = ZERO
    for i in range(count):
        if stirs[shapes[i].body] == STIRS:
            parts[moving] = i
            moving += 1
    resting = moving
    for i in range(count):
        if stirs[shapes[i].body] != STIRS:
            parts[resting] = i
            resting += 1
    census.moving = moving
    census.parted = 1 if count >= LEAST and SHARE * moving < count else 0
    return True


@kernel
def find_all_pairs(
    boxes: Records,
    owners: Records,
    parts: Integers,
    census: Records,
    anew: bool,
    spare: Records,
    ordered: Records,
    heads: Integers,
    levels: Integers,
    rest_heads: Integers,
    rest_levels: Integers,
    pairs: Records,
) -> int:
    """As `find_pairs`; `anew` if `parts` has changed.

    If the grid is parted, `ordered` has the boxes of the resting shapes first, then those of the moving ones. `spare`
    is scratch.
    """
    apart = census.parted == 1
    moving = parts[: census.moving]
    resting = parts[census.moving :]
    rested = resting.shape[0] if apart else 0
    still: Any = ordered[:rested]
    lively: Any = ordered[rested:]
    some: Any = boxes[:]
    own_heads = heads[:]
    if apart:
        if anew:
            _gather(boxes, resting, spare)
            those: Any = spare[:rested]
            census.cell = base_cell(those, rest_levels)
            used, sparse = fill_grid(those, census.cell, LOWEST, still, rest_heads, rest_levels)
            census.used = used
            census.sparse = sparse
        _gather(boxes, moving, spare)
        some = spare[: moving.shape[0]]
        own_heads = heads[: _bucket_count(moving.shape[0]) + 1]
    count = find_pairs(some, owners, lively, own_heads, levels, pairs)
    if apart:
        for i in moving:
            count = _pairs_with_resting(boxes[i], still, owners, census, rest_heads, rest_levels, pairs, count)
    return count


@kernel
def _bucket_count(shapes: int) -> int:
    buckets = 128
    while buckets < 2 * shapes:
        buckets *= 2
    return buckets


@kernel
def _gather(boxes: Records, rows: Integers, spare: Records) -> None:
    for k in range(rows.shape[0]):
        spare[k] = boxes[rows[k]]


@kernel
def _pairs_with_resting(
    box: Records,
    still: Records,
    owners: Records,
    census: Records,
    heads: Integers,
    levels: Integers,
    pairs: Records,
    count: int,
) -> int:
    """Pairs of a moving box with resting ones: cell by cell, or with all of them if it covers more cells than that."""
    sparse = levels[2 * LEVELS :]
    cells = 0.0
    for k in range(census.used):
        inverse = cells_per_metre(census.cell, levels[k])
        cells += (2.0 + (box.upper_x - box.lower_x) * inverse) * (2.0 + (box.upper_y - box.lower_y) * inverse)
    if cells > still.shape[0]:
        for k in range(still.shape[0]):
            if boxes_overlap(box, still[k]):
                count = propose(owners, box.shape_index, still[k].shape_index, pairs, count)
        return count
    for k in range(census.used):
        count = pairs_on_level(box, still, owners, census.cell, levels[k], heads, pairs, count)
    for k in range(census.sparse):
        if boxes_overlap(box, still[sparse[k]]):
            count = propose(owners, box.shape_index, still[sparse[k]].shape_index, pairs, count)
    return count
