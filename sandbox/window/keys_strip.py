"""The keys of a game above the scene, where the line of time has no room for them."""

from __future__ import annotations

from collections.abc import Sequence

from sandbox.window.gui import TEXT_SIZE
from sandbox.window.gui_style import Palette
from sandbox.window.hint import Key
from sandbox.window.keycaps import Keycaps
from sandbox.window.overlay import Overlay
from sandbox.window.viewport import Rect

MARGIN, PAD = 14.0, 9.0
MOST_SHARE = 0.25
"""Of the height that there is; where all would take more, only the caps are drawn."""


class KeysStrip:
    """`below` says what it leaves of a rectangle, `draw` draws it above that."""

    def __init__(self, overlay: Overlay, keys: Sequence[Key], colors: Palette) -> None:
        self._overlay, self._keys, self._colors = overlay, keys, colors
        self._size = TEXT_SIZE * overlay.scale
        self._caps = Keycaps(overlay.pen, self._size, colors)
        self._line = self._size + 2 * PAD
        self._words = True
        """Whether what keys do stands beside them."""

    def below(self, rect: Rect) -> Rect:
        """What is left of a rectangle for the scene."""
        left, top, width, height = rect
        self._words = len(self._lines(width)) * self._line <= MOST_SHARE * height
        high = round(len(self._lines(width)) * self._line)
        return left, top + high, width, max(height - high, 1)

    def draw(self, rect: Rect) -> None:
        """The keys, if there are any, above a rectangle."""
        left, bottom, width, _ = rect
        lines = self._lines(width)
        if not lines:
            return
        top = bottom - round(len(lines) * self._line)
        self._overlay.panel((left, top, left + width, bottom), self._colors.panel, 1.0, 0.0)
        self._overlay.panel((left, bottom - 1.0, left + width, bottom), self._colors.line, 1.0, 0.0)
        for number, line in enumerate(lines):
            self._caps.draw(left + MARGIN, top + number * self._line + PAD - 1.0, line, self._words)

    def _lines(self, width: float) -> list[list[Key]]:
        return self._caps.lines(self._keys, width - 2 * MARGIN, self._words)
