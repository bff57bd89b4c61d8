"""Buoyancy by Archimedes' principle, and the drag of standing or flowing water, over the area under water.

The area and its centroid are exact for polygons, discs and everything rounded. Each bit of that area is slowed as
`-density * drag * (its velocity - flow)`, so that a body as dense as the water loses speed as v' = -drag v; spin
about the centroid goes at its own rate. There is no added mass: water that is pushed away has no inertia.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.fields.area import boundary_within
from sandbox.engine.fields.moments import enclosed
from sandbox.engine.fields.records import Fields
from sandbox.tables import Records


@kernel
def lift(region: Records, fields: Fields, bodies: Records, shape: Records, vertices: Records) -> None:
    """Add the forces of a region of water on a shape."""
    found, count = boundary_within(region, fields, bodies, shape, vertices)
    area, first_x, first_y, second = enclosed(found, count)
    if area > 0.0:
        _lift(region, fields.pushes[shape.body], area, first_x, first_y, second)


@kernel
def _lift(region: Records, push: Records, area: float, first_x: float, first_y: float, second: float) -> None:
    x = first_x / area
    y = first_y / area
    weight_x = -region.density * area * push.gravity_x
    weight_y = -region.density * area * push.gravity_y
    push.force_x += weight_x
    push.force_y += weight_y
    push.torque += x * weight_y - y * weight_x
    if region.flow_x == 0.0 and region.flow_y == 0.0:
        push.wet = 1
    rate = region.density * area * region.drag
    about = second - area * (x * x + y * y)
    spin = region.density * region.angular_drag * (about if about > 0.0 else 0.0)
    push.drag_xx += rate
    push.drag_yy += rate
    push.drag_xw -= rate * y
    push.drag_yw += rate * x
    push.drag_ww += rate * (x * x + y * y) + spin
    push.carry_x += rate * region.flow_x
    push.carry_y += rate * region.flow_y
    push.carry_w += rate * (x * region.flow_y - y * region.flow_x)
