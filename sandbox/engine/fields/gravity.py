"""Gravity that depends on where a body's centre is: zones and points that attract."""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.fields.area import contains
from sandbox.tables import Records
from sandbox.world.field_records import ATTRACTION, GRAVITY, GRAVITY_SCALE


@kernel
def change_gravity(region: Records, edges: Records, push: Records) -> None:
    """Let a region change the gravity of a body if its centre lies in it; regions come in the scene's order."""
    if not contains(region, edges, push.x, push.y):
        return
    if region.kind == GRAVITY:
        push.gravity_x = region.gravity_x
        push.gravity_y = region.gravity_y
    elif region.kind == GRAVITY_SCALE:
        push.gravity_x *= region.scale
        push.gravity_y *= region.scale
    elif region.kind == ATTRACTION:
        _attract(region, push)


@kernel
def _attract(region: Records, push: Records) -> None:
    """Acceleration of strength / distance^falloff towards the centre; within the core it falls to 0 linearly."""
    dx = region.center_x - push.x
    dy = region.center_y - push.y
    distance = math.sqrt(dx * dx + dy * dy)
    if distance == 0.0 or distance > region.range:
        return
    counted = distance if distance > region.core else region.core
    power = 1.0
    for _k in range(region.falloff):
        power *= counted
    share = region.strength / (power * counted)
    push.gravity_x += share * dx
    push.gravity_y += share * dy
