"""The selected joint: what it joins, what it bears, and its parts, motor, limits and spring."""

from __future__ import annotations

import math
from typing import Any

from imgui_bundle import imgui

from sandbox.engine.commands.delete import DeleteJoint
from sandbox.engine.commands.joint_parts import BreakJoint
from sandbox.engine.commands.set_joint import SetJoint
from sandbox.engine.views.joint import JointView
from sandbox.window.editor import Editor, Entry
from sandbox.window.panels.inspector.joint_parts import draw_limits, draw_motor, draw_spring
from sandbox.window.panels.inspector.joint_settings import draw_settings
from sandbox.window.widgets import PLAIN, Scale, button, label, row, section
from sandbox.window.workspace import Workspace
from sandbox.world import joint_records as kinds

_SLIDING = (kinds.DISTANCE, kinds.PRISMATIC, kinds.WHEEL, kinds.TARGET)
_TURN, _METRES = Scale("°"), Scale("m")
_ENABLED = Entry("inspector.joint.enabled", "on", tip="Off: it has no effect.")
_COLLIDE = Entry("inspector.joint.collide", "bodies collide", tip="Whether the two bodies collide with each other.")


def draw_joint(workspace: Workspace, editor: Editor, joint: JointView) -> None:
    """All of one joint."""
    world = workspace.session.world
    record = world.state.joints[world.directory.joint(joint.id)]
    editor.of = joint.id
    if section("Joint"):
        _draw_ends(workspace, joint)
        _draw_figures(joint, record)
        editor.switch(workspace, _ENABLED, joint.enabled, lambda on: [SetJoint(joint.id, enabled=on)])
        editor.switch(workspace, _COLLIDE, bool(record.collide), lambda on: [SetJoint(joint.id, collide=on)])
        _draw_buttons(workspace, joint)
    draw_motor(workspace, editor, joint, record)
    draw_limits(workspace, editor, joint, record)
    draw_spring(workspace, editor, joint, record)
    draw_settings(workspace, editor, joint, record)


def _draw_ends(workspace: Workspace, joint: JointView) -> None:
    """Its bodies, to be selected by a click."""
    for which, name in zip(("first body", "second body"), joint.bodies, strict=True):
        if name is None:
            if joint.type != "gear":
                row(which, "the world")
            continue
        label(which)
        if button(f"inspector.joint.{which.split()[0]}", name, f"Select {name}."):
            workspace.selection.pick(name)


def _draw_figures(joint: JointView, record: Any) -> None:
    force = joint.force
    if joint.type != "gear":
        for which, (x, y) in zip(("first anchor", "second anchor"), joint.anchors, strict=True):
            row(which, f"{_METRES.shown(x):g}, {_METRES.shown(y):g} m")
        row(
            "angle",
            f"{_TURN.shown(math.degrees(joint.angle)):.4g} °",
            "Of the second body against the first, since the start.",
        )
    if int(record.kind) in _SLIDING:
        row(
            "length",
            f"{_METRES.shown(joint.translation):g} m",
            "The slide along its axis, or the distance of its anchors.",
        )
    row(
        "force",
        f"{PLAIN.shown(math.hypot(*force)):.5g} N   ({PLAIN.shown(force[0]):.4g}, {PLAIN.shown(force[1]):.4g})",
        "On the second body, in the last step.",
    )
    row(
        "torque", f"{PLAIN.shown(joint.torque):.5g} N m", "On the second body, about its anchor, mean of the last step."
    )
    if joint.broken:
        row("broken", f"at step {joint.broken_step:,}")


def _draw_buttons(workspace: Workspace, joint: JointView) -> None:
    if button("inspector.joint.break", "Break", "Breaks it for good.", enabled=not joint.broken):
        workspace.do(f"Break {joint.id}", BreakJoint(joint.id))
    imgui.same_line()
    if button("inspector.joint.delete", "Delete", "Takes it out of the world."):
        workspace.do(f"Delete {joint.id}", DeleteJoint(joint.id))
