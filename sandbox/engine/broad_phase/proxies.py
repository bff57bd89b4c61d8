"""Stage: turn every shape into world axes, bound it, and lay side by side what its pairs will ask of it."""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel, kernel
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC, STATIC

MARGIN = 0.02
"""Most that contacts look ahead at low speed, in metres; four times the usual slop of 5 mm."""
MARGIN_SHARE = 0.1
"""The same for small bodies, as a share of their extent."""

ACTIVE, SLEEPS, DRIVEN, FIXED, BULLET, HEMMED = 4, 8, 16, 32, 64, 128
"""How the body of a shape moves, and what it is: bits next to a shape's `SEAMED` and `ONE_WAY`, so that a pair can be
judged by one `or`."""


@kernel
def shape_margin(extent: float) -> float:
    """Half of what a pair of bodies looks ahead at low speed, in metres, given the body's extent."""
    share = MARGIN_SHARE * extent
    return 0.5 * (share if share < MARGIN else MARGIN)


@inlined_kernel
def pair_margin(a: Records, b: Records) -> float:
    """How far a pair of slow bodies looks ahead, in metres."""
    margin_a = shape_margin(a.extent)
    margin_b = shape_margin(b.extent)
    return 2.0 * (margin_a if margin_a < margin_b else margin_b)


@kernel
def turn_cores(bodies: Records, shapes: Records, vertices: Records, turned: Records) -> None:
    """Turn the cores of all shapes into world axes; they stay measured from their body's centre of mass."""
    for i in range(shapes.shape[0]):
        _turn_core(bodies[shapes[i].body], shapes[i], vertices, turned)


@inlined_kernel
def _turn_core(body: Records, shape: Records, vertices: Records, turned: Records) -> None:
    c = body.rotation_cos
    s = body.rotation_sin
    for j in range(shape.vertex_start, shape.vertex_start + shape.vertex_count):
        source = vertices[j]
        target = turned[j]
        target.x = c * source.x - s * source.y
        target.y = s * source.x + c * source.y
        target.normal_x = c * source.normal_x - s * source.normal_y
        target.normal_y = s * source.normal_x + c * source.normal_y


@kernel
def _how_it_moves(body: Records) -> int:
    """`ACTIVE`, `SLEEPS`, `DRIVEN`, or 0 for a body that stays where it is."""
    if body.type == DYNAMIC:
        return ACTIVE if body.awake == 1 else SLEEPS
    moves = body.velocity_x != 0.0 or body.velocity_y != 0.0 or body.angular_velocity != 0.0
    return DRIVEN if moves or body.posed == 1 else 0


@kernel
def bound_shapes(
    bodies: Records,
    shapes: Records,
    vertices: Records,
    rows: Integers,
    seconds: float,
    turned: Records,
    boxes: Records,
    owners: Records,
    proxies: Records,
) -> None:
    """Turn the cores of some shapes and bound them: core, radius, margin, and the way in `seconds` at their velocity.

    Their `OWNER` and `PROXY` rows are filled in too, for the grid and for the narrow phase.
    """
    for i in rows:
        shape = shapes[i]
        body = bodies[shape.body]
        _turn_core(body, shape, vertices, turned)
        first = turned[shape.vertex_start]
        lower_x = first.x
        lower_y = first.y
        upper_x = first.x
        upper_y = first.y
        for j in range(shape.vertex_start + 1, shape.vertex_start + shape.vertex_count):
            x = turned[j].x
            y = turned[j].y
            lower_x = x if x < lower_x else lower_x
            lower_y = y if y < lower_y else lower_y
            upper_x = x if x > upper_x else upper_x
            upper_y = y if y > upper_y else upper_y
        spin = body.angular_velocity if body.angular_velocity > 0.0 else -body.angular_velocity
        swing = seconds * spin
        swing = body.extent * (swing if swing < 2.0 else 2.0)
        grow = shape.radius + shape_margin(body.extent) + swing
        way_x = seconds * body.velocity_x
        way_y = seconds * body.velocity_y
        box = boxes[i]
        box.lower_x = body.center_x + lower_x - grow + (way_x if way_x < 0.0 else 0.0)
        box.lower_y = body.center_y + lower_y - grow + (way_y if way_y < 0.0 else 0.0)
        box.upper_x = body.center_x + upper_x + grow + (way_x if way_x > 0.0 else 0.0)
        box.upper_y = body.center_y + upper_y + grow + (way_y if way_y > 0.0 else 0.0)
        box.shape_index = i
        moves = _how_it_moves(body)
        owner = owners[i]
        owner.body = shape.body
        owner.moves = moves
        owner.hemmed = 0
        # Nothing is in category 0, so that the grid proposes no pairs of a sensor.
        owner.category = shape.category if shape.sensor == 0 else 0
        owner.mask = shape.mask
        owner.group = shape.group if shape.sensor == 0 else 0
        _fill_proxy(body, shape, moves, spin, proxies[i])


@inlined_kernel
def _fill_proxy(body: Records, shape: Records, moves: int, spin: float, proxy: Records) -> None:
    """What the narrow phase asks of a shape and its body, in two cache lines instead of six."""
    proxy.center_x = body.center_x
    proxy.center_y = body.center_y
    proxy.velocity_x = body.velocity_x
    proxy.velocity_y = body.velocity_y
    proxy.speed = math.sqrt(body.velocity_x * body.velocity_x + body.velocity_y * body.velocity_y)
    proxy.swing = spin * (body.extent - shape.radius)
    proxy.margin = shape_margin(body.extent)
    fixed = FIXED if body.type == STATIC else 0
    proxy.traits = shape.traits | moves | fixed | (BULLET if body.bullet == 1 else 0)
    proxy.vertex_start = shape.vertex_start
    proxy.vertex_count = shape.vertex_count
    proxy.radius = shape.radius
    proxy.body = shape.body
    proxy.friction = shape.friction
    proxy.restitution = shape.restitution
    proxy.rolling_resistance = shape.rolling_resistance
    proxy.surface_speed = shape.surface_speed
