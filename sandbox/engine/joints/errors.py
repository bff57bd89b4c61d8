"""How far every joint of a net is from what it keeps."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.joints.laws import gap, length_and_direction, rope, turned
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Records
from sandbox.world.joint_records import (
    DISTANCE,
    GEAR,
    MOTOR,
    PRISMATIC,
    PULLEY,
    TARGET,
    WHEEL,
)


@kernel
def measure_errors(work: JointWork, motions: Records, constraint: Records, joint: Records) -> None:
    """Anchors, gap and errors of a joint; a gear builds on those of two others."""
    if joint.kind == GEAR:
        first = _coordinate(work, constraint.constraint_1)
        constraint.error_0 = first + joint.ratio * _coordinate(work, constraint.constraint_2) - joint.length
        return
    a = work.members[constraint.member_a]
    b = work.members[constraint.member_b]
    moved_a = motions[a.body]
    moved_b = motions[b.body]
    _place_anchors(constraint, joint, a, b, moved_a, moved_b)
    _find_errors(constraint, joint, a, b, moved_a, moved_b)


@kernel
def _place_anchors(
    constraint: Records, joint: Records, a: Records, b: Records, moved_a: Records, moved_b: Records
) -> None:
    """Arms, the gap between the anchors and the angle between the bodies."""
    ax = joint.anchor_ax
    ay = joint.anchor_ay
    if joint.kind == MOTOR:
        ax = ax + joint.point_ax
        ay = ay + joint.point_ay
    elif joint.kind == TARGET:
        ax = joint.point_ax
        ay = joint.point_ay
    arm_ax, arm_ay = turned(a.cos, a.sin, ax, ay)
    arm_bx, arm_by = turned(b.cos, b.sin, joint.anchor_bx, joint.anchor_by)
    constraint.arm_ax = arm_ax
    constraint.arm_ay = arm_ay
    constraint.arm_bx = arm_bx
    constraint.arm_by = arm_by
    constraint.gap_x = gap(a.center_x, b.center_x, moved_a.delta_x, moved_b.delta_x, arm_ax, arm_bx)
    constraint.gap_y = gap(a.center_y, b.center_y, moved_a.delta_y, moved_b.delta_y, arm_ay, arm_by)
    constraint.turn = b.angle - a.angle - joint.reference_angle


@kernel
def _find_errors(
    constraint: Records, joint: Records, a: Records, b: Records, moved_a: Records, moved_b: Records
) -> None:
    kind = joint.kind
    constraint.error_0 = constraint.gap_x
    constraint.error_1 = constraint.gap_y
    constraint.error_2 = constraint.turn
    constraint.place = constraint.turn
    if kind in (PRISMATIC, WHEEL):
        constraint.axis_x, constraint.axis_y = turned(a.cos, a.sin, joint.axis_x, joint.axis_y)
        constraint.error_0 = constraint.axis_x * constraint.gap_y - constraint.axis_y * constraint.gap_x
        constraint.error_1 = constraint.turn
        constraint.place = constraint.axis_x * constraint.gap_x + constraint.axis_y * constraint.gap_y
    elif kind == DISTANCE:
        length, x, y = length_and_direction(constraint.gap_x, constraint.gap_y, 1.0)
        constraint.place = length
        constraint.axis_x = x
        constraint.axis_y = y
        constraint.error_0 = constraint.place - joint.length
    elif kind == PULLEY:
        _find_pulley_error(constraint, joint, a, b, moved_a, moved_b)


@kernel
def _find_pulley_error(
    constraint: Records, joint: Records, a: Records, b: Records, moved_a: Records, moved_b: Records
) -> None:
    """`axis` becomes the direction of the rope at a, `gap` that at b, both away from the wheels."""
    x = rope(joint.point_ax, a.center_x, moved_a.delta_x, constraint.arm_ax)
    y = rope(joint.point_ay, a.center_y, moved_a.delta_y, constraint.arm_ay)
    length_a, ux, uy = length_and_direction(x, y, 0.0)
    constraint.axis_x = ux
    constraint.axis_y = uy
    x = rope(joint.point_bx, b.center_x, moved_b.delta_x, constraint.arm_bx)
    y = rope(joint.point_by, b.center_y, moved_b.delta_y, constraint.arm_by)
    length_b, ux, uy = length_and_direction(x, y, 0.0)
    constraint.gap_x = ux
    constraint.gap_y = uy
    constraint.error_0 = length_a + joint.ratio * length_b - joint.length


@kernel
def _coordinate(work: JointWork, k: int) -> float:
    """What a gear couples: the slide of a prismatic joint, the angle of another."""
    constraint = work.constraints[k]
    return float(constraint.place if work.joints[constraint.joint].kind == PRISMATIC else constraint.turn)
