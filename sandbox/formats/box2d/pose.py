"""A joint of Box2D at the start: where its anchors are in the world, and how easily its bodies are moved."""

from __future__ import annotations

import math
from dataclasses import dataclass

from sandbox.formats.box2d.mass import central_inertia, mass_of
from sandbox.formats.box2d.world import Body, Joint
from sandbox.formats.numbers import Vec, turned
from sandbox.formats.remarks import Remarks


@dataclass(frozen=True)
class Pose:
    """A joint at the start: its bodies, anchors and axis in the world, and where remarks on it go."""

    joint: Joint
    a: Body
    b: Body
    remarks: Remarks

    @property
    def at_a(self) -> Vec:
        """Anchor of the first body, m."""
        return in_world(self.a, self.joint.anchor_a)

    @property
    def at_b(self) -> Vec:
        """Anchor of the second body, m."""
        return in_world(self.b, self.joint.anchor_b)

    @property
    def axis(self) -> Vec:
        """Unit vector of the axis."""
        x, y = turned(self.joint.axis, self.a.angle)
        length = math.hypot(x, y)
        return (x / length, y / length) if length > 1e-9 else (1.0, 0.0)

    @property
    def angle(self) -> float:
        """The angle that Box2D sees at the start, rad."""
        return self.b.angle - self.a.angle - self.joint.reference_angle

    @property
    def slide(self) -> float:
        """The translation that Box2D sees at the start, m."""
        (ax, ay), (bx, by), (x, y) = self.at_a, self.at_b, self.axis
        return (bx - ax) * x + (by - ay) * y

    def note(self, text: str, amount: str = "") -> None:
        """Something is otherwise, by so much."""
        self.remarks.note(self.joint.place + (f" ({amount})" if amount else ""), text)


def mobility(body: Body) -> float:
    """How easily a body is pushed, 1/kg."""
    return 1.0 / mass_of(body).mass if body.type == "dynamic" else 0.0


def turning(body: Body) -> float:
    """How easily a body is turned, 1/(kg m^2)."""
    inertia = central_inertia(mass_of(body)) if body.type == "dynamic" and not body.fixed_rotation else 0.0
    return 1.0 / inertia if inertia > 0.0 else 0.0


def in_world(body: Body, local: Vec) -> Vec:
    """A point of a body's frame in the world."""
    x, y = turned(local, body.angle)
    return body.position[0] + x, body.position[1] + y
