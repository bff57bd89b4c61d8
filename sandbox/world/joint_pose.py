"""Where a joint's anchors, axis and angle are at the pose of now."""

from __future__ import annotations

import math
from typing import Any

from sandbox.world.joint_records import MOTOR, PRISMATIC
from sandbox.world.state import State

Vec = tuple[float, float]


def anchor(state: State, joint: Any, side: str) -> Vec:
    """Anchor on body "a" or "b" in the world, m."""
    index, x, y = joint[f"body_{side}"], float(joint[f"anchor_{side}x"]), float(joint[f"anchor_{side}y"])
    if index < 0:
        return x, y
    body: Any = state.bodies[index]
    c, s = float(body.rotation_cos), float(body.rotation_sin)
    return float(body.center_x) + (c * x - s * y), float(body.center_y) + (s * x + c * y)


def joint_axis(state: State, joint: Any) -> Vec:
    """Unit axis of a prismatic or wheel joint in the world."""
    x, y = float(joint.axis_x), float(joint.axis_y)
    if joint.body_a < 0:
        return x, y
    body: Any = state.bodies[joint.body_a]
    c, s = float(body.rotation_cos), float(body.rotation_sin)
    return c * x - s * y, s * x + c * y


def slide(state: State, joint: Any) -> float:
    """Slide of a prismatic or wheel joint along its axis, m."""
    (ax, ay), (bx, by) = anchor(state, joint, "a"), anchor(state, joint, "b")
    x, y = joint_axis(state, joint)
    return (bx - ax) * x + (by - ay) * y


def pulley_length(state: State, joint: Any, side: str) -> float:
    """Length of a pulley's rope from its wheel to the anchor on body "a" or "b", m."""
    x, y = anchor(state, joint, side)
    dx, dy = x - float(joint[f"point_{side}x"]), y - float(joint[f"point_{side}y"])
    return math.sqrt(dx * dx + dy * dy)


def coordinate(state: State, joint: Any) -> float:
    """What a gear couples: the slide of a prismatic joint (m), the angle of another (rad)."""
    return slide(state, joint) if int(joint.kind) == PRISMATIC else angle_between(state, joint)


def angle_between(state: State, joint: Any) -> float:
    """Angle of body b less that of body a, less what it was at first, rad."""
    angles = [float(state.bodies[i].angle) if i >= 0 else 0.0 for i in (joint.body_a, joint.body_b)]
    driven = float(joint.rest) if int(joint.kind) == MOTOR else 0.0
    return angles[1] - angles[0] - (float(joint.reference_angle) - driven)
