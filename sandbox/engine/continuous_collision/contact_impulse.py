"""What stops a body in mid-step, and the impulse that it gives if they have touched all the while."""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.contact_solver.law import clamp_to_cone
from sandbox.tables import Records


@kernel
def record_impact(impact: Records, s: Records, a: Records, b: Records, second: bool, t: float) -> None:
    """Note where the sweep `s` of two shapes stops a body at time t, and how; `second` if it is that of b."""
    restitution: float = a.restitution if a.restitution > b.restitution else b.restitution
    impact.restitution = restitution
    impact.friction = math.sqrt(a.friction * b.friction)
    impact.surface_speed = a.surface_speed + b.surface_speed
    impact.bounces = 1 if restitution > 0.0 else 0
    impact.touched = s.touched
    impact.normal_x = s.normal_x if second else -s.normal_x
    impact.normal_y = s.normal_y if second else -s.normal_y
    impact.arm_x = s.point_x - (s.x + t * s.translation_x if second else 0.0)
    impact.arm_y = s.point_y - (s.y + t * s.translation_y if second else 0.0)


@kernel
def apply_contact_impulse(body: Records, impact: Records, threshold: float) -> None:
    """Strike a body at what has touched it from the start of the step and yet lets it in, there where it is stopped.

    The solver had its turn already: a fast spinner swung away from where it touched, whereupon its contact gave back
    what it had pushed, or a corner came in that was not foreseen. Without it the next step would end as this one.
    """
    nx = impact.normal_x
    ny = impact.normal_y
    closing = -_speed(body, impact, nx, ny)
    if closing <= 0.0:
        return
    bounce = impact.restitution if closing > threshold else 0.0
    impulse = (1.0 + bounce) * closing / _inverse_mass(body, impact, nx, ny)
    _kick(body, impact, impulse, nx, ny)
    slip = _speed(body, impact, ny, -nx) - impact.surface_speed
    limit = impact.friction * impulse
    friction = clamp_to_cone(-slip / _inverse_mass(body, impact, ny, -nx), limit)
    _kick(body, impact, friction, ny, -nx)


@kernel
def _speed(body: Records, impact: Records, x: float, y: float) -> float:
    """Speed (m/s) along the unit axis (x, y) of the point of a body where it is held."""
    vx = body.velocity_x - body.angular_velocity * impact.arm_y
    vy = body.velocity_y + body.angular_velocity * impact.arm_x
    return float(vx * x + vy * y)


@kernel
def _inverse_mass(body: Records, impact: Records, x: float, y: float) -> float:
    """One over the effective mass (1/kg) along the unit axis (x, y) where a body is held."""
    turn = impact.arm_x * y - impact.arm_y * x
    return float(body.inverse_mass + body.inverse_inertia * turn * turn)


@kernel
def _kick(body: Records, impact: Records, impulse: float, x: float, y: float) -> None:
    """Apply an impulse (N s) along the unit axis (x, y) where a body is held."""
    body.velocity_x += impulse * body.inverse_mass * x
    body.velocity_y += impulse * body.inverse_mass * y
    body.angular_velocity += impulse * body.inverse_inertia * (impact.arm_x * y - impact.arm_y * x)
