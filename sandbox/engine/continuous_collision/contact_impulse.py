"""What holds a body in mid-step, and the blow that it gives if they have touched all the while."""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.tables import Records


@kernel
def note_stop(stop: Records, s: Records, a: Records, b: Records, second: bool, t: float) -> None:
    """Note where the sweep `s` of two shapes stops a body at time t, and how; `second` if it is that of b."""
    restitution: float = a.restitution if a.restitution > b.restitution else b.restitution
    stop.restitution = restitution
    stop.friction = math.sqrt(a.friction * b.friction)
    stop.surface_speed = a.surface_speed + b.surface_speed
    stop.bounces = 1 if restitution > 0.0 else 0
    stop.struck = s.touched
    stop.normal_x = s.normal_x if second else -s.normal_x
    stop.normal_y = s.normal_y if second else -s.normal_y
    stop.arm_x = s.point_x - (s.x + t * s.way_x if second else 0.0)
    stop.arm_y = s.point_y - (s.y + t * s.way_y if second else 0.0)


@kernel
def strike_held(body: Records, stop: Records, threshold: float) -> None:
    """Strike a body at what has touched it from the start of the step and yet lets it in, there where it is stopped.

    The solver had its turn already: a fast spinner swung away from where it touched, whereupon its contact gave back
    what it had pushed, or a corner came in that was not foreseen. Without a blow the next step would end as this one.
    """
    nx = stop.normal_x
    ny = stop.normal_y
    closing = -_speed(body, stop, nx, ny)
    if closing <= 0.0:
        return
    bounce = stop.restitution if closing > threshold else 0.0
    impulse = (1.0 + bounce) * closing / _inverse_mass(body, stop, nx, ny)
    _kick(body, stop, impulse, nx, ny)
    slip = _speed(body, stop, ny, -nx) - stop.surface_speed
    limit = stop.friction * impulse
    rub = -slip / _inverse_mass(body, stop, ny, -nx)
    rub = rub if rub < limit else limit
    rub = rub if rub > -limit else -limit
    _kick(body, stop, rub, ny, -nx)


@kernel
def _speed(body: Records, stop: Records, x: float, y: float) -> float:
    """Speed (m/s) along the unit axis (x, y) of the point of a body where it is held."""
    vx = body.velocity_x - body.angular_velocity * stop.arm_y
    vy = body.velocity_y + body.angular_velocity * stop.arm_x
    return float(vx * x + vy * y)


@kernel
def _inverse_mass(body: Records, stop: Records, x: float, y: float) -> float:
    """One over the effective mass (1/kg) along the unit axis (x, y) where a body is held."""
    turn = stop.arm_x * y - stop.arm_y * x
    return float(body.inverse_mass + body.inverse_inertia * turn * turn)


@kernel
def _kick(body: Records, stop: Records, impulse: float, x: float, y: float) -> None:
    """Apply an impulse (N s) along the unit axis (x, y) where a body is held."""
    body.velocity_x += impulse * body.inverse_mass * x
    body.velocity_y += impulse * body.inverse_mass * y
    body.angular_velocity += impulse * body.inverse_inertia * (stop.arm_x * y - stop.arm_y * x)
