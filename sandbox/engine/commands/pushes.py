"""Commands that push a body: forces for the next step, and impulses at once."""

from __future__ import annotations

import math
from dataclasses import dataclass

from sandbox.engine.commands.base import Vec
from sandbox.engine.commands.body_command import BodyCommand, needs_dynamic
from sandbox.engine.commands.checks import SPEED_LIMIT, title
from sandbox.errors import CommandError
from sandbox.tables import FloatWords
from sandbox.world.records import BodyPlace as At
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
        body, flags = state.body_words(row)
        needs_dynamic(flags, self)
        x, y = self.force
        force = (body[At.FORCE_X] + x, body[At.FORCE_Y] + y)
        torque = body[At.TORQUE] + self.torque + _moment(body, self.force, self.point)
        if not (math.isfinite(force[0]) and math.isfinite(force[1]) and math.isfinite(torque)):
            raise CommandError(f"{title(self)}: the forces on the body add up to infinity")
        body[At.FORCE_X], body[At.FORCE_Y] = force
        body[At.TORQUE] = torque


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
        body, flags = state.body_words(row)
        needs_dynamic(flags, self)
        x, y = self.impulse
        moment = self.angular_impulse + _moment(body, self.impulse, self.point)
        inverse_mass = body[At.INVERSE_MASS]
        velocity = body[At.VELOCITY_X] + x * inverse_mass, body[At.VELOCITY_Y] + y * inverse_mass
        turning = body[At.ANGULAR_VELOCITY] + moment * body[At.INVERSE_INERTIA]
        if not (abs(velocity[0]) <= SPEED_LIMIT and abs(velocity[1]) <= SPEED_LIMIT and abs(turning) <= SPEED_LIMIT):
            text = f"would make it faster than the limit of {SPEED_LIMIT:g} m/s or rad/s"
            raise CommandError(f"{title(self)}: {text}")
        body[At.VELOCITY_X], body[At.VELOCITY_Y] = velocity
        body[At.ANGULAR_VELOCITY] = turning


def _moment(body: FloatWords, push: Vec, point: Vec | None) -> float:
    """Moment of a push at a place in the world about the body's centre of mass."""
    if point is None:
        return 0.0
    return (point[0] - body[At.CENTER_X]) * push[1] - (point[1] - body[At.CENTER_Y]) * push[0]
