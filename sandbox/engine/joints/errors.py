"""How far every joint of a part is from what it keeps, at the pose its members were looked at."""

from __future__ import annotations

import math

from sandbox._jit import kernel
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

_SHORT = 1e-9


@kernel
def measure(work: JointWork, part: Records) -> None:
    """Anchors, gaps and errors of all joints of a part; gears last, for they build on others."""
    for k in range(part.first_seat, part.seat_end):
        seat = work.seats[k]
        joint = work.joints[seat.joint]
        if joint.kind != GEAR:
            a = work.members[seat.member_a]
            b = work.members[seat.member_b]
            _place_anchors(seat, joint, a, b)
            _find_errors(seat, joint, a, b)
    for k in range(part.first_seat, part.seat_end):
        seat = work.seats[k]
        joint = work.joints[seat.joint]
        if joint.kind == GEAR:
            first = _coordinate(work, seat.seat_1)
            seat.error_0 = first + joint.ratio * _coordinate(work, seat.seat_2) - joint.length


@kernel
def _place_anchors(seat: Records, joint: Records, a: Records, b: Records) -> None:
    """Arms, the gap between the anchors and the angle between the bodies."""
    ax = joint.anchor_ax
    ay = joint.anchor_ay
    if joint.kind == MOTOR:
        ax = ax + joint.point_ax
        ay = ay + joint.point_ay
    elif joint.kind == TARGET:
        ax = joint.point_ax
        ay = joint.point_ay
    arm_ax = a.cos * ax - a.sin * ay
    arm_ay = a.sin * ax + a.cos * ay
    arm_bx = b.cos * joint.anchor_bx - b.sin * joint.anchor_by
    arm_by = b.sin * joint.anchor_bx + b.cos * joint.anchor_by
    seat.arm_ax = arm_ax
    seat.arm_ay = arm_ay
    seat.arm_bx = arm_bx
    seat.arm_by = arm_by
    # Large numbers first: nearby bodies keep their precision far from the origin.
    seat.gap_x = (b.center_x - a.center_x) + (b.way_x - a.way_x) + (arm_bx - arm_ax)
    seat.gap_y = (b.center_y - a.center_y) + (b.way_y - a.way_y) + (arm_by - arm_ay)
    seat.turn = b.angle - a.angle - joint.reference_angle


@kernel
def _find_errors(seat: Records, joint: Records, a: Records, b: Records) -> None:
    kind = joint.kind
    seat.error_0 = seat.gap_x
    seat.error_1 = seat.gap_y
    seat.error_2 = seat.turn
    seat.place = seat.turn
    if kind in (PRISMATIC, WHEEL):
        seat.axis_x = a.cos * joint.axis_x - a.sin * joint.axis_y
        seat.axis_y = a.sin * joint.axis_x + a.cos * joint.axis_y
        seat.error_0 = seat.axis_x * seat.gap_y - seat.axis_y * seat.gap_x
        seat.error_1 = seat.turn
        seat.place = seat.axis_x * seat.gap_x + seat.axis_y * seat.gap_y
    elif kind == DISTANCE:
        seat.place = math.sqrt(seat.gap_x * seat.gap_x + seat.gap_y * seat.gap_y)
        seat.axis_x = seat.gap_x / seat.place if seat.place > _SHORT else 1.0
        seat.axis_y = seat.gap_y / seat.place if seat.place > _SHORT else 0.0
        seat.error_0 = seat.place - joint.length
    elif kind == PULLEY:
        _find_pulley_error(seat, joint, a, b)


@kernel
def _find_pulley_error(seat: Records, joint: Records, a: Records, b: Records) -> None:
    """`axis` becomes the direction of the rope at a, `gap` that at b, both away from the wheels."""
    x = (a.center_x - joint.point_ax) + a.way_x + seat.arm_ax
    y = (a.center_y - joint.point_ay) + a.way_y + seat.arm_ay
    length_a = math.sqrt(x * x + y * y)
    seat.axis_x = x / length_a if length_a > _SHORT else 0.0
    seat.axis_y = y / length_a if length_a > _SHORT else 0.0
    x = (b.center_x - joint.point_bx) + b.way_x + seat.arm_bx
    y = (b.center_y - joint.point_by) + b.way_y + seat.arm_by
    length_b = math.sqrt(x * x + y * y)
    seat.gap_x = x / length_b if length_b > _SHORT else 0.0
    seat.gap_y = y / length_b if length_b > _SHORT else 0.0
    seat.error_0 = length_a + joint.ratio * length_b - joint.length


@kernel
def _coordinate(work: JointWork, k: int) -> float:
    """What a gear couples: the slide of a prismatic joint, the angle of another."""
    seat = work.seats[k]
    return float(seat.place if work.joints[seat.joint].kind == PRISMATIC else seat.turn)
