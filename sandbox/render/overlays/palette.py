"""The colours of overlays: few, told apart by the colour-blind (after Okabe and Ito), for dark and light themes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sandbox.render.camera import Floats
from sandbox.render.geometry import Ints
from sandbox.render.oklab import oklch_to_srgb
from sandbox.render.theme import Color, Theme, hex_color

GOLDEN_DEGREES = 137.50776
_CYCLE = 48
"""Colours of a row of categories before they begin again."""


@dataclass(frozen=True)
class Palette:
    """One colour a meaning; `halo` goes around strokes and words, `levels` are lightnesses of categories."""

    orange: Color
    blue: Color
    green: Color
    yellow: Color
    red: Color
    purple: Color
    text: Color
    quiet: Color
    halo: Color
    levels: tuple[float, float, float]
    chroma: float

    def categories(self, numbers: Ints) -> Floats:
        """A colour (n, 3) for each number; neighbouring numbers differ most."""
        table = np.array([self._category(k) for k in range(_CYCLE)])
        colors: Floats = table[np.asarray(numbers) % _CYCLE]
        return colors

    def _category(self, k: int) -> Color:
        return oklch_to_srgb(self.levels[k % 3], self.chroma, 40.0 + GOLDEN_DEGREES * k)

    def ramp(self, shares: Floats) -> Floats:
        """Colours (n, 3) from quiet (0) over blue and yellow to red (1)."""
        stops = np.array([self.quiet, self.blue, self.yellow, self.red])
        place = np.clip(np.asarray(shares, np.float64), 0.0, 1.0) * (len(stops) - 1)
        return np.column_stack([np.interp(place, range(len(stops)), stops[:, part]) for part in range(3)])


_ON_DARK = Palette(
    orange=hex_color("#ffb02e"),
    blue=hex_color("#62bdf2"),
    green=hex_color("#35cfa0"),
    yellow=hex_color("#f5e663"),
    red=hex_color("#ff6f52"),
    purple=hex_color("#e39ad0"),
    text=hex_color("#eef2f8"),
    quiet=hex_color("#8792a4"),
    halo=hex_color("#0b0d11"),
    levels=(0.72, 0.84, 0.61),
    chroma=0.13,
)
_ON_LIGHT = Palette(
    orange=hex_color("#b86a00"),
    blue=hex_color("#0f6fab"),
    green=hex_color("#00765a"),
    yellow=hex_color("#8a7400"),
    red=hex_color("#c2330d"),
    purple=hex_color("#9a3f85"),
    text=hex_color("#1b212b"),
    quiet=hex_color("#6c7482"),
    halo=hex_color("#ffffff"),
    levels=(0.58, 0.7, 0.47),
    chroma=0.14,
)


def palette_for(theme: Theme) -> Palette:
    """The palette that shows on the theme's background."""
    return _ON_LIGHT if is_light(theme) else _ON_DARK


def is_light(theme: Theme) -> bool:
    """Whether a theme is dark on light."""
    return sum(theme.background) > 1.5
