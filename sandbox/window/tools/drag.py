"""What tools have in common that make something by one drag."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Sequence

from sandbox.render.camera import Vec
from sandbox.render.line import Line
from sandbox.window.tools.tool import Pointer, Tool, outline
from sandbox.window.workspace import Workspace

LEAST_PIXELS = 3.0
"""What would be smaller is not made: the press was a slip."""


class DragTool(Tool, ABC):
    """From where the button goes down to where it comes up."""

    def __init__(self) -> None:
        self._from: Pointer | None = None
        self._to: Pointer | None = None

    @abstractmethod
    def bring(self, workspace: Workspace, start: Vec, end: Vec) -> None:
        """Bring into the world what lies between two points (m)."""

    @abstractmethod
    def corners(self, start: Vec, end: Vec) -> list[Vec]:
        """Its outline while it is drawn (m)."""

    def press(self, workspace: Workspace, pointer: Pointer) -> bool:
        """Begin."""
        self._from = self._to = pointer
        return True

    def move(self, workspace: Workspace, pointer: Pointer) -> None:
        """Stretch it."""
        if self._from is not None:
            self._to = pointer

    def release(self, workspace: Workspace, pointer: Pointer) -> None:
        """Make it."""
        start, self._from = self._from, None
        if start is not None and math.dist(start.pixel, pointer.pixel) >= LEAST_PIXELS:
            self.bring(workspace, start.point, pointer.point)

    def cancel(self, workspace: Workspace) -> bool:
        """Make nothing."""
        busy, self._from = self._from is not None, None
        return busy

    def strokes(self, workspace: Workspace) -> Sequence[Line]:
        """Its outline."""
        if self._from is None or self._to is None:
            return ()
        return outline(workspace, self.corners(self._from.point, self._to.point), closed=True)
