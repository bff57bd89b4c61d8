"""Tools that bring a body by one drag: circle, box, capsule, and a wall that does not move."""

from __future__ import annotations

import math
from abc import abstractmethod
from typing import Any, ClassVar

from imgui_bundle import icons_fontawesome_6 as icons

from sandbox.engine.commands.spawn import Spawn
from sandbox.render.camera import Vec
from sandbox.window.tools.drag import DragTool
from sandbox.window.tools.tool import fresh_id
from sandbox.window.workspace import Workspace


class DragShape(DragTool):
    """A body by one drag."""

    body_type: ClassVar[str] = "dynamic"

    @abstractmethod
    def words(self, start: Vec, end: Vec) -> dict[str, Any]:
        """The body between two points, as a scene file has it, without id and type."""

    def bring(self, workspace: Workspace, start: Vec, end: Vec) -> None:
        """Bring it into the world, and select it."""
        name = fresh_id(workspace, self.name)
        kind = {} if self.body_type == "dynamic" else {"type": self.body_type}
        if workspace.do(f"Draw {name}", Spawn({"id": name, **kind, **self.words(start, end)})):
            workspace.selection.pick(name)


class CircleTool(DragShape):
    """Centre and radius."""

    name, title, icon, key = "circle", "Circle", icons.ICON_FA_CIRCLE, "C"
    help = "Drag from the centre of a circle to its edge."

    def words(self, start: Vec, end: Vec) -> dict[str, Any]:
        """A circle about the start."""
        return {"shapes": [{"circle": math.dist(start, end)}], "position": list(start)}

    def corners(self, start: Vec, end: Vec) -> list[Vec]:
        """A polygon of 48 corners."""
        radius, turns = math.dist(start, end), [2.0 * math.pi * k / 48 for k in range(48)]
        return [(start[0] + radius * math.cos(turn), start[1] + radius * math.sin(turn)) for turn in turns]


class BoxTool(DragShape):
    """Two opposite corners."""

    name, title, icon, key = "box", "Box", icons.ICON_FA_SQUARE, "B"
    help = "Drag from one corner of a box to the opposite one."

    def words(self, start: Vec, end: Vec) -> dict[str, Any]:
        """A box about the middle."""
        size = [max(abs(end[0] - start[0]), 1e-3), max(abs(end[1] - start[1]), 1e-3)]
        return {"shapes": [{"box": size}], "position": [(start[0] + end[0]) / 2, (start[1] + end[1]) / 2]}

    def corners(self, start: Vec, end: Vec) -> list[Vec]:
        """Its four corners."""
        return [start, (end[0], start[1]), end, (start[0], end[1])]


class WallTool(BoxTool):
    """A box that does not move."""

    name, title, icon, key = "wall", "Wall", icons.ICON_FA_TROWEL_BRICKS, "W"
    help = "Drag a box that never moves."
    body_type = "static"


class CapsuleTool(DragShape):
    """Two ends; as thick as a third of its length, or as the last one."""

    name, title, icon, key = "capsule", "Capsule", icons.ICON_FA_CAPSULES, "1"
    help = "Drag from one end of a capsule to the other."

    def words(self, start: Vec, end: Vec) -> dict[str, Any]:
        """A capsule about the middle."""
        x, y, radius = self._half(start, end)
        at = [(start[0] + end[0]) / 2, (start[1] + end[1]) / 2]
        return {"shapes": [{"capsule": [[-x, -y], [x, y]], "radius": radius}], "position": at}

    def corners(self, start: Vec, end: Vec) -> list[Vec]:
        """Two half circles."""
        x, y, radius = self._half(start, end)
        middle = (start[0] + end[0]) / 2, (start[1] + end[1]) / 2
        along = math.atan2(y, x)
        points = []
        for side, sign in ((along - math.pi / 2, 1.0), (along + math.pi / 2, -1.0)):
            turns = [side + math.pi * k / 16 for k in range(17)]
            points += [
                (middle[0] + sign * x + radius * math.cos(t), middle[1] + sign * y + radius * math.sin(t))
                for t in turns
            ]
        return points

    @staticmethod
    def _half(start: Vec, end: Vec) -> tuple[float, float, float]:
        """Half of the core, and the radius: a sixth of the length, which the core is shorter by at each end."""
        length = max(math.dist(start, end), 1e-3)
        radius = length / 6.0
        share = (0.5 * length - radius) / length
        return (end[0] - start[0]) * share, (end[1] - start[1]) * share, radius
