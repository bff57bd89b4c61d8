"""What each row strives for, and with how much strength: rigid, soft, or up to a bound.

A row's impulse p makes `speed + bias + softness * p` zero, unless p would leave `low..high`.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.joints.laws import CORRECTION_SPEED, INFINITE, drive, spring_law, spring_mobility
from sandbox.tables import Records
from sandbox.world.joint_records import FRICTION, MOTOR, PRISMATIC, REVOLUTE, TARGET, WELD, WHEEL


@kernel
def is_steady(row: Records, joint: Records) -> bool:
    """Whether all sweeps of a substep find the same law for a row: it depends neither on speeds nor on impulses."""
    return not (row.slot == 4 or joint.kind == MOTOR or joint.kind == TARGET or joint.kind == FRICTION)


@kernel
def target_softly(
    members: Records,
    row: Records,
    joint: Records,
    speed: float,
    seconds: float,
    push: float,
    give: float,
    units_per_meter: float,
) -> None:
    """The law of a row of a part whose joints are soft; errors are those of now.

    `push` (1/s) turns an error into the speed that takes it back, `give` is the softness of rigid rows as a share of
    their stiffness. Without push nothing but velocities counts, and springs have had their say.
    """
    turns = _counts_radians(row)
    unit = 1.0 if turns else units_per_meter
    row.softness = 0.0
    row.low = -INFINITE
    row.high = INFINITE
    sprung = row.slot == 3 or row_hertz(row, joint) > 0.0
    if row.slot == 4:
        slowest = -INFINITE
        fastest = INFINITE
        if joint.limit == 1:
            slowest = _speed_to_limit(joint.lower - row.error, seconds, push, unit)
            fastest = -_speed_to_limit(row.error - joint.upper, seconds, push, unit)
        _drive(row, joint, speed, slowest, fastest, seconds)
    elif sprung and push == 0.0:
        row.low = row.high = row.impulse
        row.bias = 0.0
    elif sprung:
        rest = row.error - _rest(joint) if row.slot == 3 else row.error
        hertz = joint.hertz if row.slot == 3 else row_hertz(row, joint)
        ratio = joint.angular_damping_ratio if row.slot == 2 else joint.damping_ratio
        mobility = row.stiffness
        if not turns:
            straight = members[row.member_1].inverse_mass + members[row.member_2].inverse_mass
            mobility = spring_mobility(straight, row.easiest, hertz, seconds)
        row.bias, row.softness = spring_law(rest, hertz, ratio, mobility, seconds)
        _bound(row, seconds * strength(row, joint))
    elif is_brake(row, joint):
        row.bias = -joint.motor_speed if joint.kind == WHEEL else 0.0
        _bound(row, seconds * strength(row, joint))
    else:
        within = limited_push(row.error, push, unit)
        row.bias = push * within
        # Where the push is cut the row grows stiffer, so that it gives way no further than the same spring would.
        row.softness = give * row.stiffness * (within / row.error if push > 0.0 and within != row.error else 1.0)
        _bound(row, seconds * strength(row, joint))


@kernel
def _counts_radians(row: Records) -> bool:
    """Whether the error of a row is an angle: it turns its first two members, and pushes them nowhere."""
    return bool(row.x1 == 0.0 and row.y1 == 0.0 and row.x2 == 0.0 and row.y2 == 0.0)


@kernel
def _speed_to_limit(beyond: float, seconds: float, push: float, unit: float) -> float:
    """Least speed away from a limit that has been passed by so much: less than zero while it is not."""
    return beyond / seconds if beyond < 0.0 else push * limited_push(beyond, push, unit)


@kernel
def limited_push(error: float, push: float, unit: float) -> float:
    """An error, as far as it may be pushed back with `CORRECTION_SPEED`, of which a metre has so many units."""
    most = CORRECTION_SPEED * unit / push if push > 0.0 else 0.0
    return most if error > most else (-most if error < -most else error)


@kernel
def row_hertz(row: Records, joint: Records) -> float:
    """Stiffness of a row that the kind itself keeps; 0 is rigid."""
    if row.slot > 2 or not (joint.kind == WELD or joint.kind == MOTOR or joint.kind == TARGET):
        return 0.0
    return float(joint.angular_hertz if row.slot == 2 else joint.hertz)


@kernel
def is_rigid(row: Records, joint: Records) -> bool:
    """Whether a row keeps a place, and does so without a spring."""
    return bool(row.slot < 3 and row.stiffness > 0.0 and row_hertz(row, joint) == 0.0 and not is_brake(row, joint))


@kernel
def is_brake(row: Records, joint: Records) -> bool:
    """Whether a row of slots 0 to 2 keeps a speed rather than a place."""
    return bool(joint.kind == FRICTION or (joint.kind == WHEEL and row.slot == 2))


@kernel
def strength(row: Records, joint: Records) -> float:
    """Most force (N) or torque (N m) of a row of slots 0 to 3."""
    if joint.kind == WHEEL and row.slot == 2:
        return float(joint.max_motor)
    if row.slot > 2 or not (joint.kind == MOTOR or joint.kind == TARGET or joint.kind == FRICTION):
        return INFINITE
    return float(joint.max_torque if row.slot == 2 else joint.max_force)


@kernel
def _bound(row: Records, limit: float) -> None:
    row.low = -limit
    row.high = limit


@kernel
def _rest(joint: Records) -> float:
    turns = joint.kind == REVOLUTE or joint.kind == PRISMATIC or joint.kind == WHEEL
    return float(joint.rest if turns else joint.length)


@kernel
def _drive(row: Records, joint: Records, speed: float, slowest: float, fastest: float, seconds: float) -> None:
    runs = joint.motor == 1 and joint.kind != WHEEL
    most = seconds * joint.max_motor if runs else 0.0
    aim = joint.motor_speed if runs else speed
    stop = float(row.stop)
    has_limit = joint.limit == 1
    row.low, row.high, row.bias, stop = drive(
        has_limit, joint.lower, joint.upper, stop, aim, most, speed, slowest, fastest, row.impulse
    )
    row.stop = int(stop)


@kernel
def pair_strength(row: Records, joint: Records) -> float:
    """Most force (N) of rows 0 and 1 together, where they share a limit in all directions."""
    return strength(row, joint) if joint.kind == MOTOR or joint.kind == TARGET or joint.kind == FRICTION else INFINITE
