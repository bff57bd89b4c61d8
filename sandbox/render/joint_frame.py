"""Where the joints of a frame are, as read-only arrays."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.render.camera import Floats
from sandbox.world.joint_records import DISTANCE, MOTOR, TARGET
from sandbox.world.state import State

Ints = NDArray[np.int64]


@dataclass(frozen=True)
class JointMarks:
    """The joints that hold, one row each; metres in the world.

    `kind` (k,); `a`, `b` (k, 2) anchors; `axis` (k, 2) unit axis of a slide; `points` (k, 2, 2) the wheels of a
    pulley, or the target twice; `reach` (k, 2) least and greatest slide or length, infinite where there is none;
    `sprung` (k,) whether a spring acts; `parents` (k, 2) rows of the joints that a gear couples, else -1.
    """

    kind: Ints
    a: Floats
    b: Floats
    axis: Floats
    points: Floats
    reach: Floats
    sprung: NDArray[np.bool_]
    parents: Ints

    def __len__(self) -> int:
        return len(self.kind)


def capture_joints(state: State) -> JointMarks:
    """The joints of a world as they stand; broken ones and those that are switched off are left out."""
    joints: Any = state.joints
    rows = np.flatnonzero((joints.enabled == 1) & (joints.broken_step < 0))
    place = np.full(len(joints) + 1, -1)
    place[rows] = np.arange(len(rows))
    held: Any = joints[rows]
    rotation_a, rotation_b = _rotation(state, held.body_a), _rotation(state, held.body_b)
    a = _center(state, held.body_a) + _turn(rotation_a, held.anchor_ax, held.anchor_ay)
    b = _center(state, held.body_b) + _turn(rotation_b, held.anchor_bx, held.anchor_by)
    points = np.stack(
        [np.column_stack([held.point_ax, held.point_ay]), np.column_stack([held.point_bx, held.point_by])], axis=1
    )
    driven = held.kind == MOTOR
    points[driven, 0] = (a + _turn(rotation_a, held.point_ax, held.point_ay))[driven]
    a = np.where((held.kind == TARGET)[:, None], points[:, 0], a)
    reach = np.column_stack([held.lower, held.upper])
    reach[(held.kind == DISTANCE) & (held.limit == 0)] = -np.inf, np.inf
    parents = np.column_stack([place[held.joint_1], place[held.joint_2]])
    return JointMarks(
        np.array(held.kind), a, b, _turn(rotation_a, held.axis_x, held.axis_y), points, reach, held.spring == 1, parents
    )


def blend_joints(previous: JointMarks, current: JointMarks, alpha: float) -> JointMarks:
    """The joints between two frames; those of the later one if some broke between."""
    if len(previous) != len(current):
        return current
    a, b, axis, points = (
        getattr(previous, name) + (getattr(current, name) - getattr(previous, name)) * alpha
        for name in ("a", "b", "axis", "points")
    )
    return replace(current, a=a, b=b, axis=axis, points=points)


def _center(state: State, index: Any) -> Floats:
    bodies: Any = state.bodies
    centers = np.vstack([np.column_stack([bodies.center_x, bodies.center_y]), [[0.0, 0.0]]])
    found: Floats = centers[index]  # -1, the world, is the last row
    return found


def _rotation(state: State, index: Any) -> Floats:
    bodies: Any = state.bodies
    rotations = np.vstack([np.column_stack([bodies.rotation_cos, bodies.rotation_sin]), [[1.0, 0.0]]])
    found: Floats = rotations[index]
    return found


def _turn(rotation: Floats, x: Any, y: Any) -> Floats:
    c, s = rotation[:, 0], rotation[:, 1]
    return np.column_stack([c * x - s * y, s * x + c * y])
