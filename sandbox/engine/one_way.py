"""Shapes that are solid from one side only: what comes from behind passes, what comes from the front lands.

Decided when a contact begins: what is wholly in front of the shape then is held until it leaves, however deep a load
presses it in; what is not is let through until it is wholly in front. A contact that exists is one that holds, so
nothing else has to be remembered.
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.geometry.sat import FAR
from sandbox.tables import Records
from sandbox.world.records import ONE_WAY

_STEEP = 0.1
"""Cosine between a contact's normal and the direction below which the contact is at a side of the shape, and passes."""


@kernel
def leads_on(bodies: Records, shapes: Records, i: int, j: int, normal_x: float, normal_y: float) -> bool:
    """Whether the normal of a contact, from shape i to shape j, leads out at the front of those that are one-way."""
    a = shapes[i]
    b = shapes[j]
    if a.traits & ONE_WAY:
        x, y = _front(bodies[a.body], a)
        if normal_x * x + normal_y * y < _STEEP:
            return False
    if b.traits & ONE_WAY:
        x, y = _front(bodies[b.body], b)
        return bool(-(normal_x * x + normal_y * y) >= _STEEP)
    return True


@kernel
def comes_from_front(
    bodies: Records, shapes: Records, turned: Records, i: int, j: int, dx: float, dy: float, slop: float
) -> bool:
    """Whether each of two shapes is wholly in front of the other, where that is one-way, but for `slop` metres.

    (dx, dy) leads from the centre of shape i's body to that of shape j's.
    """
    a = shapes[i]
    b = shapes[j]
    if a.traits & ONE_WAY:
        x, y = _front(bodies[a.body], a)
        if _clearance(turned, a, b, dx, dy, x, y) < -slop:
            return False
    if b.traits & ONE_WAY:
        x, y = _front(bodies[b.body], b)
        return bool(_clearance(turned, b, a, -dx, -dy, x, y) >= -slop)
    return True


@kernel
def _front(body: Records, shape: Records) -> tuple[float, float]:
    """The direction out of a one-way shape's front, in world axes."""
    x = body.rotation_cos * shape.one_way_x - body.rotation_sin * shape.one_way_y
    y = body.rotation_sin * shape.one_way_x + body.rotation_cos * shape.one_way_y
    return float(x), float(y)


@kernel
def _clearance(turned: Records, a: Records, b: Records, dx: float, dy: float, nx: float, ny: float) -> float:
    """Least height (m, along n) over the top of shape a of what of shape b lies above it; large if nothing does."""
    low = FAR
    high = -FAR
    top = -FAR
    for k in range(a.vertex_start, a.vertex_start + a.vertex_count):
        along = ny * turned[k].x - nx * turned[k].y
        height = nx * turned[k].x + ny * turned[k].y
        low = along if along < low else low
        high = along if along > high else high
        top = height if height > top else top
    top = top + a.radius
    if b.vertex_count > 1:
        low = low - a.radius
        high = high + a.radius
    least = FAR
    for k in range(b.vertex_count):
        start = turned[b.vertex_start + k]
        end = turned[b.vertex_start + (k + 1 if k + 1 < b.vertex_count else 0)]
        u = ny * (start.x + dx) - nx * (start.y + dy)
        v = ny * (end.x + dx) - nx * (end.y + dy)
        at_u = nx * (start.x + dx) + ny * (start.y + dy)
        at_v = nx * (end.x + dx) + ny * (end.y + dy)
        if b.vertex_count == 1:
            return float(_disc_height(u, low, high, b.radius + a.radius) + at_u - (top - a.radius))
        for place in (u, v, low, high):
            if low <= place <= high and (u <= place <= v or v <= place <= u):
                height = at_u if u == v else at_u + (place - u) / (v - u) * (at_v - at_u)
                if u == v and at_v < height:
                    height = at_v
                least = height if height < least else least
    return float(least - b.radius - top)


@kernel
def _disc_height(u: float, low: float, high: float, radius: float) -> float:
    """How far below its centre (negative, m) a disc at `u` reaches within the strip from `low` to `high`."""
    beyond = low - u if u < low else (u - high if u > high else 0.0)
    if beyond >= radius:
        return FAR
    return -math.sqrt(radius * radius - beyond * beyond)
