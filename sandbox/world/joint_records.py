"""The record of a joint: one table for all kinds; a field that a kind has no use for stays zero."""

from __future__ import annotations

from typing import get_args

from sandbox.scene.flat import JointKind
from sandbox.tables import FLAG, STEP_OR_NEVER, UNLIMITED, Field, Table, Values, whole

KINDS: tuple[JointKind, ...] = get_args(JointKind)
"""All kinds; the number of each is its place."""
NUMBERS: dict[JointKind, int] = {kind: number for number, kind in enumerate(KINDS)}
DISTANCE, REVOLUTE, PRISMATIC, WELD, WHEEL, GEAR, PULLEY, MOTOR, TARGET, FRICTION = range(len(KINDS))
_BODY, _JOINT = Values(-1, row_of="body"), Values(-1, row_of="joint")

JOINT = Table(
    "joint",
    (
        whole("kind", "its place in `KINDS`", Values(0, len(KINDS) - 1)),
        whole("body_a", "index of the first body; -1 for the world", _BODY),
        whole("body_b", "index of the second body; -1 for the world", _BODY),
        whole("joint_1", "gear: the first joint it couples, else -1", _JOINT),
        whole("joint_2", "gear: the second joint it couples, else -1", _JOINT),
        Field("anchor_ax", "m", "anchor on a from its centre, in its frame; in the world where a is the world"),
        Field("anchor_ay", "m", "anchor on a from its centre, in its frame; in the world where a is the world"),
        Field("anchor_bx", "m", "anchor on b from its centre, in its frame; in the world where b is the world"),
        Field("anchor_by", "m", "anchor on b from its centre, in its frame; in the world where b is the world"),
        Field("axis_x", "1", "prismatic, wheel: unit axis in the frame of a; motor: the world's x axis at first"),
        Field("axis_y", "1", "prismatic, wheel: unit axis in the frame of a; motor: the world's x axis at first"),
        Field("reference_angle", "rad", "angle of b less angle of a that counts as zero; motor: that it drives to"),
        Field("length", "m", "distance: rest length; pulley, gear: what the weighted sum stays at (gear: m or rad)"),
        Field("ratio", "1", "pulley, gear: weight of the second side"),
        Field("point_ax", "m", "pulley: wheel above a; target: the target; motor: offset of b in the frame of a"),
        Field("point_ay", "m", "pulley: wheel above a; target: the target; motor: offset of b in the frame of a"),
        Field("point_bx", "m", "pulley: wheel above b"),
        Field("point_by", "m", "pulley: wheel above b"),
        whole("spring", "1 while its spring acts", FLAG),
        Field("hertz", "1/s", "of the spring; weld, motor, target: of the position; 0 is rigid"),
        Field("damping_ratio", "1", "of the same; 1 is critical"),
        Field("angular_hertz", "1/s", "weld, motor: of the angle; 0 is rigid"),
        Field("angular_damping_ratio", "1", "of the same; 1 is critical"),
        Field("rest", "m or rad", "where the spring pulls the slide or angle to; motor: the angle it drives to"),
        whole("limit", "1 while the limits hold", FLAG),
        Field("lower", "m or rad", "least length, slide or angle", values=UNLIMITED),
        Field("upper", "m or rad", "greatest length, slide or angle", values=UNLIMITED),
        whole("motor", "1 while its motor runs", FLAG),
        Field("motor_speed", "m/s or rad/s", "what the motor strives for"),
        Field("max_motor", "N or N m", "most that the motor gives", values=UNLIMITED),
        Field("max_force", "N", "motor, target, friction: limit of the force", values=UNLIMITED),
        Field("max_torque", "N m", "motor, friction: limit of the torque", values=UNLIMITED),
        Field("break_force", "N", "breaks above this; infinite if never", values=UNLIMITED),
        Field("break_torque", "N m", "breaks above this; infinite if never", values=UNLIMITED),
        whole("collide", "1 if the two bodies collide with each other", FLAG),
        whole("enabled", "0 while the joint is switched off", FLAG),
        whole("broken_step", "step at which it broke; -1 while it holds", STEP_OR_NEVER),
        *(Field(f"impulse_{k}", "N s or N m s", f"of row {k} over the last substep, as of level 0") for k in range(5)),
        *(Field(f"preload_{k}", "N or N m", f"what row {k} bore when the world was put down") for k in range(3)),
        Field("force_x", "N", "that the joint exerts on b, mean of the last step"),
        Field("force_y", "N", "that the joint exerts on b, mean of the last step"),
        Field("torque", "N m", "that the joint exerts on b about its anchor, mean of the last step"),
    ),
)
