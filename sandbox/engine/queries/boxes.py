"""The tight box of a shape: what walks through the grid look at before they look at the shape."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.queries.records import Memory, QueryTables
from sandbox.geometry.bounds import core_bounds
from sandbox.geometry.core import core_of
from sandbox.tables import Records

ROUNDING = 1e-15
"""Share of its coordinates by which a box is widened, so that rounding cannot leave out what it bounds."""


@kernel
def bound(tables: QueryTables, memory: Memory, i: int, box: Records) -> None:
    """The box of a shape whose core has been turned: core and radius, and what rounding could cut off."""
    shape = tables.shapes[i]
    body = tables.bodies[shape.body]
    lower_x, lower_y, upper_x, upper_y = core_bounds(memory.cores, core_of(shape))
    grow = shape.radius + ROUNDING * (abs(body.center_x) + abs(body.center_y) + body.extent)
    box.lower_x = body.center_x + lower_x - grow
    box.lower_y = body.center_y + lower_y - grow
    box.upper_x = body.center_x + upper_x + grow
    box.upper_y = body.center_y + upper_y + grow
    box.shape_index = i
