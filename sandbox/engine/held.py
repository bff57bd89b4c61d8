"""What holds a body in mid-step, and the blow that it gives if they have touched all the while."""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.tables import Records


@kernel
def note_hold(hold: Records, s: Records, a: Records, b: Records, second: bool, t: float) -> None:
    """Note where the sweep `s` of two shapes stops a body at time t, and how; `second` if it is that of b."""
    restitution: float = a.restitution if a.restitution > b.restitution else b.restitution
    hold.restitution = restitution
    hold.friction = math.sqrt(a.friction * b.friction)
    hold.surface_speed = a.surface_speed + b.surface_speed
    hold.bounces = 1 if restitution > 0.0 else 0
    hold.struck = s.touched
    hold.normal_x = s.normal_x if second else -s.normal_x
    hold.normal_y = s.normal_y if second else -s.normal_y
    hold.arm_x = s.point_x - (s.x + t * s.way_x if second else 0.0)
    hold.arm_y = s.point_y - (s.y + t * s.way_y if second else 0.0)


@kernel
def strike_held(body: Records, hold: Records, threshold: float) -> None:
    """Strike a body at what has touched it from the start of the step and yet lets it in, there where it is stopped.

    The solver had its turn already: a fast spinner swung away from where it touched, whereupon its contact gave back
    what it had pushed, or a corner came in that was not foreseen. Without a blow the next step would end as this one.
    """
    nx = hold.normal_x
    ny = hold.normal_y
    closing = -_speed(body, hold, nx, ny)
    if closing <= 0.0:
        return
    bounce = hold.restitution if closing > threshold else 0.0
    impulse = (1.0 + bounce) * closing / _inverse_mass(body, hold, nx, ny)
    _kick(body, hold, impulse, nx, ny)
    slip = _speed(body, hold, ny, -nx) - hold.surface_speed
    limit = hold.friction * impulse
    rub = -slip / _inverse_mass(body, hold, ny, -nx)
    rub = rub if rub < limit else limit
    rub = rub if rub > -limit else -limit
    _kick(body, hold, rub, ny, -nx)


@kernel
def _speed(body: Records, hold: Records, x: float, y: float) -> float:
    """Speed (m/s) along the unit axis (x, y) of the point of a body where it is held."""
    vx = body.velocity_x - body.angular_velocity * hold.arm_y
    vy = body.velocity_y + body.angular_velocity * hold.arm_x
    return float(vx * x + vy * y)


@kernel
def _inverse_mass(body: Records, hold: Records, x: float, y: float) -> float:
    """One over the effective mass (1/kg) along the unit axis (x, y) where a body is held."""
    turn = hold.arm_x * y - hold.arm_y * x
    return float(body.inverse_mass + body.inverse_inertia * turn * turn)


@kernel
def _kick(body: Records, hold: Records, impulse: float, x: float, y: float) -> None:
    """Apply an impulse (N s) along the unit axis (x, y) where a body is held."""
    body.velocity_x += impulse * body.inverse_mass * x
    body.velocity_y += impulse * body.inverse_mass * y
    body.angular_velocity += impulse * body.inverse_inertia * (hold.arm_x * y - hold.arm_y * x)
