"""From flat joints to the joint table: anchors, axes and rest angles measured at the pose the scene starts with."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from sandbox.scene.flat import FlatJoint, Vec
from sandbox.tables import Floats, Records, plain, taken
from sandbox.world.joint_records import JOINT, NUMBERS

_SAME = (
    "ratio", "rest", "damping_ratio", "angular_hertz", "angular_damping_ratio", "lower", "upper", "max_motor",
    "max_force", "max_torque", "break_force", "break_torque", "collide", "enabled",
)  # fmt: skip


def build_joints(
    joints: Sequence[FlatJoint],
    bodies: Records,
    body_row: Callable[[str], int],
    joint_row: Callable[[str], int],
) -> Records:
    """The joint table, in the order given, measured at the pose of now.

    `body_row` gives the row of a body by its id, `joint_row` that of a joint, in the table in which these come to lie.
    """
    table = JOINT.zeros(len(joints))
    if not joints:
        return table
    table.kind = [NUMBERS[joint.kind] for joint in joints]
    table.broken_step = -1
    table.body_a = [_row(joint.body_a, body_row) for joint in joints]
    table.body_b = [_row(joint.body_b, body_row) for joint in joints]
    for name in _SAME:
        table[name] = np.array([getattr(joint, name) for joint in joints], table[name].dtype)
    _switch_on(table, joints)
    table.joint_1 = [joint_row(joint.joints[0]) if joint.joints else -1 for joint in joints]
    table.joint_2 = [joint_row(joint.joints[1]) if joint.joints else -1 for joint in joints]
    measured = np.array([joint.joints is None for joint in joints], np.bool_)
    table[measured] = _measured(taken(table, measured), [joint for joint in joints if joint.joints is None], bodies)
    return table


def _row(name: str | None, body_row: Callable[[str], int]) -> int:
    return -1 if name is None else body_row(name)


def _switch_on(table: Records, joints: Sequence[FlatJoint]) -> None:
    """Springs, limits and motors, where a joint has them."""
    for name, given in (("spring", "hertz"), ("motor", "motor_speed")):
        values = [getattr(joint, given) for joint in joints]
        table[name] = np.array([value is not None for value in values], np.int64)
        table[given] = np.array([value or 0.0 for value in values], float)
    table.limit = (table.lower > -math.inf) | (table.upper < math.inf)


def _measured(table: Records, joints: Sequence[FlatJoint], bodies: Records) -> Records:
    """Anchors and axis in the frames of their bodies, and the lengths and angles that count as zero."""
    frames = _Frames(bodies)
    anchors = [_points(joint.anchor_a for joint in joints), _points(joint.anchor_b for joint in joints)]
    table.anchor_ax, table.anchor_ay = frames.into(table.body_a, *anchors[0])
    table.anchor_bx, table.anchor_by = frames.into(table.body_b, *anchors[1])
    table.axis_x, table.axis_y = frames.turned_back(table.body_a, *_points(joint.axis for joint in joints))
    angles = np.array([joint.angle for joint in joints], float)
    table.reference_angle = frames.angles(table.body_b) - frames.angles(table.body_a) + angles
    for k, joint in enumerate(joints):
        if joint.kind == "distance":
            own = joint.length
            table.length[k] = own if own is not None else _distance(joint.anchor_a, joint.anchor_b)
        elif joint.kind in ("pulley", "target", "motor"):
            _aim(table[k], joint, frames)
    return table


def _aim(row: Any, joint: FlatJoint, frames: _Frames) -> None:
    """What only few kinds have: wheels, a target, a wanted place."""
    if joint.kind == "pulley":
        (row.point_ax, row.point_ay), (row.point_bx, row.point_by) = joint.points
        row.length = _distance(joint.points[0], joint.anchor_a)
        row.length += joint.ratio * _distance(joint.points[1], joint.anchor_b)
    elif joint.kind == "target":
        row.point_ax, row.point_ay = joint.points[0]
    else:
        offset = joint.points[0][0] - joint.anchor_a[0], joint.points[0][1] - joint.anchor_a[1]
        row.point_ax, row.point_ay = frames.turned_back(row.body_a, *offset)
        row.rest = joint.angle


class _Frames:
    """The frames of bodies, and in the row -1 that of the world: of those that are asked for, not of all."""

    def __init__(self, bodies: Records) -> None:
        self._bodies = plain(bodies)

    def angles(self, rows: Any) -> Any:
        """Angles (rad) of bodies."""
        return self._of("angle", rows, 0.0)

    def into(self, rows: Any, x: Any, y: Any) -> tuple[Any, Any]:
        """World points (m) from the centres of bodies, in their frames."""
        inside: tuple[Any, Any] = self.turned_back(
            rows, x - self._of("center_x", rows, 0.0), y - self._of("center_y", rows, 0.0)
        )
        return inside

    def turned_back(self, rows: Any, x: Any, y: Any) -> tuple[Any, Any]:
        """Directions in the frames of bodies."""
        c, s = self._of("rotation_cos", rows, 1.0), self._of("rotation_sin", rows, 0.0)
        return np.where(rows < 0, x, c * x + s * y), np.where(rows < 0, y, c * y - s * x)

    def _of(self, name: str, rows: Any, world: float) -> Any:
        return np.where(rows < 0, world, self._bodies[name][rows])


def _points(points: Iterable[Vec]) -> tuple[Floats, Floats]:
    columns = np.array(list(points), float).reshape(-1, 2)
    return columns[:, 0], columns[:, 1]


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


def _distance(a: Vec, b: Vec) -> float:
    dx, dy = b[0] - a[0], b[1] - a[1]
    return math.sqrt(dx * dx + dy * dy)
