"""A contact as the simple solver sees it.

An impulse p at anchors r_a and r_b, from the centres of bodies a and b, changes v_b by p / m_b and w_b by
(r_b x p) / I_b, and a by the opposite.
"""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.reference.simple.bodies import Body
from sandbox.reference.simple.vectors import cross, dot


@dataclass(slots=True, eq=False)
class Point:
    """A contact point: anchors from the centres, gap at the beginning of the step, impulses of now.

    `normal` and `tangent` (N s) are the accumulated impulses, `hardest` the greatest normal one of the step,
    `closing` (m/s) how fast the point closed in before. The masses (kg) are impulse over change of speed.
    """

    anchor_a: complex
    anchor_b: complex
    first_gap: float
    normal: float = 0.0
    tangent: float = 0.0
    feature: int = 0
    closing: float = 0.0
    hardest: float = 0.0
    normal_mass: float = 0.0
    tangent_mass: float = 0.0


@dataclass(eq=False)
class Contact:
    """Bodies a and b touch, or may soon. `normal` is of length 1, from a to b; radii are those of rounded corners."""

    a: Body
    b: Body
    normal: complex
    points: list[Point]
    friction: float = 0.5
    restitution: float = 0.0
    surface_speed: float = 0.0
    rolling_resistance: float = 0.0
    rolling: float = 0.0
    radius_a: float = 0.0
    radius_b: float = 0.0

    def __post_init__(self) -> None:
        """Work out what stays the same during a step."""
        self.tangent = -1j * self.normal
        turning = self.a.inverse_inertia + self.b.inverse_inertia
        self.rolling_mass = 1.0 / turning if turning > 0.0 else 0.0
        for p in self.points:
            p.normal_mass, p.tangent_mass = self.mass(p, self.normal), self.mass(p, self.tangent)

    def mass(self, p: Point, axis: complex) -> float:
        """Effective mass at a point: how much impulse along the axis changes the speed there by 1 m/s."""
        a, b = self.a, self.b
        inverse = a.inverse_mass + a.inverse_inertia * cross(p.anchor_a, axis) ** 2
        inverse += b.inverse_mass + b.inverse_inertia * cross(p.anchor_b, axis) ** 2
        return 1.0 / inverse if inverse > 0.0 else 0.0

    def speed(self, p: Point, axis: complex) -> float:
        """Speed of b against a at a point, along the axis."""
        return dot(self.b.at(p.anchor_b) - self.a.at(p.anchor_a), axis)

    def gap(self, p: Point) -> float:
        """Gap of now, negative for an overlap. A core turns with its body, the rounding around it does not."""
        core_a, core_b = p.anchor_a - self.radius_a * self.normal, p.anchor_b + self.radius_b * self.normal
        way_a = self.a.moved + (self.a.turned - 1.0) * core_a
        way_b = self.b.moved + (self.b.turned - 1.0) * core_b
        return p.first_gap + dot(way_b - way_a, self.normal)

    def push(self, p: Point, impulse: complex) -> None:
        """Give an impulse to b at a point, and the opposite to a."""
        self.a.velocity -= self.a.inverse_mass * impulse
        self.a.angular -= self.a.inverse_inertia * cross(p.anchor_a, impulse)
        self.b.velocity += self.b.inverse_mass * impulse
        self.b.angular += self.b.inverse_inertia * cross(p.anchor_b, impulse)

    def twist(self, impulse: float) -> None:
        """Give an angular impulse to b, and the opposite to a."""
        self.a.angular -= self.a.inverse_inertia * impulse
        self.b.angular += self.b.inverse_inertia * impulse

    def note_closing_speeds(self) -> None:
        """Remember how fast the points close in as the step begins."""
        for p in self.points:
            p.closing = -self.speed(p, self.normal)
