"""What a screen of the window is: it handles events, lets time pass, and draws itself on a canvas."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Protocol

import pygame

from sandbox.render.draw_list import DrawList
from sandbox.render.theme import Theme
from sandbox.window.display import Display
from sandbox.window.gl_painter import GlPainter
from sandbox.window.gui import Gui
from sandbox.window.kept_picture import KeptPicture
from sandbox.window.remembered import Remembered


@dataclass
class Canvas:
    """What screens draw with."""

    display: Display
    painter: GlPainter
    gui: Gui
    theme: Theme
    remembered: Remembered = field(default_factory=Remembered)
    suited_scale: float = 1.0
    """How many times its usual size suits text on this screen."""
    _kept: KeptPicture | None = None
    _last: tuple[DrawList, tuple[int, int, int, int]] | None = None

    @property
    def text_scale(self) -> float:
        """How many times its usual size text has: as the user chose, or as suits the screen."""
        return self.remembered.text_scale or self.suited_scale

    def clear(self) -> None:
        """An empty picture."""
        self._last = None
        self.display.context.clear(*self.theme.background)

    def paint(self, picture: DrawList, rect: tuple[int, int, int, int]) -> None:
        """Draw a picture into a part of the window: left, top, width, height in pixels. The rest is left empty.

        The same picture as the last time is not drawn again: it was kept. What is not to be filled in only waits for
        `paint_again`.
        """
        self._last = picture, rect
        if not self.display.filled:
            return
        size = self.display.size
        if self._kept is None or self._kept.size != size:
            self._kept = KeptPicture(self.display.context, size, self._kept)
        self._kept.show(picture, rect, self.display.begin, lambda: self._draw(picture, rect))

    def paint_again(self) -> None:
        """The picture of the scene that is shown once more, with nothing around it."""
        last = self._last
        self.clear()
        if last is not None:
            self.paint(*last)

    def _draw(self, picture: DrawList, rect: tuple[int, int, int, int]) -> None:
        context, height = self.display.context, self.display.size[1]
        context.clear(*picture.theme.background)
        box = rect[0], height - rect[1] - rect[3], rect[2], rect[3]
        context.viewport = context.scissor = box
        self.painter.paint(picture)
        context.viewport, context.scissor = (0, 0, *self.display.size), None


class Screen(Protocol):
    """One of the things that the window can show."""

    counts: bool
    """Whether its pictures count towards a limit on frames."""

    def handle(self, event: pygame.event.Event, taken: tuple[bool, bool] = (False, False)) -> None:
        """Act on an event; `taken` says whether panels want the mouse, and the keyboard."""

    def update(self, elapsed: float) -> Screen | None:
        """Let `elapsed` seconds pass; gives the screen to show now, None to leave the program."""

    def draw(self, canvas: Canvas) -> None:
        """Draw the picture, then what lies over it."""
