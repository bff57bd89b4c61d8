"""The law of a contact as the engine has it: both its points alike, one friction for both.

On the bodies and contacts of the simple solver, which takes points in turn. The two points are taken in turn in either
order, and get the mean.
"""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.reference.simple.contacts import Contact, Point
from sandbox.reference.simple.solver import Pass
from sandbox.reference.simple.vectors import clamp, cross


@dataclass(eq=False)
class Pair(Contact):
    """A contact whose friction acts at one place during a step: where its points bore when the step began."""

    def __post_init__(self) -> None:
        super().__post_init__()
        self.friction_at = bearing(self)


def warm_start(contacts: list[Pair]) -> None:
    """Give all impulses of the last substep again."""
    for c in contacts:
        c.twist(c.rolling)
        for p in c.points:
            c.push(p, p.normal * c.normal)
        c.push(c.friction_at, sum(p.tangent for p in c.points) * c.tangent)


def solve(contacts: list[Pair], how: Pass, over_relaxation: float) -> None:
    """One pass over all contacts: push apart, then rub, then brake rolling."""
    for c in contacts:
        friction = sum(p.tangent for p in c.points)
        for p, normal in zip(c.points, normals(c, how, over_relaxation), strict=True):
            c.push(p, (normal - p.normal) * c.normal)
            p.normal = normal
        load = sum(p.normal for p in c.points)
        change = -c.mass(c.friction_at, c.tangent) * (c.speed(c.friction_at, c.tangent) - c.surface_speed)
        after = clamp(friction + change, c.friction * load)
        c.push(c.friction_at, (after - friction) * c.tangent)
        for p in c.points:
            p.tangent = after * (p.normal / load if load > 0.0 else 1.0 / len(c.points))
        if c.rolling_resistance > 0.0:
            change = -c.rolling_mass * (c.b.angular - c.a.angular)
            old, c.rolling = c.rolling, clamp(c.rolling + change, c.rolling_resistance * load)
            c.twist(c.rolling - old)


def bearing(c: Contact) -> Point:
    """The middle of what its points bear; the nearer one, if they bear nothing, or midway."""
    loads = [p.normal for p in c.points]
    if sum(loads) <= 0.0:
        loads = [float(p.first_gap == min(q.first_gap for q in c.points)) for p in c.points]
    shares = [load / sum(loads) for load in loads]
    return Point(
        sum(share * p.anchor_a for share, p in zip(shares, c.points, strict=True)),
        sum(share * p.anchor_b for share, p in zip(shares, c.points, strict=True)),
        0.0,
    )


def normals(c: Contact, how: Pass, over_relaxation: float) -> list[float]:
    """The normal impulses of all points: the mean over both orders, and beyond it as far as both pushed evenly."""
    if len(c.points) == 1:
        return _in_turn(c, how, [0])
    there, back = _in_turn(c, how, [0, 1]), _in_turn(c, how, [1, 0])
    mean = [(x + y) / 2 for x, y in zip(there, back, strict=True)]
    before = [p.normal for p in c.points]
    evenly = before[0] * before[1] / (sum(before) / 2) ** 2 if min(before) > 0.0 else 0.0
    far = 1.0 + over_relaxation * evenly
    return [max(p.normal + far * (x - p.normal), 0.0) for p, x in zip(c.points, mean, strict=True)]


def _in_turn(c: Contact, how: Pass, order: list[int]) -> list[float]:
    """What a pass over the points in an order would give them."""
    found = [p.normal for p in c.points]
    for n in order:
        p, gap = c.points[n], c.gap(c.points[n])
        speed = c.speed(p, c.normal)
        for m, q in enumerate(c.points):
            speed += _answer(c, p, q) * (found[m] - q.normal)
        change = -c.mass(p, c.normal) * (speed + how.rate * gap)
        if gap <= 0.0:
            wanted = min(-how.bias * gap, how.push)
            softness = how.impulse * (wanted / (-how.bias * gap) if -how.bias * gap > how.push else 1.0)
            change = -c.mass(p, c.normal) * how.mass * (speed - wanted) - softness * p.normal
        found[n] = max(p.normal + change, 0.0)
    return found


def _answer(c: Contact, p: Point, q: Point) -> float:
    """Change of normal speed at p for an impulse of 1 N s along the normal at q."""
    turn_a = c.a.inverse_inertia * cross(p.anchor_a, c.normal) * cross(q.anchor_a, c.normal)
    turn_b = c.b.inverse_inertia * cross(p.anchor_b, c.normal) * cross(q.anchor_b, c.normal)
    return c.a.inverse_mass + c.b.inverse_mass + turn_a + turn_b
