"""A substep of jointed bodies that touch nothing, by dense matrices, written from the laws.

Half of the force acts before the move, half after it. Before it, impulses along the rows of now bring the members to
where the joints are kept after it; after it, impulses along the rows of then make the speeds keep them, too. Springs
follow the implicit midpoint rule: their force is that of the place and speed in the middle of the substep.

Where no joint has limits, substeps that follow each other go from the middle of one to the middle of
the next, with the whole force between them, and what springs have still to give of the first: speeds are made to keep
the joints after the last one alone.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from sandbox.world import joint_records as kinds
from tests.naive.complementarity import INF, Law, Piece, driven, impulses, striving
from tests.naive.joint_rows import ANGLE, DRIVE, SPRING, errors, is_levered, jacobian

Array = np.ndarray
YIELD = 1e-4
"""A rigid row gives way to its impulse by this share of what its bodies would."""
DRAWN = 4.0
"""Most (m or rad) of an error that a second takes away."""
NEWTON = 40


@dataclass
class Jointed:
    """Bodies: pose, velocity and inverse masses, three numbers each. Impulses of every row (joint, slot) are those
    before the last move and those after it. `reach` is how far (m/s or rad/s) Newton's method had to go for the last
    move."""

    joints: Any
    rows: list[tuple[int, int]]
    pose: Array
    velocity: Array
    inverse: Array
    before: Array
    after: Array
    reach: float = 0.0

    def row_joints(self) -> list[tuple[Any, int]]:
        """Joint and slot of every row."""
        return [(self.joints[j], slot) for j, slot in self.rows]


@dataclass(frozen=True)
class Span:
    """How long a substep is (s), for how long forces act before its move, and by which share rigid rows yield to what
    they give in that time."""

    seconds: float
    acting: float
    yields: float


def half(seconds: float) -> Span:
    """A substep of which half the force acts before the move."""
    return Span(seconds, 0.5 * seconds, YIELD)


def whole(seconds: float) -> Span:
    """One whose velocities begin and end in the middle: twice the impulse for the same yield."""
    return Span(seconds, seconds, 0.5 * YIELD)


def substeps(part: Jointed, force: Array, seconds: float, count: int) -> Iterator[None]:
    """Advance by `count` substeps under an acceleration `force`."""
    weak = (kinds.MOTOR, kinds.TARGET, kinds.FRICTION)
    staggered = not any(joint.kind in weak or joint.limit for joint, _ in part.row_joints())
    springs = np.array([spring(joint, slot) is not None for joint, slot in part.row_joints()], bool)
    for k in range(count):
        between = staggered and k > 0
        span = whole(seconds) if between else half(seconds)
        moved = part.velocity + span.acting * force
        if between:
            moved = moved + part.inverse * (jacobian(part.pose, part.joints, part.rows).T @ (springs * part.before))
            if k == 1:
                part.before = np.where(springs, part.before, 2.0 * part.before)
        part.before, moved = before_the_move(part, moved, span)
        part.pose = part.pose + seconds * moved
        if staggered and k + 1 < count:
            part.velocity = moved
        else:
            part.before = np.where(springs, part.before, part.before * (0.5 * seconds / span.acting))
            part.after, part.velocity = after_the_move(part, moved + 0.5 * seconds * force, seconds)
        yield


def before_the_move(part: Jointed, velocity: Array, span: Span) -> tuple[Array, Array]:
    """Impulses and velocities that bring the bodies to where their joints are kept.

    Where the joints will be is no linear function of the velocities: Newton's method, with the derivatives of now. It
    begins with the impulses of the last substep, and one turn of it is enough where nothing is at a bound.
    """
    rows = jacobian(part.pose, part.joints, part.rows)
    push = part.inverse[:, None] * rows.T
    matrix = rows @ push
    ease = np.diag(matrix).copy()
    now = errors(part.pose, part.joints, part.rows)
    seconds = span.seconds
    found = part.before
    tried = velocity + push @ found
    for _ in range(1 if not any(map(may_be_bounded, *zip(*part.row_joints(), strict=True))) else NEWTON):
        ahead = errors(part.pose + seconds * tried, part.joints, part.rows)
        laws = []
        for r, (joint, slot) in enumerate(part.row_joints()):
            bent = (ahead[r] - now[r]) / seconds - rows[r] @ tried
            bend = bent if is_levered(part.pose, joint, slot) else 0.0
            beyond = part.before[r] - span.acting * preload(joint, slot)
            kept = left_over(joint, slot, now[r], span.yields * float(ease[r]) * beyond, seconds)
            laws.append(_law_before(joint, slot, Ahead(now[r], bent, bend, kept, float(ease[r]), swung(part, r)), span))
        last, found = found, impulses(matrix, rows @ velocity, laws)
        assert found is not None, "no choice of pieces fits"
        tried = velocity + push @ found
        if np.max(np.abs(found - last)) <= 1e-13 * np.max(np.abs(found)):
            break
    part.reach = float(np.max(np.abs(push @ (found - part.before)), initial=0.0))
    return found, tried


def after_the_move(part: Jointed, velocity: Array, seconds: float) -> tuple[Array, Array]:
    """Impulses and velocities that keep the joints. A spring pushes after the move as it has pushed before it."""
    rows = jacobian(part.pose, part.joints, part.rows)
    push = part.inverse[:, None] * rows.T
    matrix = rows @ push
    now = errors(part.pose, part.joints, part.rows)
    so_far = part.before
    laws = [
        _law_after(joint, slot, now[r], so_far[r], float(matrix[r, r]), seconds)
        for r, (joint, slot) in enumerate(part.row_joints())
    ]
    both = impulses(matrix, rows @ (velocity - push @ so_far), laws)
    assert both is not None, "no choice of pieces fits"
    return both - so_far, velocity + push @ (both - so_far)


def may_be_bounded(joint: Any, slot: int) -> bool:
    """Whether a row has a limit of some kind."""
    return slot == DRIVE or is_brake(joint, slot) or joint.kind in (kinds.MOTOR, kinds.TARGET, kinds.FRICTION)


def is_brake(joint: Any, slot: int) -> bool:
    """Whether a row keeps a speed, and no place."""
    return bool(joint.kind == kinds.FRICTION or (joint.kind == kinds.WHEEL and slot == ANGLE))


def strength(joint: Any, slot: int) -> float:
    """Most force (N) or torque (N m) of a row that keeps something."""
    if joint.kind == kinds.WHEEL and slot == ANGLE:
        return float(joint.max_motor)
    if joint.kind in (kinds.MOTOR, kinds.TARGET, kinds.FRICTION):
        return float(joint.max_torque if slot == ANGLE else joint.max_force)
    return INF


def spring(joint: Any, slot: int) -> tuple[float, float] | None:
    """(frequency 1/s, damping ratio) of a soft row."""
    if slot == SPRING:
        return float(joint.hertz), float(joint.damping_ratio)
    if joint.kind not in (kinds.WELD, kinds.MOTOR, kinds.TARGET) or slot == DRIVE:
        return None
    hertz, ratio = (
        (joint.angular_hertz, joint.angular_damping_ratio) if slot == ANGLE else (joint.hertz, joint.damping_ratio)
    )
    return (float(hertz), float(ratio)) if hertz > 0.0 else None


def swung(part: Jointed, r: int) -> float:
    """1 / the mass, of an angle 1 / the inertia, that a spring swings with its frequency: as if it pulled its bodies at
    their centres of mass. None of the twin's turns out of the way of its spring so easily that a substep could not
    follow, where springs are softer."""
    j, slot = part.rows[r]
    joint = part.joints[j]
    about = 2 if slot == ANGLE or (slot == SPRING and joint.kind == kinds.REVOLUTE) else 0
    return sum(float(part.inverse[3 * k + about]) for k in (int(joint.body_a), int(joint.body_b)) if k >= 0)


def preload(joint: Any, slot: int) -> float:
    """What a row that keeps something bears without giving way (N or N m)."""
    return float(joint[f"preload_{slot}"]) if slot <= ANGLE else 0.0


def left_over(joint: Any, slot: int, error: float, push: float, seconds: float) -> float:
    """What a rigid row, or a limit that is overrun, may have left of its error: what is too much for one substep.

    What it yields to the push that it has borne beyond its preload, as a speed (m/s), is no error.
    """
    if slot == DRIVE:
        error = max(error - float(joint.upper), 0.0) + min(error - float(joint.lower), 0.0) if joint.limit else 0.0
    else:
        error = error + seconds * push
    return math.copysign(max(abs(error) - DRAWN * seconds, 0.0), error)


@dataclass(frozen=True)
class Ahead:
    """What a row is before the move: its error `now` (m or rad), how much faster that grows than the speed along the
    row says at the pose looked at, how much of this springs are told, what it may have left, 1 / mass, and that of what
    its spring swings with its frequency."""

    now: float
    bent: float
    bend: float
    kept: float
    ease: float
    swung: float


def _law_before(joint: Any, slot: int, row: Ahead, span: Span) -> Law:
    seconds, acting = span.seconds, span.acting
    if slot == DRIVE:
        slowest, fastest = -INF, INF
        if joint.limit:
            slowest = (joint.lower + min(row.kept, 0.0) - row.now) / seconds - row.bent
            fastest = (joint.upper + max(row.kept, 0.0) - row.now) / seconds - row.bent
        return _drive(joint, acting, slowest, fastest)
    most = acting * strength(joint, slot)
    if is_brake(joint, slot):
        return striving(float(joint.motor_speed) if joint.kind == kinds.WHEEL else 0.0, 0.0, most)
    soft = spring(joint, slot)
    if soft is not None:
        place = row.now - (_rest(joint) if slot == SPRING else 0.0) + 0.5 * seconds * row.bend
        return _midpoint(*soft, place, 1.0 / row.swung, 0.5 * seconds, most)
    softness = span.yields * row.ease
    borne = softness * acting * preload(joint, slot)
    return striving((row.kept - row.now) / seconds - row.bent + borne, softness, most)


def _midpoint(hertz: float, ratio: float, place: float, mass: float, acting: float, strong: float) -> Law:
    """-(k (x + t u) + c u) t, the impulse of a spring and a damper in the time t at the speed u, solved for u."""
    omega = 2.0 * math.pi * hertz
    k, c = mass * omega * omega, 2.0 * ratio * mass * omega
    if k == 0.0 and c == 0.0:
        return [Piece(given=0.0)]
    slope = acting * (acting * k + c)
    return striving(-acting * k * place / slope, 1.0 / slope, strong)


def _rest(joint: Any) -> float:
    return float(joint.length if joint.kind == kinds.DISTANCE else joint.rest)


def _drive(joint: Any, acting: float, slowest: float, fastest: float) -> Law:
    runs = bool(joint.motor) and joint.kind != kinds.WHEEL
    if joint.limit and joint.lower >= joint.upper:
        return [Piece(slowest)]
    aim = float(joint.motor_speed) if runs else None
    return driven(aim, acting * float(joint.max_motor) if runs else 0.0, slowest, fastest)


def _law_after(joint: Any, slot: int, now: float, so_far: float, ease: float, seconds: float) -> Law:
    """Of the impulses before and after the move together, which may be as strong as the whole substep allows."""
    if slot == DRIVE:
        slowest, fastest = -INF, INF
        if joint.limit:
            slowest, fastest = min((joint.lower - now) / seconds, 0.0), max((joint.upper - now) / seconds, 0.0)
        return _drive(joint, seconds, slowest, fastest)
    if spring(joint, slot) is not None:
        return [Piece(given=2.0 * so_far)]
    aim = float(joint.motor_speed) if is_brake(joint, slot) and joint.kind == kinds.WHEEL else 0.0
    softness = YIELD * ease  # the part before the move has had its yield: a row at rest gives both halves alike
    return striving(aim + 2.0 * softness * so_far, softness, seconds * strength(joint, slot))
