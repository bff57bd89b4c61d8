"""What each row of a batch strives for, and with how much strength: rigid, soft, or up to a bound.

A row's impulse p makes `speed + bias + softness * p` zero, unless p would leave `low..high`.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Mask, Vector, load, root, select, spread
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.acting_time import compliance, look_ahead_share
from sandbox.engine.joints.direct.records import TURN
from sandbox.engine.joints.laws import (
    COMPLIANCE,
    IMPACT_COMPLIANCE,
    INFINITE,
    Pair,
    drive,
    spring_law,
    spring_mobility,
)
from sandbox.tables import Floats, Records
from sandbox.world.joint_records import FRICTION, MOTOR, PRISMATIC, REVOLUTE, TARGET, WELD, WHEEL


class Law(NamedTuple):
    """The law of a row at the present velocities."""

    bias: Vector
    softness: Vector
    low: Vector
    high: Vector
    stop: Vector


@kernel
def target_positions(
    v: Floats,
    batch: Records,
    frame: Records,
    row: Records,
    ahead: Vector,
    speed: Vector,
    seconds: float,
    acting: Vector,
    springs_acting: Vector,
) -> Law:
    """The law of a row while positions are solved.

    `ahead` is its error where the bodies will be at their present `speed` after `seconds`; forces act for `acting`
    seconds of the substep before the move, springs for `springs_acting`.
    """
    joint = batch.joints + frame.constants
    kept = batch.rows + row.kept
    stop = load(v, kept + at.STOP)
    if row.slot == 4:
        return _drive_to_move(v, batch, frame, row, ahead, speed, seconds, acting)
    limit = acting * strength(v, joint, frame.kind, row.slot)
    rest = load(v, kept + at.ERROR)
    if is_brake(frame.kind, row.slot):
        bias = -load(v, joint + at.MOTOR_SPEED) if frame.kind == WHEEL else spread(0.0)
        return Law(bias, spread(0.0), -limit, limit, stop)
    softness = compliance(batch) * load(v, kept + at.STIFFNESS)
    bias = (ahead - load(v, row.place + at.MAY_LEAVE)) / seconds - speed
    bias = bias - softness * acting * load(v, kept + at.PRELOAD)
    if row.slot == 3:
        turns = frame.kind == REVOLUTE or frame.kind == PRISMATIC or frame.kind == WHEEL
        rest = rest - load(v, joint + (at.REST if turns else at.LENGTH))
        bias, softness = _spring(v, batch, frame, row, rest, springs_acting)
    elif may_be_sprung(frame.kind):
        if row.slot < 2:  # a gap turns with a, of which the speed along a row knows nothing
            rest = rest + springs_acting * ((ahead - rest) / seconds - speed)
        sprung = row_hertz(v, joint, row.slot) > 0.0
        soft_bias, softer = _spring(v, batch, frame, row, rest, springs_acting)
        bias = select(sprung, soft_bias, bias)
        softness = select(sprung, softer, softness)
    return Law(bias, softness, -limit, limit, stop)


@inlined_kernel
def _spring(v: Floats, batch: Records, frame: Records, row: Records, rest: Vector, acting: Vector) -> Pair:
    """(bias, softness) of a row that is a spring so far from rest. Its force is that of a reduced mass, but it swings
    faster where its bodies turn out of its way."""
    joint = batch.joints + frame.constants
    kept = batch.rows + row.kept
    hertz = row_hertz(v, joint, row.slot)
    ratio = load(v, joint + (at.ANGULAR_DAMPING_RATIO if row.slot == 2 else at.DAMPING_RATIO))
    stiffness = load(v, kept + at.STIFFNESS)
    if row.axis == TURN:
        return spring_law(rest, hertz, ratio, stiffness, acting, look_ahead_share(v, batch, acting, hertz))
    mass_a = load(v, batch.seats + row.seat_1 + at.INVERSE_MASS)
    mass_b = load(v, batch.seats + row.seat_2 + at.INVERSE_MASS)
    if row.slot < 2:  # at most so easily, in whatever direction: the trace of both rows of a point, less the least
        other = kept + (at.KEPT_SIZE if row.slot == 0 else -at.KEPT_SIZE)
        stiffness = stiffness + load(v, other + at.STIFFNESS) - (mass_a + mass_b)
    mobility = spring_mobility(mass_a + mass_b, stiffness, hertz, acting)
    moves = mobility > 0.0
    faster = root(select(moves, stiffness / select(moves, mobility, 1.0), 1.0))
    return spring_law(rest, hertz, ratio, mobility, acting, look_ahead_share(v, batch, acting, hertz * faster))


@kernel
def target_velocities(
    v: Floats, batch: Records, frame: Records, row: Records, speed: Vector, seconds: float, halves: Mask
) -> Law:
    """The law of a row once its bodies have moved: only velocities count. Springs have had their say.

    Where forces act in `halves`, a row at rest gives the other half here: softness counts from that.
    """
    joint = batch.joints + frame.constants
    kept = batch.rows + row.kept
    stop = load(v, kept + at.STOP)
    impulse = load(v, kept + at.IMPULSE)
    relaxing = load(v, kept + at.RELAXING)
    if row.slot == 4:
        return _drive_to_relax(v, batch, frame, row, speed, seconds)
    if row.slot == 3:
        return Law(spread(0.0), spread(0.0), relaxing, relaxing, stop)
    braked = is_brake(frame.kind, row.slot) and frame.kind == WHEEL
    bias = -load(v, joint + at.MOTOR_SPEED) if braked else spread(0.0)
    softness = COMPLIANCE * load(v, kept + at.STIFFNESS)
    bias = select(halves, bias - softness * impulse, bias)
    limit = seconds * strength(v, joint, frame.kind, row.slot)
    low = -limit - impulse
    high = limit - impulse
    if may_be_sprung(frame.kind):
        sprung = row_hertz(v, joint, row.slot) > 0.0
        bias = select(sprung, 0.0, bias)
        softness = select(sprung, 0.0, softness)
        low = select(sprung, relaxing, low)
        high = select(sprung, relaxing, high)
    return Law(bias, softness, low, high, stop)


@kernel
def target_blow(v: Floats, batch: Records, frame: Records, row: Records, speed: Vector, seconds: float) -> Law:
    """The law of a row that acts in an impact: what is rigid keeps its speed, a stop what would pass it within the
    substep."""
    joint = batch.joints + frame.constants
    kept = batch.rows + row.kept
    stop = load(v, kept + at.STOP)
    none = spread(0.0)
    if row.slot == 4:
        locked = load(v, joint + at.LOWER) >= load(v, joint + at.UPPER)
        slowest, fastest = _speeds_to_stops(v, batch, frame, row, seconds)
        held = _held_stop(load(v, kept + at.HELD), load(v, kept + at.BLOW), speed, slowest, fastest)
        held = select(locked, 1.0, held)
        low = select(locked | (held < 0.0), spread(-INFINITE), 0.0)
        high = select(held > 0.0, spread(INFINITE), 0.0)
        return Law(-select(held > 0.0, slowest, fastest), none, low, high, held)
    soft = IMPACT_COMPLIANCE * load(v, kept + at.STIFFNESS)
    return Law(none, soft, spread(-INFINITE), spread(INFINITE), stop)


@inlined_kernel
def _held_stop(held: Vector, given: Vector, speed: Vector, slowest: Vector, fastest: Vector) -> Vector:
    """Which stop holds, given which one did and what it gives (N s or N m s): one lets go when it would pull, and none
    takes hold in the same turn, as its speed is then that of the stop but for rounding."""
    keeps = select(((held > 0.0) & (given >= 0.0)) | ((held < 0.0) & (given <= 0.0)), held, 0.0)
    passed = select(speed < slowest, 1.0, select(speed > fastest, spread(-1.0), 0.0))
    return select(held != 0.0, keeps, passed)


@inlined_kernel
def acts_in_blow(v: Floats, batch: Records, frame: Records, row: Records) -> Mask:
    """Whether a row acts in an impact. Forces give nothing in no time, however strong they are: springs, motors and
    brakes do not, nor does a stop against which a motor presses that nothing limits."""
    if row.slot == 4:
        stops = load(v, batch.rows + row.kept + at.STIFFNESS) > 0.0
        return stops if frame.limit == 1 and row.bounded == 1 else stops & ~stops
    strong = strength(v, batch.joints + frame.constants, frame.kind, row.slot) >= INFINITE
    return is_rigid(v, batch, frame, row) & strong


@inlined_kernel
def may_be_sprung(kind: int) -> bool:
    """Whether rows 0 to 2 of a kind may be springs."""
    return kind in (WELD, MOTOR, TARGET)


@inlined_kernel
def row_hertz(v: Floats, joint: int, slot: int) -> Vector:
    """Stiffness of a row of slots 0 to 2 of such a kind, where 0 is rigid, or of the spring in slot 3."""
    return load(v, joint + (at.ANGULAR_HERTZ if slot == 2 else at.HERTZ))


@inlined_kernel
def is_rigid(v: Floats, batch: Records, frame: Records, row: Records) -> Mask:
    """Whether a row keeps a place, and does so without a spring."""
    rigid = load(v, batch.rows + row.kept + at.STIFFNESS) > 0.0
    if row.slot > 2 or is_brake(frame.kind, row.slot):
        return rigid & ~rigid
    if may_be_sprung(frame.kind):
        rigid = rigid & (row_hertz(v, batch.joints + frame.constants, row.slot) == 0.0)
    return rigid


@inlined_kernel
def runs(frame: Records) -> bool:
    """Whether the row in slot 4 has a motor."""
    return bool(frame.motor == 1 and frame.kind != WHEEL)


@inlined_kernel
def is_brake(kind: int, slot: int) -> bool:
    """Whether a row of slots 0 to 2 keeps a speed rather than a place."""
    return kind == FRICTION or (kind == WHEEL and slot == 2)


@inlined_kernel
def strength(v: Floats, joint: int, kind: int, slot: int) -> Vector:
    """Most force (N) or torque (N m) of a row of slots 0 to 3."""
    if kind == WHEEL and slot == 2:
        return load(v, joint + at.MAX_MOTOR)
    if slot > 2 or kind not in (MOTOR, TARGET, FRICTION):
        return spread(INFINITE)
    return load(v, joint + (at.MAX_TORQUE if slot == 2 else at.MAX_FORCE))


@kernel
def _drive_to_move(
    v: Floats,
    batch: Records,
    frame: Records,
    row: Records,
    ahead: Vector,
    speed: Vector,
    seconds: float,
    acting: Vector,
) -> Law:
    joint = batch.joints + frame.constants
    kept = load(v, row.place + at.MAY_LEAVE)
    lower = load(v, joint + at.LOWER)
    upper = load(v, joint + at.UPPER)
    slowest = speed - (ahead - lower - select(kept < 0.0, kept, 0.0)) / seconds
    fastest = speed - (ahead - upper - select(kept > 0.0, kept, 0.0)) / seconds
    total = load(v, batch.rows + row.kept + at.IMPULSE)
    return _drive(v, batch, frame, row, speed, slowest, fastest, acting, total)


@kernel
def _drive_to_relax(v: Floats, batch: Records, frame: Records, row: Records, speed: Vector, seconds: float) -> Law:
    kept = batch.rows + row.kept
    impulse = load(v, kept + at.IMPULSE)
    slowest, fastest = _speeds_to_stops(v, batch, frame, row, seconds)
    total = impulse + load(v, kept + at.RELAXING)
    law = _drive(v, batch, frame, row, speed, slowest, fastest, spread(seconds), total)
    return Law(law.bias, law.softness, law.low - impulse, law.high - impulse, law.stop)


@inlined_kernel
def _speeds_to_stops(v: Floats, batch: Records, frame: Records, row: Records, seconds: float) -> tuple[Vector, Vector]:
    """The speeds that just reach the lower and the upper limit of a joint in so many seconds; 0 past one."""
    joint = batch.joints + frame.constants
    error = load(v, batch.rows + row.kept + at.ERROR)
    slowest = (load(v, joint + at.LOWER) - error) / seconds
    fastest = (load(v, joint + at.UPPER) - error) / seconds
    return select(slowest < 0.0, slowest, 0.0), select(fastest > 0.0, fastest, 0.0)


@kernel
def _drive(
    v: Floats,
    batch: Records,
    frame: Records,
    row: Records,
    speed: Vector,
    slowest: Vector,
    fastest: Vector,
    acting: Vector,
    total: Vector,
) -> Law:
    joint = batch.joints + frame.constants
    driven = runs(frame)
    most = acting * load(v, joint + at.MAX_MOTOR) if driven else spread(0.0)
    aim = load(v, joint + at.MOTOR_SPEED) if driven else speed
    lower = load(v, joint + at.LOWER)
    upper = load(v, joint + at.UPPER)
    stop = load(v, batch.rows + row.kept + at.STOP)
    has_limit = frame.limit == 1
    low, high, bias, stop = drive(has_limit, lower, upper, stop, aim, most, speed, slowest, fastest, total)
    return Law(bias, spread(0.0), low, high, stop)
