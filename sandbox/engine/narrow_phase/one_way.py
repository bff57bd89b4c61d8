"""Shapes that are solid from one side only: what comes from behind passes, what comes from the front lands.

Decided when a contact begins: what is wholly in front of the shape then is held until it leaves, however deep a load
presses it in; what is not is let through until it is wholly in front. A contact that exists is one that holds, so
nothing else has to be remembered.

Links of a chain hand over to each other what slides along them, sunk in as it may be, and no contact of the last step
tells the next link. So a link holds as well what has its middle in front, unless that is on its way out there.
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.geometry.core import core_middle, core_of
from sandbox.geometry.sat import FAR
from sandbox.tables import Records
from sandbox.world.records import ONE_WAY, SEAMED

_STEEP = 0.1
"""Cosine between a contact's normal and the direction below which the contact is at a side of the shape, and passes."""

_ROUNDING = 1e-9
"""A side that reaches across the direction by no more than this share of its length is parallel to it."""


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
def holds(
    bodies: Records,
    shapes: Records,
    cores: Records,
    i: int,
    j: int,
    dx: float,
    dy: float,
    travel_x: float,
    travel_y: float,
    slop: float,
) -> bool:
    """Whether each of two shapes, where it is one-way, is to hold the other that had no contact with it yet.

    (dx, dy) leads from the centre of shape i's body to that of shape j's, (travel_x, travel_y) is the displacement of j
    against i in the step. By `slop` metres what is in front may reach in, and what goes out may be slower than that.
    """
    a = shapes[i]
    b = shapes[j]
    if a.traits & ONE_WAY:
        x, y = _front(bodies[a.body], a)
        if _clearance(cores, a, b, dx, dy, x, y) < -slop and not (
            travel_x * x + travel_y * y <= slop and _has_in_front(bodies, cores, a, b, dx, dy)
        ):
            return False
    if b.traits & ONE_WAY:
        x, y = _front(bodies[b.body], b)
        return bool(
            _clearance(cores, b, a, -dx, -dy, x, y) >= -slop
            or (-(travel_x * x + travel_y * y) <= slop and _has_in_front(bodies, cores, b, a, -dx, -dy))
        )
    return True


@kernel
def front_side(body: Records, line: Records, cores: Records) -> int:
    """On which side of a line, seen from its first end, its front is: 1 left, -1 right, 0 if it is not one-way."""
    if line.traits & ONE_WAY == 0:
        return 0
    x, y = _front(body, line)
    right = cores[line.vertex_start]
    return -1 if right.normal_x * x + right.normal_y * y > 0.0 else 1


@kernel
def _has_in_front(bodies: Records, cores: Records, link: Records, b: Records, dx: float, dy: float) -> bool:
    """Whether a shape is a link of a chain and has the middle of shape b on its front side."""
    if link.traits & SEAMED == 0 or link.vertex_count != 2:
        return False
    x, y = core_middle(cores, core_of(b))
    start = cores[link.vertex_start]
    right = start.normal_x * (x + dx - start.x) + start.normal_y * (y + dy - start.y)
    return bool(right * front_side(bodies[link.body], link, cores) < 0.0)


@kernel
def _front(body: Records, shape: Records) -> tuple[float, float]:
    """The direction out of a one-way shape's front, in world axes."""
    x = body.rotation_cos * shape.one_way_x - body.rotation_sin * shape.one_way_y
    y = body.rotation_sin * shape.one_way_x + body.rotation_cos * shape.one_way_y
    return float(x), float(y)


@kernel
def _clearance(cores: Records, a: Records, b: Records, dx: float, dy: float, nx: float, ny: float) -> float:
    """Least height (m, along n) of shape b over the front of shape a, where one lies over the other.

    Beside a it counts from the nearer end of its front.
    """
    radius = a.radius + b.radius
    if b.vertex_count == 1:
        at = cores[b.vertex_start]
        u = ny * (at.x + dx) - nx * (at.y + dy)
        return float(nx * (at.x + dx) + ny * (at.y + dy) - _rounded_front(cores, a, u, nx, ny, radius))
    if a.vertex_count == 1:
        at = cores[a.vertex_start]
        u = ny * (at.x - dx) - nx * (at.y - dy)
        return float(-(nx * (at.x - dx) + ny * (at.y - dy)) - _rounded_front(cores, b, -u, -nx, -ny, radius))
    start, end = _reach(cores, a, nx, ny)
    low, high = _reach(cores, b, nx, ny)
    shift = ny * dx - nx * dy
    left = low + shift if low + shift > start - radius else start - radius
    right = high + shift if high + shift < end + radius else end + radius
    if left > right:  # beside it: the lowest place of b, over the nearer end of a
        left = low + shift
        right = high + shift
    least = _height_over(cores, a, b, shift, left, nx, ny)
    last = _height_over(cores, a, b, shift, right, nx, ny)
    least = last if last < least else least
    for k in range(a.vertex_start, a.vertex_start + a.vertex_count):
        place = ny * cores[k].x - nx * cores[k].y
        if left < place < right:
            height = _height_over(cores, a, b, shift, place, nx, ny)
            least = height if height < least else least
    for k in range(b.vertex_start, b.vertex_start + b.vertex_count):
        place = ny * cores[k].x - nx * cores[k].y + shift
        if left < place < right:
            height = _height_over(cores, a, b, shift, place, nx, ny)
            least = height if height < least else least
    return float(least + (nx * dx + ny * dy) - radius)


@kernel
def _height_over(cores: Records, a: Records, b: Records, shift: float, place: float, nx: float, ny: float) -> float:
    """Height of the lower side of b, as if it were at a's origin but for `shift`, over the front of a at a place."""
    return -_front_at(cores, b, shift - place, -nx, -ny) - _front_at(cores, a, place, nx, ny)


@kernel
def _reach(cores: Records, shape: Records, nx: float, ny: float) -> tuple[float, float]:
    """From where to where a core reaches across the direction n."""
    low = FAR
    high = -FAR
    for k in range(shape.vertex_start, shape.vertex_start + shape.vertex_count):
        along = ny * cores[k].x - nx * cores[k].y
        low = along if along < low else low
        high = along if along > high else high
    return low, high


@kernel
def _front_at(cores: Records, shape: Records, place: float, nx: float, ny: float) -> float:
    """Height (m, along n) of the front of a core at a place across n; beyond its ends that of the nearer end."""
    low, high = _reach(cores, shape, nx, ny)
    place = low if place < low else (high if place > high else place)
    top = -FAR
    for k in range(shape.vertex_count):
        start = cores[shape.vertex_start + k]
        end = cores[shape.vertex_start + (k + 1 if k + 1 < shape.vertex_count else 0)]
        u = ny * start.x - nx * start.y
        v = ny * end.x - nx * end.y
        at_u = nx * start.x + ny * start.y
        at_v = nx * end.x + ny * end.y
        height = -FAR
        if abs(v - u) <= _ROUNDING * abs(at_v - at_u):
            if abs(place - u) <= _ROUNDING * abs(at_v - at_u):
                height = at_v if at_v > at_u else at_u
        elif u <= place <= v or v <= place <= u:
            height = at_u + (place - u) / (v - u) * (at_v - at_u)
        top = height if height > top else top
    return top


@kernel
def _rounded_front(cores: Records, shape: Records, place: float, nx: float, ny: float, radius: float) -> float:
    """Height (m, along n) of the front of a core with a rim of `radius` at a place; beside it that of its end."""
    top = -FAR
    for k in range(shape.vertex_count):
        start = cores[shape.vertex_start + k]
        end = cores[shape.vertex_start + (k + 1 if k + 1 < shape.vertex_count else 0)]
        u = ny * start.x - nx * start.y
        at_u = nx * start.x + ny * start.y
        away = place - u
        if away * away <= radius * radius:
            height = at_u + math.sqrt(radius * radius - away * away)
            top = height if height > top else top
        along = ny * end.x - nx * end.y - u
        up = nx * end.x + ny * end.y - at_u
        length = math.sqrt(along * along + up * up)
        if length > 0.0 and along != 0.0:
            lean = (
                -up / length if along > 0.0 else up / length
            )  # how far across n the rim lies from its edge, by radius
            share = (place - radius * lean - u) / along
            if 0.0 <= share <= 1.0:
                rise = along / length if along > 0.0 else -along / length
                height = at_u + share * up + radius * rise
                top = height if height > top else top
    return top if top > -FAR else _front_at(cores, shape, place, nx, ny) + radius
