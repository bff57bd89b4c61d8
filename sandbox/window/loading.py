"""The screen while a scene is being loaded and the engine compiled: a window that is visibly alive."""

from __future__ import annotations

import math
from collections.abc import Callable

import pygame

from sandbox.engine.compile_status import compile_status
from sandbox.errors import SandboxError
from sandbox.render.camera import Size
from sandbox.window.gui_style import palette_of
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
    ) -> None:
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
        scale, colors = canvas.remembered.text_scale or 1.0, palette_of(canvas.theme)
        overlay = Overlay(canvas.gui, scale=scale)
        turn = 2.0 * math.pi * (self._age * 0.8 % 1.0)
        overlay.arc(width / 2, height / 2 - 44.0, 17.0, (turn, turn + 4.2), colors.accent, 3.0)
        _center(overlay, (width, height), 0.0, self._loader.message + " …", 20.0, colors.text)
        _center(overlay, (width, height), 32.0 * scale, self._loader.path.name, 16.0, colors.faint)
        if self._age > SLOW_SECONDS:
            status = compile_status()
            text = f"The first start on a machine compiles the engine: {status}" if status else ""
            _center(overlay, (width, height), 72.0 * scale, text, 16.0, colors.faint)


def _center(
    overlay: Overlay, size: Size, down: float, text: str, points: float, color: tuple[float, float, float]
) -> None:
    overlay.text((size[0] - overlay.width(text, points)) / 2, size[1] / 2 + down, text, color, size=points)
