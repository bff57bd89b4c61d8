"""Tools that bring a region: a box by one drag, or any outline, corner by corner or with Shift in one stroke."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

from imgui_bundle import icons_fontawesome_6 as icons

from sandbox.engine.commands.spawn import Spawn
from sandbox.geometry.decompose import decompose
from sandbox.geometry.polygon import PolygonError
from sandbox.render.camera import Vec
from sandbox.render.line import Line
from sandbox.window.hint import Key
from sandbox.window.tools.freehand import Freehand
from sandbox.window.tools.tool import Pointer, fresh_id, outline
from sandbox.window.workspace import Workspace

HOW = "Drag a box, or click corner by corner."


class RegionTool(Freehand):
    """A concave outline becomes several regions, one for each convex part."""

    field: ClassVar[dict[str, Any]]
    """What it does there, in the words of a scene file."""
    least, closes = 3, True
    keys = (Key(("Shift",), "in one stroke"),)

    def stroke_corners(self, stroke: Sequence[Vec], start: Pointer, tolerance: float) -> list[Vec]:
        """Those of a box from the beginning to the end, or with Shift of what was drawn."""
        return super().stroke_corners(stroke, start, tolerance) if start.more else _box(stroke[0], stroke[-1])

    def strokes(self, workspace: Workspace) -> Sequence[Line]:
        """The box while it is dragged, else what there is of the outline."""
        if self.dragged is None or self.dragged.more or len(self.stroke) < 2:
            return super().strokes(workspace)
        return outline(workspace, _box(self.stroke[0], self.stroke[-1]), closed=True)

    def bring(self, workspace: Workspace, corners: Sequence[Vec]) -> None:
        """Bring it into the world, and select it, so that the inspector shows its numbers."""
        try:
            parts = [part.vertices for part in decompose(corners).parts]
        except PolygonError as error:
            workspace.say(f"not drawn: {error}")
            return
        regions = [{**self.field, **self.words(part)} for part in parts]
        names: list[str] = []
        for region in regions:
            region["id"] = fresh_id(workspace, self.name, names)
            names.append(region["id"])
        if workspace.do(f"Draw {', '.join(names)}", Spawn(regions=regions)):
            workspace.selection.pick_region(names[0])

    def words(self, corners: Sequence[Vec]) -> dict[str, Any]:
        """Where it is, in the words of a scene file."""
        (left, *_, right), (bottom, *_, top) = (sorted(each) for each in zip(*corners, strict=True))
        if len(corners) == 4 and set(corners) == {(x, y) for x in (left, right) for y in (bottom, top)}:
            return {"inside": [left, bottom, right, top]}
        return {"outline": [list(corner) for corner in corners]}


class WaterTool(RegionTool):
    """Water as dense as bodies are by default, so that most of them float."""

    name, title, icon, key = "water", "Water", icons.ICON_FA_DROPLET, "I"
    help = f"A pool of water. {HOW} The inspector has its density, surface and flow."
    field: ClassVar[dict[str, Any]] = {"water": 1.5}


class WindTool(RegionTool):
    """A breeze to the right that moves light things."""

    name, title, icon, key = "wind", "Wind", icons.ICON_FA_WIND, "D"
    help = f"An area of wind. {HOW} The inspector has its speed and way."
    field: ClassVar[dict[str, Any]] = {"wind": [15.0, 0.0], "density": 0.05}


class ZoneTool(RegionTool):
    """Where things rise slowly."""

    name, title, icon, key = "zone", "Gravity zone", icons.ICON_FA_ARROWS_UP_DOWN, "O"
    help = f"An area with a gravity of its own, at first upwards. {HOW} The inspector has its strength."
    field: ClassVar[dict[str, Any]] = {"gravity": [0.0, 2.0]}


class AttractorTool(RegionTool):
    """A centre that draws in what is in the area about it."""

    name, title, icon, key = "attractor", "Attractor", icons.ICON_FA_BULLSEYE, "A"
    help = f"An area whose middle attracts. {HOW} The inspector has its strength and how it falls off."
    field: ClassVar[dict[str, Any]] = {"attraction": 20.0, "falloff": 0, "core": 0.5}

    def words(self, corners: Sequence[Vec]) -> dict[str, Any]:
        """The point that attracts is in the middle."""
        x, y = (sum(each) / len(corners) for each in zip(*corners, strict=True))
        return {**super().words(corners), "at": [x, y]}


def _box(start: Vec, end: Vec) -> list[Vec]:
    return [start, (end[0], start[1]), end, (start[0], end[1])]
