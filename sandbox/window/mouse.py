"""What the mouse does in a scene: the left button drags bodies, the others pan, the wheel zooms."""

from __future__ import annotations

from dataclasses import dataclass

import pygame

from sandbox.render.camera import Camera, Vec
from sandbox.render.frame import Frame
from sandbox.render.line import Line
from sandbox.render.theme import Theme
from sandbox.window.session import Session

GRAB_PIXELS = 6.0
"""How far beside a body a click still catches it."""
ZOOM_A_NOTCH = 1.15
PAN_BUTTONS = (2, 3)


@dataclass
class Mouse:
    """The mouse over a session; owns the camera that it moves."""

    session: Session
    camera: Camera
    touched: bool = False
    """True once the user has chosen the view; until then it follows the window."""
    _panning: bool = False

    def handle(self, event: pygame.event.Event) -> None:
        """Act on a mouse event; all others pass."""
        match event.type:
            case pygame.MOUSEBUTTONDOWN if event.button == 1:
                self._panning = not self._grab(event.pos)
            case pygame.MOUSEBUTTONDOWN if event.button in PAN_BUTTONS:
                self._panning = True
            case pygame.MOUSEBUTTONUP if event.button in (1, *PAN_BUTTONS):
                self._panning = False
                if event.button == 1:
                    self.session.release()
            case pygame.MOUSEMOTION:
                self._move(event)
            case pygame.MOUSEWHEEL:
                self.zoom(ZOOM_A_NOTCH ** (event.precise_y or event.y), pygame.mouse.get_pos())

    def zoom(self, factor: float, about: Vec) -> None:
        """Zoom by `factor` and keep what lies under the pixel `about`."""
        self.camera = self.camera.zoomed(factor, about)
        self.touched = True

    def strokes(self, frame: Frame, theme: Theme) -> list[Line]:
        """The line from the grabbed point to the hand."""
        if self.session.grabbed is None:
            return []
        start, end = self.camera.to_screen([self.session.grip(frame), self.session.target])
        grip, hand = (float(start[0]), float(start[1])), (float(end[0]), float(end[1]))
        rope = Line(grip, hand, 1.6, theme.drag, 0.75)
        return [rope, Line(grip, grip, 6.0, theme.drag), Line(hand, hand, 8.0, theme.drag)]

    def _grab(self, pixel: Vec) -> bool:
        return self.session.grab(self.camera.point(pixel), GRAB_PIXELS / self.camera.scale)

    def _move(self, event: pygame.event.Event) -> None:
        if self._panning:
            self.camera = self.camera.panned(*event.rel)
            self.touched = True
        # The hand holds a point of the plane, so a pan or zoom moves the target as well.
        self.session.drag(self.camera.point(event.pos))
