"""What stops a body in mid-step, and the impulse that the two give each other if they have touched all the while."""

from __future__ import annotations

import math
from typing import NamedTuple

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import (
    Anchors,
    apply_impulse,
    clamp_to_cone,
    effective_mass,
    pair_mass,
    pair_velocity,
    relative_velocity,
    set_pair_velocity,
)
from sandbox.tables import Records


class Touch(NamedTuple):
    """Where and how two bodies touch: the unit normal from the first to the second, and what their surfaces are."""

    normal_x: float
    normal_y: float
    restitution: float
    friction: float
    surface_speed: float


@kernel
def touch_of(s: Records, a: Records, b: Records) -> Touch:
    """How two shapes touch that the sweep `s` has brought together."""
    restitution: float = a.restitution if a.restitution > b.restitution else b.restitution
    friction = math.sqrt(a.friction * b.friction)
    return Touch(s.normal_x, s.normal_y, restitution, friction, a.surface_speed + b.surface_speed)


@kernel
def anchors_at(s: Records, t: float) -> Anchors:
    """Where they touch at time t of the sweep."""
    return Anchors(
        s.point_x, s.point_y, s.point_x - (s.x + t * s.translation_x), s.point_y - (s.y + t * s.translation_y)
    )


@kernel
def record_impact(impact: Records, s: Records, a: Records, b: Records, second: bool, t: float) -> None:
    """Note where the sweep `s` of two shapes stops a body at time t, and how; `second` if it is that of b."""
    touch = touch_of(s, a, b)
    anchors = anchors_at(s, t)
    impact.other = a.body if second else b.body
    impact.restitution = touch.restitution
    impact.friction = touch.friction
    impact.surface_speed = touch.surface_speed
    impact.bounces = 1 if touch.restitution > 0.0 else 0
    impact.touched = s.touched
    impact.normal_x = s.normal_x if second else -s.normal_x
    impact.normal_y = s.normal_y if second else -s.normal_y
    impact.arm_x = anchors.bx if second else anchors.ax
    impact.arm_y = anchors.by if second else anchors.ay


@kernel
def strike_static(bodies: Records, body: int, impact: Records, threshold: float) -> None:
    """Strike a body at the static one that has touched it from the start of the step and yet lets it in."""
    touch = Touch(impact.normal_x, impact.normal_y, impact.restitution, impact.friction, impact.surface_speed)
    anchors = Anchors(0.0, 0.0, impact.arm_x, impact.arm_y)
    apply_contact_impulse(bodies[impact.other], bodies[body], anchors, touch, threshold)


@kernel
def apply_contact_impulse(a: Records, b: Records, r: Anchors, touch: Touch, threshold: float) -> None:
    """Part two bodies where they have touched from the start of the step and yet come into each other.

    The solver had its turn already: a fast spinner swung away from where it touched, whereupon its contact gave back
    what it had pushed, or a corner came in that was not foreseen. Without it the next step would end as this one.
    """
    nx = touch.normal_x
    ny = touch.normal_y
    m = pair_mass(a, b)
    v = pair_velocity(a, b)
    x, y = relative_velocity(v, r)
    closing = -(x * nx + y * ny)
    if closing <= 0.0:
        return
    bounce = touch.restitution if closing > threshold else 0.0
    impulse = (1.0 + bounce) * closing * effective_mass(m, r, nx, ny)
    v = apply_impulse(v, m, r, impulse * nx, impulse * ny)
    x, y = relative_velocity(v, r)
    slip = x * ny - y * nx - touch.surface_speed
    friction = clamp_to_cone(-slip * effective_mass(m, r, ny, -nx), touch.friction * impulse)
    v = apply_impulse(v, m, r, friction * ny, -(friction * nx))
    set_pair_velocity(a, b, v)
