"""The rows of every joint of a net: in which direction each pushes its members, and how easily they give way."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.joints.laws import along, is_close, own_stiffness
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.targets import is_steady, row_hertz, target_softly
from sandbox.tables import Records
from sandbox.world.joint_records import (
    DISTANCE,
    FRICTION,
    GEAR,
    MOTOR,
    PRISMATIC,
    PULLEY,
    REVOLUTE,
    WHEEL,
)


@kernel
def fill_rows(work: JointWork, constraint: Records, joint: Records, seconds: float, push: float, give: float) -> None:
    """Jacobian, stiffness and present error of the rows of a joint, and what the steady ones strive for, as
    `target_softly` has it."""
    for r in range(constraint.first_row, constraint.first_row + constraint.row_count):
        row = work.rows[r]
        _fill(work, row, constraint, joint)
        row.stiffness = _stiffness(work.members, row)
        row.easiest = _easiest(work.members, row, constraint)
        row.error = row_error(row, constraint)
        row.steady = 1 if is_steady(row, joint) else 0
        if row.steady == 1:
            target_softly(work.members, row, joint, 0.0, seconds, push, give, work.direct.units[0])


@kernel
def row_error(row: Records, constraint: Records) -> float:
    """Error of a row at the pose its joint was measured at; for springs, limits and motors the place."""
    if row.slot >= 3:
        return float(constraint.place)
    return float(constraint.error_0 if row.slot == 0 else (constraint.error_1 if row.slot == 1 else constraint.error_2))


@kernel
def _fill(work: JointWork, row: Records, constraint: Records, joint: Records) -> None:
    kind = joint.kind
    if kind == GEAR:
        _fill_gear(work, row, constraint, joint.ratio)
    elif kind == PULLEY:
        _fill_pulley(row, constraint, joint.ratio)
    elif kind == DISTANCE:
        _along(row, constraint, constraint.axis_x, constraint.axis_y)
    elif kind in (PRISMATIC, WHEEL):
        if row.slot == 0:
            _along(row, constraint, -constraint.axis_y, constraint.axis_x)
        elif row.slot >= 3:
            _along(row, constraint, constraint.axis_x, constraint.axis_y)
        else:
            _about(row)
    elif row.slot == 2 or (kind == REVOLUTE and row.slot >= 3):
        _about(row)
    elif kind in (MOTOR, FRICTION) or row_hertz(row, joint) > 0.0 or _are_close(constraint):
        _along(row, constraint, 1.0 if row.slot == 0 else 0.0, 0.0 if row.slot == 0 else 1.0)
    elif row.slot == 0:
        _set(row, -1.0, 0.0, constraint.arm_ay, 1.0, 0.0, -constraint.arm_by)
    else:
        _set(row, 0.0, -1.0, -constraint.arm_ax, 0.0, 1.0, constraint.arm_bx)


@kernel
def _are_close(constraint: Records) -> bool:
    c = constraint
    return bool(is_close(c.arm_ax, c.arm_ay, c.arm_bx, c.arm_by, c.gap_x, c.gap_y))


@kernel
def _set(row: Records, x1: float, y1: float, w1: float, x2: float, y2: float, w2: float) -> None:
    row.x1 = x1
    row.y1 = y1
    row.w1 = w1
    row.x2 = x2
    row.y2 = y2
    row.w2 = w2


@kernel
def _about(row: Records) -> None:
    """Angle between the bodies."""
    _set(row, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0)


@kernel
def _along(row: Records, constraint: Records, x: float, y: float) -> None:
    c = constraint
    x1, y1, w1, x2, y2, w2 = along(c.arm_ax, c.arm_ay, c.arm_bx, c.arm_by, c.gap_x, c.gap_y, x, y)
    _set(row, x1, y1, w1, x2, y2, w2)


@kernel
def _fill_pulley(row: Records, constraint: Records, ratio: float) -> None:
    ax = constraint.axis_x
    ay = constraint.axis_y
    bx = ratio * constraint.gap_x
    by = ratio * constraint.gap_y
    _set(
        row,
        ax,
        ay,
        constraint.arm_ax * ay - constraint.arm_ay * ax,
        bx,
        by,
        constraint.arm_bx * by - constraint.arm_by * bx,
    )


@kernel
def _fill_gear(work: JointWork, row: Records, constraint: Records, ratio: float) -> None:
    """The second joint's coordinate goes to sides 3 and 4, the first one's to sides 1 and 2."""
    second = work.constraints[constraint.constraint_2]
    _fill_coordinate(work, row, second)
    row.x3 = ratio * row.x1
    row.y3 = ratio * row.y1
    row.w3 = ratio * row.w1
    row.x4 = ratio * row.x2
    row.y4 = ratio * row.y2
    row.w4 = ratio * row.w2
    first = work.constraints[constraint.constraint_1]
    _fill_coordinate(work, row, first)


@kernel
def _fill_coordinate(work: JointWork, row: Records, constraint: Records) -> None:
    if work.joints[constraint.joint].kind == PRISMATIC:
        _along(row, constraint, constraint.axis_x, constraint.axis_y)
    else:
        _about(row)


@kernel
def _stiffness(members: Records, row: Records) -> float:
    """J M^-1 J^T; a gear's sides may be the same member twice."""
    m1 = members[row.member_1]
    m2 = members[row.member_2]
    found = own_stiffness(
        m1.inverse_mass,
        m1.inverse_inertia,
        m2.inverse_mass,
        m2.inverse_inertia,
        (row.x1, row.y1, row.w1, row.x2, row.y2, row.w2),
    )
    if row.sides == 4:
        for k in range(1, 5):
            for m in range(1, 5):
                if (k > 2 or m > 2) and side_member(row, k) == side_member(row, m):
                    found = found + side_product(members, row, k, row, m)
    return float(found)


@kernel
def _easiest(members: Records, row: Records, constraint: Records) -> float:
    """J M^-1 J^T, of a point that is kept along x and y the most it can be along any axis."""
    if row.slot > 1 or row.sides == 4:
        return float(row.stiffness)
    a = members[row.member_1]
    b = members[row.member_2]
    ax = constraint.arm_ax + constraint.gap_x
    ay = constraint.arm_ay + constraint.gap_y
    turn_a = a.inverse_inertia * (ax * ax + ay * ay)
    turn_b = b.inverse_inertia * (constraint.arm_bx * constraint.arm_bx + constraint.arm_by * constraint.arm_by)
    return float(a.inverse_mass + b.inverse_mass + turn_a + turn_b)


@kernel
def side_member(row: Records, k: int) -> int:
    """Member on side k (1 to 4) of a row."""
    if k <= 2:
        return int(row.member_1 if k == 1 else row.member_2)
    return int(row.member_3 if k == 3 else row.member_4)


@kernel
def _side(row: Records, k: int) -> tuple[float, float, float]:
    if k == 1:
        return row.x1, row.y1, row.w1
    if k == 2:
        return row.x2, row.y2, row.w2
    if k == 3:
        return row.x3, row.y3, row.w3
    return row.x4, row.y4, row.w4


@kernel
def side_product(members: Records, row: Records, k: int, other: Records, m: int) -> float:
    """What one member, on side k of a row and on side m of another, adds to their J M^-1 J^T."""
    x, y, w = _side(row, k)
    ox, oy, ow = _side(other, m)
    member = members[side_member(row, k)]
    return float(member.inverse_mass * (x * ox + y * oy) + member.inverse_inertia * (w * ow))


@kernel
def row_speed(members: Records, motions: Records, row: Records) -> float:
    """Speed of the members along a row, J v."""
    a = motions[members[row.member_1].body]
    b = motions[members[row.member_2].body]
    speed = row.x1 * a.velocity_x + row.y1 * a.velocity_y + row.w1 * a.angular_velocity
    speed = speed + row.x2 * b.velocity_x + row.y2 * b.velocity_y + row.w2 * b.angular_velocity
    if row.sides == 4:
        a = motions[members[row.member_3].body]
        b = motions[members[row.member_4].body]
        speed = speed + row.x3 * a.velocity_x + row.y3 * a.velocity_y + row.w3 * a.angular_velocity
        speed = speed + row.x4 * b.velocity_x + row.y4 * b.velocity_y + row.w4 * b.angular_velocity
    return float(speed)


@kernel
def push_row(members: Records, motions: Records, row: Records, impulse: float) -> None:
    """Apply an impulse along a row to its members."""
    _push(members[row.member_1], motions, row.x1, row.y1, row.w1, impulse)
    _push(members[row.member_2], motions, row.x2, row.y2, row.w2, impulse)
    if row.sides == 4:
        _push(members[row.member_3], motions, row.x3, row.y3, row.w3, impulse)
        _push(members[row.member_4], motions, row.x4, row.y4, row.w4, impulse)


@kernel
def _push(member: Records, motions: Records, x: float, y: float, w: float, impulse: float) -> None:
    motion = motions[member.body]
    motion.velocity_x += member.inverse_mass * (x * impulse)
    motion.velocity_y += member.inverse_mass * (y * impulse)
    motion.angular_velocity += member.inverse_inertia * (w * impulse)
