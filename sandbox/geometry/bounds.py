"""The axis-aligned bounding box (AABB) of a core."""

from __future__ import annotations

from sandbox._jit import inlined_kernel
from sandbox.geometry.core import CoreRows
from sandbox.tables import Records


@inlined_kernel
def core_bounds(cores: Records, core: CoreRows) -> tuple[float, float, float, float]:
    """(lower x, lower y, upper x, upper y) of a core's vertices in their frame, metres; its radius is left out."""
    first = cores[core.start]
    lower_x = first.x
    lower_y = first.y
    upper_x = first.x
    upper_y = first.y
    for i in range(core.start + 1, core.start + core.vertex_count):
        x = cores[i].x
        y = cores[i].y
        lower_x = x if x < lower_x else lower_x
        lower_y = y if y < lower_y else lower_y
        upper_x = x if x > upper_x else upper_x
        upper_y = y if y > upper_y else upper_y
    return lower_x, lower_y, upper_x, upper_y
