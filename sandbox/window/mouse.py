"""What the mouse does in a scene: the left button is the tool's, the others pan, the wheel zooms."""

from __future__ import annotations

from collections.abc import Sequence

import pygame

from sandbox.render.camera import Vec
from sandbox.render.line import Line
from sandbox.window.tools.tool import Pointer
from sandbox.window.tools.tool_box import ToolBox
from sandbox.window.viewport import ZOOM_A_NOTCH
from sandbox.window.workspace import Workspace

PAN_BUTTONS = (2, 3)


class Mouse:
    """The mouse over a workspace's viewport."""

    def __init__(self, workspace: Workspace, tool_box: ToolBox) -> None:
        self.workspace = workspace
        self._tool_box = tool_box
        self._panning = False
        self._pressed = False
        self.at: Vec = (-1.0, -1.0)
        """Where the pointer is, in pixels of the window."""

    def handle(self, event: pygame.event.Event, taken: bool = False) -> None:
        """Act on a mouse event; all others pass. Those `taken` by panels only end what has begun."""
        workspace = self.workspace
        match event.type:
            case pygame.MOUSEBUTTONDOWN if not taken and workspace.viewport.holds(event.pos):
                self._press(event)
            case pygame.MOUSEBUTTONUP if event.button in (1, *PAN_BUTTONS):
                self._panning = False
                if event.button == 1 and self._pressed:
                    self._pressed = False
                    self._tool_box.tool.release(workspace, self._pointer(event.pos))
            case pygame.MOUSEMOTION:
                self._move(event)
            case pygame.MOUSEWHEEL if not taken:
                workspace.viewport.zoom(ZOOM_A_NOTCH ** (getattr(event, "precise_y", 0.0) or event.y), self.at)

    def strokes(self) -> Sequence[Line]:
        """What the tool draws over the scene."""
        return self._tool_box.tool.strokes(self.workspace)

    def _press(self, event: pygame.event.Event) -> None:
        if event.button == 1:
            self._pressed = self._tool_box.tool.press(self.workspace, self._pointer(event.pos))
            self._panning = not self._pressed
        elif event.button in PAN_BUTTONS:
            self._panning = True

    def _move(self, event: pygame.event.Event) -> None:
        viewport = self.workspace.viewport
        self.at = event.pos
        self.workspace.pointer = viewport.point(event.pos) if viewport.holds(event.pos) else None
        if self._panning:
            self.workspace.viewport.pan(*event.rel)
        # The hand holds a point of the plane, so a pan or zoom moves the target as well.
        self._tool_box.tool.move(self.workspace, self._pointer(event.pos))

    def _pointer(self, pixel: Vec) -> Pointer:
        held = pygame.key.get_mods() if pygame.display.get_init() else 0
        shift, ctrl = bool(held & pygame.KMOD_SHIFT), bool(held & (pygame.KMOD_CTRL | pygame.KMOD_META))
        return Pointer(pixel, self.workspace.viewport.point(pixel), more=shift, free=ctrl)
