"""Put all shapes, as they lie now, into the grid: once after every change, at the first question."""

from __future__ import annotations

import math

from sandbox._jit import entry_point, kernel
from sandbox.engine.broad_phase.grid import base_cell, box_level, bucket, cells_per_metre, fill_grid, octave
from sandbox.engine.broad_phase.proxies import turn_cores
from sandbox.engine.queries.records import Memory, QueryTables
from sandbox.geometry.bounds import core_bounds
from sandbox.geometry.core import core_of
from sandbox.geometry.sat import FAR
from sandbox.tables import Integers, Records

_COMPANY = 2
ROUNDING = 1e-15
"""Share of its coordinates by which a box is widened, so that rounding cannot leave out what it bounds."""


@entry_point
def lay_out(tables: QueryTables, memory: Memory) -> None:
    """Turn the cores, bound them tightly, fill the grid, and note where its levels are populated."""
    boxes, grid = memory.boxes, memory.grid
    ordered, heads, levels, regions = grid.ordered, grid.heads, grid.levels, grid.regions
    turn_cores(tables.bodies, tables.shapes, tables.vertices, memory.cores)
    _bound(tables.bodies, tables.shapes, memory.cores, boxes)
    base = base_cell(boxes, levels)
    used, sparse_count = fill_grid(boxes, base, _finest_level(boxes, base, heads), ordered, heads, levels)
    question = memory.question[0]
    question.region_count = used
    question.sparse_count = sparse_count
    for k in range(used):
        regions[k].level = levels[k]
        regions[k].cells_per_metre = cells_per_metre(base, levels[k])
    _measure(ordered, regions, used)


@kernel
def _bound(bodies: Records, shapes: Records, cores: Records, boxes: Records) -> None:
    """The box of every shape: core and radius, and what rounding could cut off."""
    for i in range(shapes.shape[0]):
        shape = shapes[i]
        body = bodies[shape.body]
        lower_x, lower_y, upper_x, upper_y = core_bounds(cores, core_of(shape))
        grow = shape.radius + ROUNDING * (abs(body.center_x) + abs(body.center_y) + body.extent)
        box = boxes[i]
        box.lower_x = body.center_x + lower_x - grow
        box.lower_y = body.center_y + lower_y - grow
        box.upper_x = body.center_x + upper_x + grow
        box.upper_y = body.center_y + upper_y + grow
        box.shape_index = i


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
def _measure(ordered: Records, regions: Records, used: int) -> None:
    """Count the boxes of each populated level and bound their middles; the last row bounds all boxes."""
    everything = regions[regions.shape[0] - 1]
    _empty(everything)
    for k in range(used):
        _empty(regions[k])
    for i in range(ordered.shape[0]):
        box = ordered[i]
        _widen(everything, box.lower_x, box.lower_y)
        _widen(everything, box.upper_x, box.upper_y)
        for k in range(used):
            if regions[k].level == box.level:
                _widen(regions[k], 0.5 * (box.lower_x + box.upper_x), 0.5 * (box.lower_y + box.upper_y))


@kernel
def _empty(region: Records) -> None:
    region.count = 0
    region.lower_x = FAR
    region.lower_y = FAR
    region.upper_x = -FAR
    region.upper_y = -FAR


@kernel
def _widen(region: Records, x: float, y: float) -> None:
    """Take a point into the bounds of a region."""
    region.count += 1
    region.lower_x = x if x < region.lower_x else region.lower_x
    region.lower_y = y if y < region.lower_y else region.lower_y
    region.upper_x = x if x > region.upper_x else region.upper_x
    region.upper_y = y if y > region.upper_y else region.upper_y
