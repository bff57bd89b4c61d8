"""Tools that join two bodies, or a body to the world."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any, ClassVar

from imgui_bundle import icons_fontawesome_6 as icons

from sandbox.engine.commands.spawn import Spawn
from sandbox.render.camera import Vec
from sandbox.render.line import Line
from sandbox.window.hint import GIVE_UP, Hint, Key
from sandbox.window.tools.tool import Pointer, Tool, body_under, fresh_id, outline
from sandbox.window.workspace import Workspace

Held = tuple[str | None, Vec]
"""A body, None for the world, and the point of the plane at which it was clicked."""


class JoinTool(Tool, ABC):
    """A click on one body, another on the second one; empty space is the world."""

    two_points: ClassVar[bool] = True
    """Whether both clicks are anchors; if not, only the second one is."""

    def __init__(self) -> None:
        self._first: Held | None = None
        self._cursor: Pointer | None = None

    @abstractmethod
    def words(self, first: Vec, second: Vec) -> dict[str, Any]:
        """The joint between two points, as a scene file has it, without id and bodies."""

    def press(self, workspace: Workspace, pointer: Pointer) -> bool:
        """The first body, or the second one and the joint."""
        held = body_under(workspace, pointer), pointer.point
        if self._first is None:
            self._first, self._cursor = held, pointer
            return True
        first, self._first = self._first, None
        self._join(workspace, first, held)
        return True

    def move(self, workspace: Workspace, pointer: Pointer) -> None:
        """Follow the hand."""
        self._cursor = pointer

    def release(self, workspace: Workspace, pointer: Pointer) -> None:
        """A drag from one body to another does as two clicks do."""
        first = self._first
        if first is not None and math.dist(first[1], pointer.point) * workspace.viewport.camera.scale > 12.0:
            self._first = None
            self._join(workspace, first, (body_under(workspace, pointer), pointer.point))

    def cancel(self, workspace: Workspace) -> bool:
        """Forget the first body."""
        busy, self._first = self._first is not None, None
        return busy

    def strokes(self, workspace: Workspace) -> Sequence[Line]:
        """A line from the first anchor to the cursor."""
        if self._first is None or self._cursor is None:
            return ()
        return outline(workspace, [self._first[1], self._cursor.point], closed=False)

    def hint(self, workspace: Workspace) -> Hint:
        """Which body is asked for."""
        if self._first is None:
            return super().hint(workspace)
        whose = self._first[0] or "the world"
        return Hint(f"Now click what {whose} is joined to; empty space is the world.", (GIVE_UP,))

    def _join(self, workspace: Workspace, first: Held, second: Held) -> None:
        if first[0] == second[0]:
            what = "the world to itself" if first[0] is None else f"{first[0]} to itself"
            workspace.say(f"not joined: that would join {what}")
            return
        if first[0] is None:
            first, second = second, first
        name = fresh_id(workspace, self.name)
        joint = {"id": name, "bodies": [first[0], second[0]], **self.words(first[1], second[1])}
        if workspace.do(f"Join {first[0]} to {second[0] or 'the world'}", Spawn(joints=joint)):
            workspace.selection.pick_joint(name)


class HingeTool(JoinTool):
    """A revolute joint where the second body is clicked."""

    name, title, icon, key = "hinge", "Hinge", icons.ICON_FA_CIRCLE_DOT, "J"
    help = "Click one body, then the other where the hinge is to be."

    def words(self, first: Vec, second: Vec) -> dict[str, Any]:
        """At the second point."""
        return {"type": "revolute", "anchor": list(second)}


class WeldTool(JoinTool):
    """A weld where the second body is clicked."""

    name, title, icon, key = "weld", "Weld", icons.ICON_FA_LINK, "2"
    help = "Click one body, then the other: they keep their pose against each other."

    def words(self, first: Vec, second: Vec) -> dict[str, Any]:
        """At the second point."""
        return {"type": "weld", "anchor": list(second)}


class RodTool(JoinTool):
    """A distance joint between the points that were clicked."""

    name, title, icon, key = "rod", "Rod", icons.ICON_FA_GRIP_LINES, "3"
    help = "Click a point of one body, then of the other: they keep their distance."

    def words(self, first: Vec, second: Vec) -> dict[str, Any]:
        """As long as it is."""
        return {"type": "distance", "anchors": [list(first), list(second)]}


class SpringTool(JoinTool):
    """A sprung distance joint."""

    name, title, icon, key = "spring", "Spring", icons.ICON_FA_WAVE_SQUARE, "4"
    help = "Click a point of one body, then of the other: a spring between them."

    def words(self, first: Vec, second: Vec) -> dict[str, Any]:
        """At rest as it stands."""
        return {"type": "distance", "anchors": [list(first), list(second)], "hertz": 2.0, "damping_ratio": 0.1}


class RopeTool(JoinTool):
    """A distance joint that only pulls."""

    name, title, icon, key = "rope", "Rope", icons.ICON_FA_MINUS, "5"
    help = "Click a point of one body, then of the other: no farther apart than now."

    def words(self, first: Vec, second: Vec) -> dict[str, Any]:
        """As long as it is, at most."""
        length = max(math.dist(first, second), 1e-3)
        return {"type": "distance", "anchors": [list(first), list(second)], "max": length}


class SliderTool(JoinTool):
    """A prismatic joint along the line between the clicks."""

    name, title, icon, key = "slider", "Slider", icons.ICON_FA_ARROWS_LEFT_RIGHT, "6"
    help = "Click one body, then the other: one slides along the line between the clicks."

    def words(self, first: Vec, second: Vec) -> dict[str, Any]:
        """Along that line."""
        axis = [second[0] - first[0], second[1] - first[1]]
        return {"type": "prismatic", "anchor": list(second), "axis": axis if any(axis) else [1.0, 0.0]}


class WheelTool(JoinTool):
    """A wheel on a suspension."""

    name, title, icon, key = "axle", "Wheel", icons.ICON_FA_DHARMACHAKRA, "7"
    help = "Click a frame, then the wheel that it is to have, at its axle."

    def words(self, first: Vec, second: Vec) -> dict[str, Any]:
        """Sprung upwards."""
        return {"type": "wheel", "anchor": list(second)}


class MotorTool(JoinTool):
    """A hinge with a motor."""

    name, title, icon, key = "motor", "Motor", icons.ICON_FA_FAN, "8"
    help = "Click one body, then the other where it is to be turned by a motor."

    def words(self, first: Vec, second: Vec) -> dict[str, Any]:
        """Half a turn a second."""
        return {"type": "revolute", "anchor": list(second), "motor_speed": 180.0}


class PinTool(Tool):
    """Fixes a body to the world with a hinge; with Shift, with a weld."""

    name, title, icon, key = "pin", "Pin", icons.ICON_FA_THUMBTACK, "N"
    help = "Click a body to pin it to the world with a hinge."
    keys = (Key(("Shift",), "with a weld"),)

    def press(self, workspace: Workspace, pointer: Pointer) -> bool:
        """Pin it."""
        body = body_under(workspace, pointer)
        if body is None:
            workspace.say("not pinned: there is no body under the pointer")
            return True
        kind = "weld" if pointer.more else "revolute"
        joint = {"id": fresh_id(workspace, self.name), "bodies": [body], "type": kind, "anchor": list(pointer.point)}
        workspace.do(f"Pin {body}", Spawn(joints=joint))
        return True
