"""Tools that bring a region by one drag: water, and wind."""

from __future__ import annotations

from typing import Any, ClassVar

from imgui_bundle import icons_fontawesome_6 as icons

from sandbox.engine.commands.spawn import Spawn
from sandbox.render.camera import Vec
from sandbox.window.tools.drag import DragTool
from sandbox.window.tools.tool import fresh_id
from sandbox.window.workspace import Workspace


class DragRegion(DragTool):
    """From one corner of a box to the opposite one."""

    field: ClassVar[dict[str, Any]]
    """What it does there, in the words of a scene file."""

    def corners(self, start: Vec, end: Vec) -> list[Vec]:
        """Its four corners."""
        return [start, (end[0], start[1]), end, (start[0], end[1])]

    def bring(self, workspace: Workspace, start: Vec, end: Vec) -> None:
        """Bring it into the world, and select it, so that the inspector shows its numbers."""
        (left, right), (bottom, top) = (sorted(pair) for pair in zip(start, end, strict=True))
        name = fresh_id(workspace, self.name)
        region = {"id": name, **self.field, "inside": [left, bottom, right, top]}
        if workspace.do(f"Draw {name}", Spawn(regions=region)):
            workspace.selection.pick_region(name)


class WaterTool(DragRegion):
    """Water as dense as bodies are by default, so that most of them float."""

    name, title, icon, key = "water", "Water", icons.ICON_FA_DROPLET, "I"
    help = "Drag a pool of water from corner to corner; the inspector has its density, surface and flow."
    field: ClassVar[dict[str, Any]] = {"water": 1.5}


class WindTool(DragRegion):
    """A breeze to the right that moves light things."""

    name, title, icon, key = "wind", "Wind", icons.ICON_FA_WIND, "D"
    help = "Drag an area of wind from corner to corner; the inspector has its speed and way."
    field: ClassVar[dict[str, Any]] = {"wind": [15.0, 0.0], "density": 0.05}
