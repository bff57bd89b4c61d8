"""What each row strives for, and with how much strength: rigid, soft, or up to a bound.

A row's impulse p makes `speed + bias + softness * p` zero, unless p would leave `low..high`.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.geometry.trig import PI
from sandbox.tables import Records
from sandbox.world.joint_records import FRICTION, MOTOR, PRISMATIC, REVOLUTE, TARGET, WELD, WHEEL

INFINITE = 1e300
COMPLIANCE = 1e-4
"""How far rigid rows give way, as a share of how far their members do: ropes that are drawn straight stay solvable."""
CORRECTION_SPEED = 4.0
"""Fastest recovery of what a joint keeps, after something else has pulled it apart, in m/s or rad/s."""


@kernel
def target_positions(row: Records, joint: Records, ahead: float, speed: float, seconds: float, acting: float) -> None:
    """The law of a row while positions are solved.

    `ahead` is its error where the members will be at their present `speed` after `seconds`; forces act for `acting`
    seconds of the substep, which is half of it where the other half follows after the move.
    """
    row.softness = 0.0
    row.low = -INFINITE
    row.high = INFINITE
    if row.slot == 4:
        _drive_to_move(row, joint, ahead, speed, seconds, acting)
    elif row.slot == 3 or row_hertz(row, joint) > 0.0:
        rest = row.error - _rest(joint) if row.slot == 3 else row.error
        if row.slot < 2 and row.levered == 1:  # a gap turns with a, of which the speed along a row knows nothing
            rest = rest + acting * ((ahead - row.error) / seconds - speed)
        hertz = joint.hertz if row.slot == 3 else row_hertz(row, joint)
        ratio = joint.angular_damping_ratio if row.slot == 2 else joint.damping_ratio
        omega = 2.0 * PI * hertz
        lag = 2.0 * ratio + acting * omega
        row.bias = omega * rest / lag if lag > 0.0 else 0.0
        row.softness = row.stiffness / (acting * omega * lag) if lag > 0.0 and omega > 0.0 else INFINITE
        _bound(row, acting * strength(row, joint))
    elif is_brake(row, joint):
        row.bias = -joint.motor_speed if joint.kind == WHEEL else 0.0
        _bound(row, acting * strength(row, joint))
    else:
        row.bias = (ahead - row.kept) / seconds - speed
        row.softness = COMPLIANCE * row.stiffness
        _bound(row, acting * strength(row, joint))


@kernel
def target_velocities(row: Records, joint: Records, speed: float, seconds: float, halves: bool) -> None:
    """The law of a row once its members have moved: only velocities count. Springs have had their say.

    Where forces act in `halves`, a row at rest gives the other half here: softness counts from that.
    """
    row.softness = 0.0
    row.low = -INFINITE
    row.high = INFINITE
    row.bias = 0.0
    if row.slot == 4:
        _drive_to_relax(row, joint, speed, seconds)
    elif row.slot == 3 or row_hertz(row, joint) > 0.0:
        row.low = row.high = row.relaxing
    else:
        row.bias = -joint.motor_speed if is_brake(row, joint) and joint.kind == WHEEL else 0.0
        row.softness = COMPLIANCE * row.stiffness
        if halves:
            row.bias = row.bias - row.softness * row.impulse
        limit = seconds * strength(row, joint)
        row.low = -limit - row.impulse
        row.high = limit - row.impulse


@kernel
def target_softly(row: Records, joint: Records, speed: float, seconds: float, push: float, give: float) -> None:
    """The law of a row of a part whose joints are soft; errors are those of now.

    `push` (1/s) turns an error into the speed that takes it back, `give` is the softness of rigid rows as a share of
    their stiffness. Without push nothing but velocities counts, and springs have had their say.
    """
    row.softness = 0.0
    row.low = -INFINITE
    row.high = INFINITE
    sprung = row.slot == 3 or row_hertz(row, joint) > 0.0
    if row.slot == 4:
        slowest = -INFINITE
        fastest = INFINITE
        if joint.limit == 1:
            slowest = _speed_to_limit(joint.lower - row.error, seconds, push)
            fastest = -_speed_to_limit(row.error - joint.upper, seconds, push)
        _drive(row, joint, speed, slowest, fastest, seconds, row.impulse)
    elif sprung and push == 0.0:
        row.low = row.high = row.impulse
        row.bias = 0.0
    elif sprung or is_brake(row, joint):
        target_positions(row, joint, row.error + seconds * speed, speed, seconds, seconds)
    else:
        within = limited_push(row.error, push)
        row.bias = push * within
        # Where the push is cut the row grows stiffer, so that it gives way no further than the same spring would.
        row.softness = give * row.stiffness * (within / row.error if push > 0.0 and within != row.error else 1.0)
        _bound(row, seconds * strength(row, joint))


@kernel
def _speed_to_limit(beyond: float, seconds: float, push: float) -> float:
    """Least speed away from a limit that has been passed by so much: less than zero while it is not."""
    return beyond / seconds if beyond < 0.0 else push * limited_push(beyond, push)


@kernel
def limited_push(error: float, push: float) -> float:
    """An error, as far as it may be pushed back with `CORRECTION_SPEED`."""
    most = CORRECTION_SPEED / push if push > 0.0 else 0.0
    return most if error > most else (-most if error < -most else error)


@kernel
def limited(error: float, seconds: float) -> float:
    """What is left of an error after one substep: nothing, unless it is large."""
    most = CORRECTION_SPEED * seconds
    return error - most if error > most else (error + most if error < -most else 0.0)


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
def _drive_to_move(row: Records, joint: Records, ahead: float, speed: float, seconds: float, acting: float) -> None:
    slowest = -INFINITE
    fastest = INFINITE
    if joint.limit == 1:
        slowest = speed - (ahead - joint.lower - (row.kept if row.kept < 0.0 else 0.0)) / seconds
        fastest = speed - (ahead - joint.upper - (row.kept if row.kept > 0.0 else 0.0)) / seconds
    _drive(row, joint, speed, slowest, fastest, acting, row.impulse)


@kernel
def _drive_to_relax(row: Records, joint: Records, speed: float, seconds: float) -> None:
    slowest = -INFINITE
    fastest = INFINITE
    if joint.limit == 1:
        slowest = (joint.lower - row.error) / seconds
        fastest = (joint.upper - row.error) / seconds
        slowest = slowest if slowest < 0.0 else 0.0
        fastest = fastest if fastest > 0.0 else 0.0
    _drive(row, joint, speed, slowest, fastest, seconds, row.impulse + row.relaxing)
    row.low = row.low - row.impulse
    row.high = row.high - row.impulse


@kernel
def _drive(
    row: Records, joint: Records, speed: float, slowest: float, fastest: float, acting: float, total: float
) -> None:
    """A motor with limits: it strives for its speed as far as its strength goes; a limit adds what is lacking.

    `slowest` and `fastest` are the speeds that just reach the lower and the upper limit, `total` the impulse so far.
    """
    runs = joint.motor == 1 and joint.kind != WHEEL
    most = acting * joint.max_motor if runs else 0.0
    aim = joint.motor_speed if runs else speed
    row.low = -most
    row.high = most
    if joint.limit == 1 and joint.lower >= joint.upper:
        aim = slowest
        row.low = -INFINITE
        row.high = INFINITE
    elif joint.limit == 1:
        row.stop = _find_stop(row.stop, aim, most, speed, slowest, fastest, total)
        if row.stop > 0:
            row.low = -most if aim < slowest else most
            row.high = INFINITE
            aim = slowest
        elif row.stop < 0:
            row.high = most if aim > fastest else -most
            row.low = -INFINITE
            aim = fastest
    row.bias = -aim


@kernel
def _find_stop(stop: int, aim: float, most: float, speed: float, slowest: float, fastest: float, total: float) -> int:
    """Which limit has a say: 1 the lower, -1 the upper, 0 none. One lets go once the motor alone would do."""
    if stop > 0 and total > (-most if aim < slowest else most):
        return 1
    if stop < 0 and total < (most if aim > fastest else -most):
        return -1
    if aim < slowest or (speed < slowest and total >= most):
        return 1
    if aim > fastest or (speed > fastest and total <= -most):
        return -1
    return 0


@kernel
def pair_strength(row: Records, joint: Records) -> float:
    """Most force (N) of rows 0 and 1 together, where they share a limit in all directions."""
    return strength(row, joint) if joint.kind == MOTOR or joint.kind == TARGET or joint.kind == FRICTION else INFINITE
