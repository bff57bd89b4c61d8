"""The screen while a scene is being loaded and the engine compiled: a window that is visibly alive."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import pygame

from sandbox.engine.compile_status import compile_status
from sandbox.errors import SandboxError
from sandbox.render.camera import Vec
from sandbox.window.gui_style import Palette, palette_of
from sandbox.window.loader import Loader
from sandbox.window.overlay import Overlay
from sandbox.window.screen import Canvas, Screen
from sandbox.window.session import Session

SLOW_SECONDS = 2.0
"""After this long the screen says why it takes so long."""


class LoadingScreen:
    """Shows a turning arc until the session is ready, then what `play` makes of it.

    Where loading fails, `failed` decides what is shown; it may raise the error.
    """

    counts = False

    def __init__(
        self,
        loader: Loader,
        play: Callable[[Session], Screen],
        failed: Callable[[Exception], Screen | None],
        before: Screen | None = None,
    ) -> None:
        self.before = before
        """What was shown before, and is if loading fails."""
        self._loader = loader
        self._play = play
        self._failed = failed
        self._age = 0.0

    def handle(self, event: pygame.event.Event, taken: tuple[bool, bool] = (False, False)) -> None:
        """Nothing to act on: loading cannot be stopped half way."""

    def update(self, elapsed: float) -> Screen | None:
        """Wait for the loader."""
        self._age += elapsed
        if not self._loader.done:
            return self
        try:
            return self._play(self._loader.result())
        except (SandboxError, OSError) as error:
            return self._failed(error)

    def draw(self, canvas: Canvas) -> None:
        """The arc and what is being done."""
        canvas.clear()
        width, height = canvas.display.size
        overlay = Overlay(canvas.gui, scale=canvas.text_scale)
        status = compile_status() if self._age > SLOW_SECONDS else None
        text = f"The first start on a machine compiles the engine: {status}" if status else ""
        lines = (self._loader.message + " …", self._loader.path.name, text)
        draw_progress(overlay, (width / 2, height / 2), lines, self._age, palette_of(canvas.theme))


def draw_progress(overlay: Overlay, middle: Vec, lines: Sequence[str], age: float, colors: Palette) -> None:
    """An arc that has turned for `age` seconds, and below it lines of text, the first of them large."""
    turn, scale = 2.0 * math.pi * (age * 0.8 % 1.0), overlay.scale
    overlay.arc(middle[0], middle[1] - 44.0, 17.0, (turn, turn + 4.2), colors.accent, 3.0)
    for number, text in enumerate(lines):
        size, color = (16.0, colors.faint) if number else (20.0, colors.text)
        x, down = middle[0] - overlay.width(text, size) / 2, (0.0, 32.0, 56.0)[number]
        overlay.text(x, middle[1] + down * scale, text, color, size=size)
