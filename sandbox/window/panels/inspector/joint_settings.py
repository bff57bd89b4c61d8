"""The other settings of the selected joint, by the names that they have in a scene file."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.joint_command import MOTORS, SPRINGS
from sandbox.engine.commands.set_joint import SetJoint
from sandbox.engine.views.joint import JointView
from sandbox.scene.joints.any_joint import JOINTS
from sandbox.window.editor import Editor, Entry, Vec
from sandbox.window.panels.inspector.joint_parts import USUAL_FORCE, in_degrees
from sandbox.window.widgets import Scale, section
from sandbox.window.workspace import Workspace
from sandbox.world import joint_records as kinds

_FORCE, _TORQUE = Scale("N", 1.0, 0.0, 1e15, 5), Scale("N m", 1.0, 0.0, 1e15, 5)
_HERTZ, _RATIO, _METRES = Scale("Hz", 0.05, 0.0, 1e4), Scale("", 0.005, 0.0, 1e3), Scale("m", 0.01, digits=5)
_SCALES = {
    "break_force": _FORCE, "break_torque": _TORQUE, "max_force": _FORCE, "max_torque": _TORQUE,
    "hertz": _HERTZ, "damping_ratio": _RATIO, "angular_hertz": _HERTZ, "angular_damping_ratio": _RATIO,
    "ratio": _RATIO, "length": _METRES, "offset": _METRES, "target": _METRES, "angle": Scale("°", 0.5, digits=5),
}  # fmt: skip
"""The settings that are numbers or pairs, in the order in which they are shown."""
_TITLES = {
    "angular_hertz": "angular Hz", "angular_damping_ratio": "angular damp.", "damping_ratio": "damping",
    "hertz": "stiffness",
}  # fmt: skip
_PAIRS = ("offset", "target")
_IN_PARTS = ("hertz", "damping_ratio", "max_force", "max_torque")
"""What motor and spring show already, of joints that may have them."""


def draw_settings(workspace: Workspace, editor: Editor, joint: JointView, record: Any) -> None:
    """What the parts do not show."""
    names = settings_of(joint.type, int(record.kind))
    if not names or not section("Settings"):
        return
    for name in names:
        title = _TITLES.get(name, name.replace("_", " "))
        tip = JOINTS[joint.type].model_fields[name].description or ""
        entry = Entry(f"inspector.joint.{name}", title, _SCALES[name], tip)

        def change(value: Any, name: str = name) -> Iterable[Command]:
            return [SetJoint(joint.id, radians=False, **{name: value})]

        if name in _PAIRS:
            editor.pair(workspace, entry, [_pair(record, name)], change)
        elif name in SetJoint.UNLIMITED and JOINTS[joint.type].model_fields[name].default is None:
            editor.ceiling(workspace, entry, setting_of(joint, record, name), USUAL_FORCE, change)
        else:
            editor.number(workspace, entry, [setting_of(joint, record, name)], change)


def settings_of(kind: str, number: int) -> list[str]:
    """The settings of a kind of joint that are not those of its motor, limits or spring."""
    has = JOINTS[kind].model_fields
    elsewhere = _IN_PARTS if number in SPRINGS or number in MOTORS else ()
    return [name for name in _SCALES if name in has and name not in elsewhere]


def setting_of(joint: JointView, record: Any, name: str) -> float:
    """A setting as it is shown: angles in degrees."""
    column = "rest" if name == "angle" else name
    return float(record[column]) * in_degrees(joint, name)


def _pair(record: Any, name: str) -> Vec:
    """Target, or offset: where a motor drives to, along the axes of the world at the start."""
    x, y = float(record.point_ax), float(record.point_ay)
    if name == "target" or int(record.kind) != kinds.MOTOR:
        return x, y
    c, s = float(record.axis_x), float(record.axis_y)
    return c * x + s * y, c * y - s * x
