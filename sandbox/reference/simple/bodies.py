"""A body as the simple solver sees it."""

from __future__ import annotations

import math
from dataclasses import dataclass

from sandbox._jit import interpreted
from sandbox.geometry.trig import cos_sin

_cos_sin = interpreted(cos_sin)


@dataclass(slots=True, eq=False)
class Body:
    """What the solver sees of a body. `moved` and `turned` count from the beginning of the step."""

    inverse_mass: float
    inverse_inertia: float
    velocity: complex
    angular: float
    center: complex = 0j
    angle: float = 0.0
    dynamic: bool = True
    gravity_scale: float = 1.0
    linear_damping: float = 0.0
    angular_damping: float = 0.0
    moved: complex = 0j
    turned: complex = 1 + 0j

    def gain_speed(self, gravity: complex, h: float) -> None:
        """Gravity and damping during `h` seconds."""
        if self.dynamic:
            self.velocity = (self.velocity + h * self.gravity_scale * gravity) * math.exp(-h * self.linear_damping)
            self.angular *= math.exp(-h * self.angular_damping)

    def move(self, h: float) -> None:
        """Go on at the velocity of now for `h` seconds (semi-implicit Euler)."""
        self.center += h * self.velocity
        self.moved += h * self.velocity
        self.angle += h * self.angular
        self.turned *= turn(h * self.angular)

    @property
    def rotation(self) -> complex:
        """The number of length 1 that turns from the body's frame into the world's."""
        return turn(self.angle)

    def at(self, anchor: complex) -> complex:
        """Velocity of a point of the body."""
        return self.velocity + 1j * self.angular * anchor


def turn(angle: float) -> complex:
    """The number of length 1 that turns by an angle (rad), the same on every machine."""
    return complex(*_cos_sin(angle))
