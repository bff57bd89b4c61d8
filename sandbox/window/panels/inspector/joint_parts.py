"""Motor, limits and spring of the selected joint, each with its switch."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.joint_command import MOTORS, SPRINGS
from sandbox.engine.commands.joint_parts import SetLimits, SetMotor, SetSpring
from sandbox.engine.commands.set_joint import ANGLES
from sandbox.engine.views.joint import JointView
from sandbox.window.editor import Editor, Entry
from sandbox.window.widgets import Scale, section
from sandbox.window.workspace import Workspace
from sandbox.world import joint_records as kinds

USUAL_TURNING, USUAL_SLIDING = 90.0, 1.0
"""Where a motor (°/s, m/s) begins that is switched on without a speed."""
USUAL_FORCE, USUAL_HERTZ = 1000.0, 5.0


def in_degrees(joint: JointView, field: str) -> float:
    """What turns a number of the record into what is shown: degrees of angles."""
    return 180.0 / math.pi if field in ANGLES.get(joint.type, ()) else 1.0


def draw_motor(workspace: Workspace, editor: Editor, joint: JointView, record: Any) -> None:
    """The motor of a joint that may have one."""
    if int(record.kind) not in MOTORS or not section("Motor"):
        return
    factor = in_degrees(joint, "motor_speed")
    turning = factor != 1.0
    scale = Scale("°/s", 1.0, digits=5) if turning else Scale("m/s", 0.01, digits=5)
    speed = float(record.motor_speed) * factor if record.motor else None
    start = float(record.motor_speed) * factor or (USUAL_TURNING if turning else USUAL_SLIDING)

    def run(wanted: float | None) -> Iterable[Command]:
        return [SetMotor(joint.id, None if wanted is None else wanted / factor)]

    def bound(strongest: float) -> Iterable[Command]:
        return [SetMotor(joint.id, float(record.motor_speed), strongest)]

    editor.optional(
        workspace, Entry("inspector.motor.speed", "speed", scale, "What it strives for."), speed, start, run
    )
    if speed is not None:
        scale = Scale("N m" if turning else "N", 1.0, 0.0, 1e15, 5)
        entry = Entry("inspector.motor.strongest", "at most", scale, "Most that the motor gives.")
        editor.ceiling(workspace, entry, float(record.max_motor), USUAL_FORCE, bound)


def draw_limits(workspace: Workspace, editor: Editor, joint: JointView, record: Any) -> None:
    """The limits of a joint that may have some."""
    if int(record.kind) not in SPRINGS or not section("Limits"):
        return
    factor, now = in_degrees(joint, "lower"), joint.limits
    scale = Scale("°", 0.5, digits=5) if factor != 1.0 else Scale("m", 0.01, digits=5)
    here = joint.angle if factor != 1.0 else joint.translation
    for side, title in enumerate(("lower", "upper")):

        def limit(wanted: float | None, side: int = side) -> Iterable[Command]:
            ends = [*now]
            ends[side] = None if wanted is None else wanted / factor
            return [SetLimits(joint.id, *ends)]

        end = now[side]
        entry = Entry(f"inspector.limit.{title}", title, scale, "Where it stops; begins at where it is now.")
        editor.optional(workspace, entry, None if end is None else end * factor, here * factor, limit)


def draw_spring(workspace: Workspace, editor: Editor, joint: JointView, record: Any) -> None:
    """The spring of a joint that may have one."""
    if int(record.kind) not in SPRINGS or not section("Spring"):
        return
    damping = float(record.damping_ratio)
    hertz = float(record.hertz) if record.spring else None

    def stiffen(wanted: float | None) -> Iterable[Command]:
        return [SetSpring(joint.id, wanted, damping)]

    def damp(wanted: float) -> Iterable[Command]:
        return [SetSpring(joint.id, hertz, wanted)]

    entry = Entry("inspector.spring.hertz", "stiffness", Scale("Hz", 0.05, 0.0, 1e4), "Frequency of the spring.")
    editor.optional(workspace, entry, hertz, USUAL_HERTZ, stiffen)
    if hertz is None:
        return
    entry = Entry("inspector.spring.damping", "damping", Scale("", 0.005, 0.0, 1e3), "1 is critical damping.")
    editor.number(workspace, entry, [damping], damp)
    if int(record.kind) != kinds.DISTANCE:  # there, it is the length
        _draw_rest(workspace, editor, joint, record)


def _draw_rest(workspace: Workspace, editor: Editor, joint: JointView, record: Any) -> None:
    factor = in_degrees(joint, "rest")

    def rest(wanted: float) -> Iterable[Command]:
        return [SetSpring(joint.id, float(record.hertz), float(record.damping_ratio), wanted / factor)]

    scale = Scale("°", 0.5, digits=5) if factor != 1.0 else Scale("m", 0.01, digits=5)
    entry = Entry("inspector.spring.rest", "rest", scale, "Where the spring pulls to.")
    editor.number(workspace, entry, [float(record.rest) * factor], rest)
