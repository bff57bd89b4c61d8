"""Sequential impulses, one contact after the other, written from the formulas.

A contact holds two bodies at anchors r_a and r_b. An impulse p at the anchors changes v_b by p / m_b, w_b by
(r_b x p) / I_b, and a by the opposite. The velocity of b against a at the anchors is what the impulses work on.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

Vector = np.ndarray


def cross(a: Vector, b: Vector) -> float:
    """Scalar cross product."""
    return float(a[0] * b[1] - a[1] * b[0])


def spin(w: float, r: Vector) -> Vector:
    """Velocity of a point at r from the centre of what turns with w."""
    return np.array([-w * r[1], w * r[0]])


def turn(cosine: float, sine: float, r: Vector) -> Vector:
    """r turned."""
    return np.array([cosine * r[0] - sine * r[1], sine * r[0] + cosine * r[1]])


@dataclass
class Body:
    """What the solver sees of a body; `delta` and the rotation count from the beginning of the step."""

    inverse_mass: float
    inverse_inertia: float
    velocity: Vector
    angular: float
    delta: Vector = field(default_factory=lambda: np.zeros(2))
    cosine: float = 1.0
    sine: float = 0.0


@dataclass
class Point:
    """A contact point: anchors from the centres, gap at the beginning of the step, accumulated impulses."""

    anchor_a: Vector
    anchor_b: Vector
    gap: float
    normal: float
    tangent: float


@dataclass
class Contact:
    """A contact of bodies a and b with its unit normal from a to b."""

    a: Body
    b: Body
    axis: Vector
    points: list[Point]
    friction: float
    surface_speed: float
    rolling_resistance: float
    rolling: float
    radius_a: float
    radius_b: float
    bouncy: bool = False

    @property
    def along(self) -> Vector:
        """Tangent: the normal turned clockwise."""
        return np.array([self.axis[1], -self.axis[0]])

    def push(self, point: Point, impulse: Vector) -> None:
        """Apply an impulse to b at its anchor and the opposite to a."""
        self.a.velocity = self.a.velocity - self.a.inverse_mass * impulse
        self.a.angular -= self.a.inverse_inertia * cross(point.anchor_a, impulse)
        self.b.velocity = self.b.velocity + self.b.inverse_mass * impulse
        self.b.angular += self.b.inverse_inertia * cross(point.anchor_b, impulse)

    def twist(self, impulse: float) -> None:
        """Apply an angular impulse to b and the opposite to a."""
        self.a.angular -= self.a.inverse_inertia * impulse
        self.b.angular += self.b.inverse_inertia * impulse

    def speed(self, point: Point, axis: Vector) -> float:
        """Speed of b against a at the point along an axis."""
        b = self.b.velocity + spin(self.b.angular, point.anchor_b)
        a = self.a.velocity + spin(self.a.angular, point.anchor_a)
        return float((b - a) @ axis)

    def mass(self, point: Point, axis: Vector) -> float:
        """Effective mass along an axis: impulse over change of speed; 0 when nothing can move."""
        inverse = (
            self.a.inverse_mass + self.a.inverse_inertia * cross(point.anchor_a, axis) ** 2
            + self.b.inverse_mass + self.b.inverse_inertia * cross(point.anchor_b, axis) ** 2
        )  # fmt: skip
        return 1.0 / inverse if inverse > 0.0 else 0.0

    def gap(self, point: Point) -> float:
        """Present gap: that of the beginning plus the way of two core points along the normal.

        Only the cores turn; the rounding lies around them in whatever direction the other shape is.
        """
        core_a = point.anchor_a - self.radius_a * self.axis
        core_b = point.anchor_b + self.radius_b * self.axis
        way_a = self.a.delta + turn(self.a.cosine, self.a.sine, core_a) - core_a
        way_b = self.b.delta + turn(self.b.cosine, self.b.sine, core_b) - core_b
        return point.gap + float((way_b - way_a) @ self.axis)


def warm_start(contacts: list[Contact]) -> None:
    """Apply all accumulated impulses again."""
    for contact in contacts:
        contact.twist(contact.rolling)
        for point in contact.points:
            contact.push(point, point.normal * contact.axis + point.tangent * contact.along)


def solve(
    contacts: list[Contact], seconds: float, bias: float, mass: float, impulse: float, push: float, allowance: float
) -> None:
    """One pass. `bias` (1/s), `mass` and `impulse` scale are the softness of overlaps, `push` (m/s) bounds their speed.

    Points apart may close their gap within `seconds`, bouncy ones with `allowance` (m/s) on top.
    """
    for contact in contacts:
        for point in contact.points:
            gap = contact.gap(point)
            speed = contact.speed(point, contact.axis)
            m = contact.mass(point, contact.axis)
            if gap > 0.0:
                wanted = -m * (speed + gap / seconds + (allowance if contact.bouncy else 0.0))
            else:
                wanted = -m * mass * (speed + max(bias * gap, -push)) - impulse * point.normal
            after = max(point.normal + wanted, 0.0)
            contact.push(point, (after - point.normal) * contact.axis)
            point.normal = after
        for point in contact.points:
            limit = contact.friction * point.normal
            slip = contact.speed(point, contact.along) - contact.surface_speed
            after = min(max(point.tangent - contact.mass(point, contact.along) * slip, -limit), limit)
            contact.push(point, (after - point.tangent) * contact.along)
            point.tangent = after
        turning = contact.a.inverse_inertia + contact.b.inverse_inertia
        if contact.rolling_resistance > 0.0 and turning > 0.0:
            limit = contact.rolling_resistance * sum(point.normal for point in contact.points)
            after = contact.rolling - (contact.b.angular - contact.a.angular) / turning
            after = min(max(after, -limit), limit)
            contact.twist(after - contact.rolling)
            contact.rolling = after
