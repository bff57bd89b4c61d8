"""Commands that push a body: forces for the next step, and impulses at once."""

from __future__ import annotations

import math
from dataclasses import dataclass

from sandbox.errors import CommandError
from sandbox.tables import Records

Vec = tuple[float, float]

SPEED_LIMIT = 1e6
"""Highest velocity a command may set or cause, in m/s or rad/s."""


@dataclass(frozen=True)
class ApplyForce:
    """Push a dynamic body during the next step: force (N) and torque (N m). Adds up.

    The force acts on the centre of mass, or on `point`, a place in the world (m), as it is when the command comes.
    """

    body: str
    force: Vec
    torque: float = 0.0
    point: Vec | None = None


@dataclass(frozen=True)
class ApplyImpulse:
    """Change the velocity of a dynamic body at once: impulse (N s) and angular impulse (N m s).

    The impulse acts on the centre of mass, or on `point`, a place in the world (m).
    """

    body: str
    impulse: Vec
    angular_impulse: float = 0.0
    point: Vec | None = None


def apply_force(body: Records, command: ApplyForce) -> None:
    """Add to what pushes the body during the next step."""
    x, y = command.force
    force = (float(body.force_x) + x, float(body.force_y) + y)
    torque = float(body.torque) + command.torque + _moment(body, command.force, command.point)
    if not all(math.isfinite(value) for value in (*force, torque)):
        raise CommandError(f"ApplyForce of {command.body!r}: the forces on the body add up to infinity")
    body.force_x, body.force_y = force
    body.torque = torque


def apply_impulse(body: Records, command: ApplyImpulse) -> None:
    """Change the body's velocity."""
    x, y = command.impulse
    moment = command.angular_impulse + _moment(body, command.impulse, command.point)
    velocity = (
        float(body.velocity_x) + x * float(body.inverse_mass),
        float(body.velocity_y) + y * float(body.inverse_mass),
    )
    turning = float(body.angular_velocity) + moment * float(body.inverse_inertia)
    if not all(abs(speed) <= SPEED_LIMIT for speed in (*velocity, turning)):
        text = f"would make it faster than the limit of {SPEED_LIMIT:g} m/s or rad/s"
        raise CommandError(f"ApplyImpulse of {command.body!r}: {text}")
    body.velocity_x, body.velocity_y = velocity
    body.angular_velocity = turning


def _moment(body: Records, push: Vec, point: Vec | None) -> float:
    """Moment of a push at a place in the world about the body's centre of mass."""
    if point is None:
        return 0.0
    return (point[0] - float(body.center_x)) * push[1] - (point[1] - float(body.center_y)) * push[0]
