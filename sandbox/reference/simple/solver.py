"""Sequential impulses, to be read from top to bottom: what a step does, then what it is made of.

Each contact in turn gets the impulse that would put it right if it were the only one; going over all of them again and
again comes to what puts all right at once (E. Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005, and "Fast
and Simple Physics using Sequential Impulses", GDC 2006). Soft contacts and the relax pass are those of Box2D v3.

What a body and a contact can do is in `bodies.py` and `contacts.py`; vectors are complex numbers (`vectors.py`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from sandbox.reference.simple.bodies import Body
from sandbox.reference.simple.contacts import Contact
from sandbox.reference.simple.techniques import Techniques
from sandbox.reference.simple.vectors import clamp

BAUMGARTE = 0.2
"""Share of an overlap that is taken back in a substep where contacts are not soft."""


@dataclass(frozen=True)
class Numbers:
    """What is simulated: a step in s, gravity in m/s^2, the spring of contacts, and two speeds in m/s."""

    seconds: float = 1 / 60
    gravity: complex = -9.81j
    hertz: float = 57.0
    damping_ratio: float = 1.5
    push_out_speed: float = 3.0
    restitution_threshold: float = 0.2


@dataclass(frozen=True)
class Pass:
    """How one pass treats contacts. Points apart may close their gap at `rate` (1/s) times the gap.

    Points that overlap are pushed apart at `bias` (1/s) times the overlap, `push` m/s at most; `mass` and `impulse` are
    the shares that make it soft. With `accumulate` the sum of the impulses is clamped, without it each one.
    """

    rate: float
    bias: float = 0.0
    mass: float = 1.0
    impulse: float = 0.0
    push: float = 0.0
    accumulate: bool = True


def step(
    bodies: Iterable[Body], contacts: list[Contact], numbers: Numbers, on: Techniques, after: Callable[[], None]
) -> None:
    """Move bodies by one step. `after` is called after each pass over the contacts."""
    h = numbers.seconds / on.substeps
    rate = 1 / h if on.speculative else math.inf
    push = Pass(rate, *_softness(numbers, on, h), numbers.push_out_speed, on.accumulate)
    rest = Pass(rate, accumulate=on.accumulate)
    for contact in contacts:
        contact.note_closing_speeds()
    for _ in range(on.substeps):
        for body in bodies:
            body.gain_speed(numbers.gravity, h)
        if on.warm_starting and on.accumulate:
            warm_start(contacts)
        else:
            forget(contacts)
        for _ in range(on.iterations):
            solve(contacts, push)
            after()
        for body in bodies:
            body.move(h)
        for _ in range(on.iterations if on.relax else 0):
            solve(contacts, rest)
            after()
    bounce(contacts, numbers.restitution_threshold)


def warm_start(contacts: list[Contact]) -> None:
    """Give all impulses of the last substep again: a good guess of what this one needs."""
    for c in contacts:
        c.twist(c.rolling)
        for p in c.points:
            c.push(p, p.normal * c.normal + p.tangent * c.tangent)


def forget(contacts: list[Contact]) -> None:
    """Begin with nothing."""
    for c in contacts:
        c.rolling = 0.0
        for p in c.points:
            p.normal = p.tangent = 0.0


def solve(contacts: list[Contact], how: Pass) -> None:
    """One pass over all contacts: push apart, then rub, then brake rolling."""
    if not how.accumulate:
        forget(contacts)
    for c in contacts:
        for p in c.points:
            gap, speed = c.gap(p), c.speed(p, c.normal)
            if gap > 0.0:
                change = -p.normal_mass * (speed + how.rate * gap)
            else:
                wanted = min(-how.bias * gap, how.push)
                # Where the push is cut, the contact is stiffer: it sinks no deeper than the same spring without a cut.
                softness = how.impulse * (wanted / (-how.bias * gap) if -how.bias * gap > how.push else 1.0)
                change = -p.normal_mass * how.mass * (speed - wanted) - softness * p.normal
            before, p.normal = p.normal, max(p.normal + change, 0.0)  # a contact pushes and never pulls
            p.hardest = max(p.hardest, p.normal)
            c.push(p, (p.normal - before) * c.normal)
        for p in c.points:
            change = -p.tangent_mass * (c.speed(p, c.tangent) - c.surface_speed)
            before, p.tangent = p.tangent, clamp(p.tangent + change, c.friction * p.normal)
            c.push(p, (p.tangent - before) * c.tangent)
        if c.rolling_resistance > 0.0:
            load = sum(p.normal for p in c.points)
            change = -c.rolling_mass * (c.b.angular - c.a.angular)
            before, c.rolling = c.rolling, clamp(c.rolling + change, c.rolling_resistance * load)
            c.twist(c.rolling - before)


def bounce(contacts: list[Contact], threshold: float) -> None:
    """Points that have closed in faster than `threshold` (m/s) and pushed leave with their share of that speed."""
    for c in contacts:
        for p in c.points if c.restitution > 0.0 else ():
            if p.closing > threshold and p.hardest > 0.0:
                change = -p.normal_mass * (c.speed(p, c.normal) - c.restitution * p.closing)
                before, p.normal = p.normal, max(p.normal + change, 0.0)
                c.push(p, (p.normal - before) * c.normal)


def _softness(numbers: Numbers, on: Techniques, h: float) -> tuple[float, float, float]:
    """(bias 1/s, share of the mass, share of the impulse) of a spring with a damper, stepped implicitly by `h` s."""
    if not on.soft:
        return BAUMGARTE / h, 1.0, 0.0
    omega = 2 * math.pi * min(numbers.hertz, 0.25 / h)
    drag = 2 * numbers.damping_ratio + h * omega
    spring = h * omega * drag
    return omega / drag, spring / (1 + spring), 1 / (1 + spring)
