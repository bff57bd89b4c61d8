"""Put boxes into the cells of a part of the grid, and note where its levels are populated."""

from __future__ import annotations

import math
from typing import Any

from sandbox._jit import kernel
from sandbox.engine.broad_phase.grid import (
    LEVELS,
    base_cell,
    box_level,
    bucket,
    cells_per_metre,
    fill_grid,
    head_count,
    octave,
)
from sandbox.engine.queries.records import Memory
from sandbox.geometry.sat import FAR
from sandbox.tables import Integers, Records

_COMPANY = 2


@kernel
def fill_part(memory: Memory, count: int, first_box: int, first_head: int) -> None:
    """Put the first `count` of `memory.boxes` into a part of the grid: behind so many boxes and heads.

    Its levels come behind those that the question knows of, its boxes into the bounds of all.
    """
    grid, question = memory.grid, memory.question[0]
    boxes: Any = memory.boxes[:count]
    ordered: Any = grid.ordered[first_box : first_box + count]
    heads: Any = grid.heads[first_head : first_head + head_count(count)]
    levels = grid.levels
    base = base_cell(boxes, levels)
    used, sparse = fill_grid(boxes, base, _finest_level(boxes, base, heads), ordered, heads, levels)
    first: int = question.region_count
    regions: Any = grid.regions[first : first + used]
    for k in range(used):
        region = regions[k]
        region.level = levels[k]
        region.cells_per_metre = cells_per_metre(base, levels[k])
        region.first_box = first_box
        region.boxes = count
        region.first_head = first_head
        region.heads = heads.shape[0]
    for k in range(sparse):
        grid.sparse[question.sparse_count + k] = first_box + levels[2 * LEVELS + k]
    question.region_count += used
    question.sparse_count += sparse
    _measure(ordered, regions, grid.regions[grid.regions.shape[0] - 1])


@kernel
def empty(region: Records) -> None:
    """Nothing is within the bounds of a region."""
    region.count = 0
    region.lower_x = FAR
    region.lower_y = FAR
    region.upper_x = -FAR
    region.upper_y = -FAR


@kernel
def _finest_level(boxes: Records, base: float, heads: Integers) -> int:
    """The level with about a box a cell, where the small ones lie: rays are to cross as few empty cells as full ones.

    Beginning with what an even spread would ask for; crowded places then want finer cells.
    """
    if boxes.shape[0] == 0:
        return 0
    lower_x, lower_y, upper_x, upper_y = FAR, FAR, -FAR, -FAR
    for i in range(boxes.shape[0]):
        lower_x = boxes[i].lower_x if boxes[i].lower_x < lower_x else lower_x
        lower_y = boxes[i].lower_y if boxes[i].lower_y < lower_y else lower_y
        upper_x = boxes[i].upper_x if boxes[i].upper_x > upper_x else upper_x
        upper_y = boxes[i].upper_y if boxes[i].upper_y > upper_y else upper_y
    room = (upper_x - lower_x) * (upper_y - lower_y) / boxes.shape[0]
    level = octave(math.sqrt(room) / base)
    while level > 0 and _is_crowded(boxes, base, level, heads):
        level -= 2
    return level if level > 0 else 0


@kernel
def _is_crowded(boxes: Records, base: float, level: int, heads: Integers) -> bool:
    """Whether a box shares its cell with more than `_COMPANY` others, on average, if the small ones lay on `level`."""
    for k in range(heads.shape[0]):
        heads[k] = 0
    inverse = cells_per_metre(base, level)
    count = 0
    for i in range(boxes.shape[0]):
        box = boxes[i]
        if box_level(box, base) <= level:
            x = math.floor(0.5 * (box.lower_x + box.upper_x) * inverse)
            y = math.floor(0.5 * (box.lower_y + box.upper_y) * inverse)
            heads[bucket(x, y, level, heads)] += 1
            count += 1
    squares = 0
    for k in range(heads.shape[0]):
        squares += heads[k] * heads[k]
    return squares > (1 + _COMPANY) * count


@kernel
def _measure(ordered: Records, regions: Records, everything: Records) -> None:
    """Count the boxes of each populated level and bound their middles; take all boxes into the bounds of everything."""
    for k in range(regions.shape[0]):
        empty(regions[k])
    for i in range(ordered.shape[0]):
        box = ordered[i]
        _widen(everything, box.lower_x, box.lower_y)
        _widen(everything, box.upper_x, box.upper_y)
        for k in range(regions.shape[0]):
            if regions[k].level == box.level:
                _widen(regions[k], 0.5 * (box.lower_x + box.upper_x), 0.5 * (box.lower_y + box.upper_y))


@kernel
def _widen(region: Records, x: float, y: float) -> None:
    """Take a point into the bounds of a region."""
    region.count += 1
    region.lower_x = x if x < region.lower_x else region.lower_x
    region.lower_y = y if y < region.lower_y else region.lower_y
    region.upper_x = x if x > region.upper_x else region.upper_x
    region.upper_y = y if y > region.upper_y else region.upper_y
