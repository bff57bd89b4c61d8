"""Commands that push a body: forces for the next step, and impulses at once."""

from __future__ import annotations

import math
from dataclasses import dataclass

from sandbox.engine.commands.base import Vec
from sandbox.engine.commands.body_command import BodyCommand, needs_dynamic
from sandbox.engine.commands.checks import SPEED_LIMIT, title
from sandbox.errors import CommandError
from sandbox.tables import Records
from sandbox.world.state import State


@dataclass(frozen=True)
class ApplyForce(BodyCommand):
    """Push a dynamic body during the next step: force (N) and torque (N m). Adds up.

    The force acts on the centre of mass, or on `point`, a place in the world (m), as it is when the command comes.
    """

    force: Vec
    torque: float = 0.0
    point: Vec | None = None

    only_pushes = True

    def change(self, state: State, row: int) -> None:
        """Add to what pushes the body during the next step."""
        body = state.bodies[row]
        needs_dynamic(body, self)
        x, y = self.force
        force = (float(body.force_x) + x, float(body.force_y) + y)
        torque = float(body.torque) + self.torque + _moment(body, self.force, self.point)
        if not all(math.isfinite(value) for value in (*force, torque)):
            raise CommandError(f"{title(self)}: the forces on the body add up to infinity")
        body.force_x, body.force_y = force
        body.torque = torque


@dataclass(frozen=True)
class ApplyImpulse(BodyCommand):
    """Change the velocity of a dynamic body at once: impulse (N s) and angular impulse (N m s).

    The impulse acts on the centre of mass, or on `point`, a place in the world (m).
    """

    impulse: Vec
    angular_impulse: float = 0.0
    point: Vec | None = None

    only_pushes = True

    def change(self, state: State, row: int) -> None:
        """Change the body's velocity."""
        body = state.bodies[row]
        needs_dynamic(body, self)
        x, y = self.impulse
        moment = self.angular_impulse + _moment(body, self.impulse, self.point)
        velocity = (
            float(body.velocity_x) + x * float(body.inverse_mass),
            float(body.velocity_y) + y * float(body.inverse_mass),
        )
        turning = float(body.angular_velocity) + moment * float(body.inverse_inertia)
        if not all(abs(speed) <= SPEED_LIMIT for speed in (*velocity, turning)):
            text = f"would make it faster than the limit of {SPEED_LIMIT:g} m/s or rad/s"
            raise CommandError(f"{title(self)}: {text}")
        body.velocity_x, body.velocity_y = velocity
        body.angular_velocity = turning


def _moment(body: Records, push: Vec, point: Vec | None) -> float:
    """Moment of a push at a place in the world about the body's centre of mass."""
    if point is None:
        return 0.0
    return (point[0] - float(body.center_x)) * push[1] - (point[1] - float(body.center_y)) * push[0]
