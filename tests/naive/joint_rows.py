"""What joints hold, as functions of the pose alone. No derivative is written down here.

A pose is an array q of x, y (m) and angle (rad) of every body, one after the other. The functions take complex poses,
so that a tiny imaginary step gives their derivatives to rounding (W. Squire, G. Trapp, "Using Complex Variables to
Estimate Derivatives of Real Functions", 1998). Joints are rows of the joint table; body -1 is the world.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.world import joint_records as kinds

Array = np.ndarray
FIRST, SECOND, ANGLE, SPRING, DRIVE = range(5)
"""The rows a joint may have: two that keep a place, one that keeps an angle, its spring, its limits and motor."""
STEP = 1e-30


def slots(joint: Any) -> list[int]:
    """The rows of a joint."""
    kind, found = int(joint.kind), []
    if kind == kinds.DISTANCE:
        found = [] if joint.spring or joint.limit else [FIRST]
    elif kind in (kinds.REVOLUTE, kinds.PRISMATIC, kinds.TARGET):
        found = [FIRST, SECOND]
    elif kind in (kinds.WELD, kinds.MOTOR, kinds.FRICTION):
        found = [FIRST, SECOND, ANGLE]
    elif kind == kinds.WHEEL:
        found = [FIRST, ANGLE] if joint.motor else [FIRST]
    elif kind in (kinds.GEAR, kinds.PULLEY):
        found = [FIRST]
    if kind in (kinds.DISTANCE, kinds.REVOLUTE, kinds.PRISMATIC, kinds.WHEEL):
        driven = joint.limit or (joint.motor and kind in (kinds.REVOLUTE, kinds.PRISMATIC))
        found += [SPRING] * bool(joint.spring) + [DRIVE] * bool(driven)
    return found


def angle(q: Array, body: int) -> Any:
    """Angle of a body."""
    return q[3 * body + 2] if body >= 0 else 0.0


def anchor(q: Array, body: int, x: float, y: float) -> tuple[Any, Any]:
    """Where a point of a body is in the world."""
    if body < 0:
        return x, y
    c, s = np.cos(angle(q, body)), np.sin(angle(q, body))
    return q[3 * body] + c * x - s * y, q[3 * body + 1] + s * x + c * y


def arms(joint: Any) -> tuple[float, float]:
    """How far its anchors are from the centres of its bodies."""
    x, y = _first_anchor(joint)
    return float(np.hypot(x, y)), float(np.hypot(joint.anchor_bx, joint.anchor_by))


def gap(q: Array, joint: Any) -> tuple[Any, Any]:
    """Way from the anchor on a to that on b."""
    ax, ay = anchor(q, int(joint.body_a), *_first_anchor(joint))
    bx, by = anchor(q, int(joint.body_b), float(joint.anchor_bx), float(joint.anchor_by))
    return bx - ax, by - ay


def _first_anchor(joint: Any) -> tuple[float, float]:
    if joint.kind == kinds.TARGET:
        return float(joint.point_ax), float(joint.point_ay)
    offset = (float(joint.point_ax), float(joint.point_ay)) if joint.kind == kinds.MOTOR else (0.0, 0.0)
    return float(joint.anchor_ax) + offset[0], float(joint.anchor_ay) + offset[1]


def turn(q: Array, joint: Any) -> Any:
    """Angle of b against a, less what counts as zero."""
    return angle(q, int(joint.body_b)) - angle(q, int(joint.body_a)) - float(joint.reference_angle)


def along(q: Array, joint: Any, x: float, y: float, since: float = 0.0) -> Any:
    """The gap along an axis that was (x, y) when the angle of a was `since`, and turns with a."""
    gx, gy = gap(q, joint)
    tilt = angle(q, int(joint.body_a)) - since
    return gx * (x * np.cos(tilt) - y * np.sin(tilt)) + gy * (x * np.sin(tilt) + y * np.cos(tilt))


def rope(q: Array, joint: Any, side: str) -> Any:
    """Length of a pulley's rope from its wheel to one of its bodies."""
    x, y = anchor(q, int(joint[f"body_{side}"]), joint[f"anchor_{side}x"], joint[f"anchor_{side}y"])
    return np.sqrt((x - joint[f"point_{side}x"]) ** 2 + (y - joint[f"point_{side}y"]) ** 2)


def value(q: Array, joints: Any, joint: Any, slot: int, frame: float | None = None) -> Any:
    """What a row looks at. Gaps are along the axes of the world, or of a as it was at the angle `frame`."""
    kind = int(joint.kind)
    if slot == ANGLE or (kind == kinds.REVOLUTE and slot >= SPRING) or (kind == kinds.PRISMATIC and slot == SECOND):
        return turn(q, joint)
    if kind in (kinds.PRISMATIC, kinds.WHEEL):
        x, y = float(joint.axis_x), float(joint.axis_y)
        return along(q, joint, -y, x) if slot == FIRST else along(q, joint, x, y)
    if kind == kinds.DISTANCE:
        gx, gy = gap(q, joint)
        length = np.sqrt(gx * gx + gy * gy)
        return length - joint.length if slot == FIRST else length
    if kind == kinds.PULLEY:
        return rope(q, joint, "a") + joint.ratio * rope(q, joint, "b") - joint.length
    if kind == kinds.GEAR:
        first, second = (_coupled(q, joints[k]) for k in (int(joint.joint_1), int(joint.joint_2)))
        return first + joint.ratio * second - joint.length
    if frame is None:
        return gap(q, joint)[slot]
    return along(q, joint, float(slot == FIRST), float(slot == SECOND), frame)


def _coupled(q: Array, joint: Any) -> Any:
    if joint.kind == kinds.PRISMATIC:
        return along(q, joint, float(joint.axis_x), float(joint.axis_y))
    return turn(q, joint)


def is_levered(q: Array, joint: Any, slot: int) -> bool:
    """Whether a row pushes both bodies at one point: its gap turns with a. What is torn off is drawn along the world's
    axes: that are gaps of half the longer arm and more, but for motors, brakes and springs, which have them by
    design."""
    kind = int(joint.kind)
    if slot > SECOND or kind not in (kinds.REVOLUTE, kinds.WELD, kinds.TARGET, kinds.MOTOR, kinds.FRICTION):
        return False
    if kind in (kinds.MOTOR, kinds.FRICTION) or (kind in (kinds.WELD, kinds.TARGET) and joint.hertz > 0.0):
        return True
    return bool(np.hypot(*gap(q, joint)) < 0.5 * max(arms(joint)))


def jacobian(q: Array, joints: Any, rows: list[tuple[int, int]]) -> Array:
    """Derivatives of rows (joint, slot) with respect to the pose, one line each."""
    steps = q[:, None] + 1j * STEP * np.eye(len(q))
    lines = []
    for j, slot in rows:
        levered = is_levered(q, joints[j], slot)
        frame = float(np.real(angle(q, int(joints[j].body_a)))) if levered else None
        lines.append(np.broadcast_to(np.imag(value(steps, joints, joints[j], slot, frame)) / STEP, len(q)))
    return np.array(lines).reshape(len(rows), len(q))


def errors(q: Array, joints: Any, rows: list[tuple[int, int]]) -> Array:
    """The value of every row."""
    return np.array([float(value(q, joints, joints[j], slot)) for j, slot in rows])
