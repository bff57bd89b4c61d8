"""From flat joints to the joint table: anchors, axes and rest angles measured at the pose the scene starts with."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from sandbox.scene.flat import FlatJoint, Vec
from sandbox.tables import Records
from sandbox.world import joint_records as kinds
from sandbox.world.joint_records import JOINT

KINDS = {
    "distance": kinds.DISTANCE, "revolute": kinds.REVOLUTE, "prismatic": kinds.PRISMATIC, "weld": kinds.WELD,
    "wheel": kinds.WHEEL, "gear": kinds.GEAR, "pulley": kinds.PULLEY, "motor": kinds.MOTOR,
    "target": kinds.TARGET, "friction": kinds.FRICTION,
}  # fmt: skip
"""The number of each kind of joint."""


def build_joints(
    joints: Sequence[FlatJoint], bodies: Records, names: Sequence[str], earlier: Sequence[str] = ()
) -> Records:
    """The joint table, in the order given, measured at the pose of now. `names` are the ids of `bodies`.

    The rows come after those of the `earlier` joints, given by their ids.
    """
    table = JOINT.zeros(len(joints))
    body_index = {name: i for i, name in enumerate(names)}
    joint_index = {name: i for i, name in enumerate([*earlier, *(joint.id for joint in joints)])}
    for row, joint in zip(table, joints, strict=True):
        row.kind, row.joint_1, row.joint_2, row.broken_step = KINDS[joint.kind], -1, -1, -1
        row.body_a, row.body_b = _index(joint.body_a, body_index), _index(joint.body_b, body_index)
        _copy_numbers(row, joint)
        if joint.joints is None:
            _measure(row, joint, bodies)
        else:
            row.joint_1, row.joint_2 = (joint_index[name] for name in joint.joints)
    return table


def _index(name: str | None, known: Mapping[str, int]) -> int:
    return -1 if name is None else known[name]


def _copy_numbers(row: Any, joint: FlatJoint) -> None:
    row.ratio, row.rest = joint.ratio, joint.rest
    row.spring, row.hertz, row.damping_ratio = joint.hertz is not None, joint.hertz or 0.0, joint.damping_ratio
    row.angular_hertz, row.angular_damping_ratio = joint.angular_hertz, joint.angular_damping_ratio
    row.limit = joint.lower > -math.inf or joint.upper < math.inf
    row.lower, row.upper = joint.lower, joint.upper
    row.motor, row.motor_speed = joint.motor_speed is not None, joint.motor_speed or 0.0
    row.max_motor, row.max_force, row.max_torque = joint.max_motor, joint.max_force, joint.max_torque
    row.break_force, row.break_torque = joint.break_force, joint.break_torque
    row.collide, row.enabled = joint.collide, joint.enabled


def _measure(row: Any, joint: FlatJoint, bodies: Records) -> None:
    """Anchors and axis in the frames of their bodies, and the lengths and angles that count as zero."""
    row.anchor_ax, row.anchor_ay = into_frame(bodies, row.body_a, joint.anchor_a)
    row.anchor_bx, row.anchor_by = into_frame(bodies, row.body_b, joint.anchor_b)
    row.axis_x, row.axis_y = _turn_back(bodies, row.body_a, joint.axis)
    row.reference_angle = _angle(bodies, row.body_b) - _angle(bodies, row.body_a) + joint.angle
    if joint.kind == "pulley":
        (row.point_ax, row.point_ay), (row.point_bx, row.point_by) = joint.points
        row.length = _distance(joint.points[0], joint.anchor_a)
        row.length += joint.ratio * _distance(joint.points[1], joint.anchor_b)
    elif joint.kind == "target":
        row.point_ax, row.point_ay = joint.points[0]
    elif joint.kind == "motor":
        offset = joint.points[0][0] - joint.anchor_a[0], joint.points[0][1] - joint.anchor_a[1]
        row.point_ax, row.point_ay = _turn_back(bodies, row.body_a, offset)
        row.rest = joint.angle
    elif joint.kind == "distance":
        length = joint.length if joint.length is not None else _distance(joint.anchor_a, joint.anchor_b)
        row.length = length


def into_frame(bodies: Records, index: int, point: Vec) -> Vec:
    """A world point (m) from the centre of body `index`, in its frame; for the world (-1) the point itself."""
    if index < 0:
        return point
    body = bodies[index]
    return _turn_back(bodies, index, (point[0] - float(body.center_x), point[1] - float(body.center_y)))


def _turn_back(bodies: Records, index: int, vector: Vec) -> Vec:
    if index < 0:
        return vector
    c, s = float(bodies[index].rotation_cos), float(bodies[index].rotation_sin)
    return c * vector[0] + s * vector[1], c * vector[1] - s * vector[0]


def _angle(bodies: Records, index: int) -> float:
    return float(bodies[index].angle) if index >= 0 else 0.0


def _distance(a: Vec, b: Vec) -> float:
    dx, dy = b[0] - a[0], b[1] - a[1]
    return math.sqrt(dx * dx + dy * dy)
