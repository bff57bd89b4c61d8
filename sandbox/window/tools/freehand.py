"""Tools that draw an outline: corner by corner with clicks, or in one freehand stroke."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any, ClassVar

from imgui_bundle import icons_fontawesome_6 as icons

from sandbox.engine.commands.spawn import Spawn
from sandbox.render.camera import Vec
from sandbox.render.line import Line
from sandbox.render.number_text import counted
from sandbox.window.hint import GIVE_UP, Hint, Key
from sandbox.window.tools.simplify import simplified
from sandbox.window.tools.tool import Pointer, Tool, fresh_id, outline
from sandbox.window.workspace import Workspace

CLOSE_PIXELS = 10.0
"""A corner this near to the first one closes the outline."""
STROKE_PIXELS = 8.0
"""A press that is dragged farther is a freehand stroke."""
TOLERANCE_PIXELS = 2.5
"""How far a simplified stroke may be from what was drawn."""

FINISH = Key(("Enter",), "finish")


class Freehand(Tool, ABC):
    """Collects corners until the outline is closed, Enter is pressed, or a freehand stroke ends."""

    least: ClassVar[int]
    """How many corners there must be."""
    closes: ClassVar[bool]

    def __init__(self) -> None:
        self._corners: list[Vec] = []
        self.stroke: list[Vec] = []
        """The way of the pointer while the button is down (m)."""
        self._pressed: Pointer | None = None
        self._cursor: Pointer | None = None

    @property
    def dragged(self) -> Pointer | None:
        """Where the button went down for what may be a stroke; None if it did not."""
        return self._pressed if not self._corners else None

    @abstractmethod
    def bring(self, workspace: Workspace, corners: Sequence[Vec]) -> None:
        """Bring what has these corners into the world, and select it."""

    def stroke_corners(self, stroke: Sequence[Vec], start: Pointer, tolerance: float) -> list[Vec]:
        """The corners of what was drawn in one stroke (m)."""
        return simplified(stroke, tolerance, self.closes)

    def press(self, workspace: Workspace, pointer: Pointer) -> bool:
        """A corner, or the beginning of a stroke."""
        self._pressed = self._cursor = pointer
        self.stroke = [pointer.point]
        return True

    def move(self, workspace: Workspace, pointer: Pointer) -> None:
        """Follow the hand."""
        self._cursor = pointer
        if self._pressed is not None and pointer.point != self.stroke[-1]:
            self.stroke.append(pointer.point)

    def release(self, workspace: Workspace, pointer: Pointer) -> None:
        """A corner more, the end of the outline, or the end of a stroke."""
        start, self._pressed = self._pressed, None
        if start is None:
            return
        scale = workspace.viewport.camera.scale
        if not self._corners and _spread(self.stroke) * scale > STROKE_PIXELS:
            self._finish(workspace, self.stroke_corners(self.stroke, start, TOLERANCE_PIXELS / scale))
            return
        near = self._corners and math.dist(self._corners[0], start.point) * scale < CLOSE_PIXELS
        if near and len(self._corners) >= self.least:
            self._finish(workspace, self._corners)
        elif not self._corners or self._corners[-1] != start.point:
            self._corners.append(start.point)

    def confirm(self, workspace: Workspace) -> bool:
        """The outline is done."""
        if not self._corners:
            return False
        self._finish(workspace, self._corners)
        return True

    def cancel(self, workspace: Workspace) -> bool:
        """Forget the corners."""
        busy = bool(self._corners) or self._pressed is not None
        self._corners, self.stroke, self._pressed = [], [], None
        return busy

    def strokes(self, workspace: Workspace) -> Sequence[Line]:
        """What there is of the outline, a line to the cursor, and a dot on the first corner."""
        if self._pressed is not None and not self._corners:
            return outline(workspace, self.stroke, closed=False)
        if not self._corners or self._cursor is None:
            return ()
        lines = outline(workspace, [*self._corners, self._cursor.point], closed=False)
        first = workspace.viewport.camera.to_screen(self._corners[0])
        at = float(first[0]), float(first[1])
        return [*lines, Line(at, at, CLOSE_PIXELS, workspace.theme.drag, 0.9)]

    def hint(self, workspace: Workspace) -> Hint:
        """How to go on, and from the least number of corners on how to end."""
        count = len(self._corners)
        if not count:
            return super().hint(workspace)
        ends = count >= self.least
        way = "; the first one ends it" if ends and self.closes else ""
        return Hint(f"{counted(count, 'corner')}: click the next{way}.", (*((FINISH,) * ends), GIVE_UP))

    def _finish(self, workspace: Workspace, corners: Sequence[Vec]) -> None:
        corners = list(corners)
        self.cancel(workspace)
        if len(corners) < self.least:
            workspace.say(f"not drawn: that takes {self.least} corners or more, these are {len(corners)}")
            return
        self.bring(workspace, corners)


class DrawnBody(Freehand):
    """A body about the middle of its corners."""

    @abstractmethod
    def words(self, corners: Sequence[Vec], middle: Vec) -> dict[str, Any]:
        """The body with these corners, as a scene file has it, with its origin at `middle`; without its id."""

    def bring(self, workspace: Workspace, corners: Sequence[Vec]) -> None:
        """Bring it into the world, and select it."""
        name = fresh_id(workspace, self.name)
        xs, ys = [x for x, _ in corners], [y for _, y in corners]
        middle = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
        if workspace.do(f"Draw {name}", Spawn({"id": name, **self.words(corners, middle)})):
            workspace.selection.pick(name)


class PolygonTool(DrawnBody):
    """Convex or concave; a concave one is divided into convex parts by the engine."""

    name, title, icon, key = "polygon", "Polygon", icons.ICON_FA_DRAW_POLYGON, "P"
    help = "Click corner by corner, or draw the outline in one stroke."
    least, closes = 3, True

    def words(self, corners: Sequence[Vec], middle: Vec) -> dict[str, Any]:
        """A polygon about its middle."""
        return {"shapes": [{"polygon": _about(corners, middle)}], "position": list(middle)}


class ChainTool(DrawnBody):
    """Ground: lines from point to point that do not move."""

    name, title, icon, key = "chain", "Chain", icons.ICON_FA_BEZIER_CURVE, "L"
    help = "Draw a line that bodies stand on: click by click, or in one stroke."
    least, closes = 2, False

    def words(self, corners: Sequence[Vec], middle: Vec) -> dict[str, Any]:
        """A static chain."""
        return {"type": "static", "shapes": [{"chain": _about(corners, middle)}], "position": list(middle)}


def _about(corners: Sequence[Vec], middle: Vec) -> list[list[float]]:
    return [[x - middle[0], y - middle[1]] for x, y in corners]


def _spread(points: Sequence[Vec]) -> float:
    """Width or height of a box about points, whichever is greater, in metres."""
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return max(max(xs) - min(xs), max(ys) - min(ys))
