"""What the name of a material makes a body look like: "oak" is wood, "wet-stone" is stone."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache

from sandbox.render.oklab import oklch_to_srgb
from sandbox.render.theme import DARK, Color, Theme

FOLLOWS_THEME = 0.6
"""Share of the theme's lightness, against the dark one's, that materials take part in."""
NEIGHBOURS = 0.05
"""By how much in lightness bodies of one material differ, so that they can be told apart."""


@dataclass(frozen=True)
class MaterialLook:
    """`lightness`, `chroma` and `hue` (degrees) in OKLCH on dark; `texture` is a name in `textures.TEXTURES` or ""."""

    words: tuple[str, ...]
    lightness: float
    chroma: float
    hue: float
    texture: str = ""
    opacity: float = 1.0

    def color(self, theme: Theme, lighter: float = 0.0) -> Color:
        """The colour under a theme; `lighter` (-0.5..0.5) says which of its neighbours a body is."""
        lightness = self.lightness + FOLLOWS_THEME * (theme.lightness - DARK.lightness) + NEIGHBOURS * lighter
        return oklch_to_srgb(lightness, self.chroma, self.hue)


LOOKS = (
    MaterialLook(("wood", "oak", "plank", "timber", "log", "crate"), 0.68, 0.085, 68.0, "wood"),
    MaterialLook(("pine", "birch", "bamboo"), 0.77, 0.08, 82.0, "wood"),
    MaterialLook(("teak", "walnut", "mahogany"), 0.58, 0.085, 52.0, "wood"),
    MaterialLook(("cork",), 0.70, 0.075, 62.0, "grains"),
    MaterialLook(("stone", "rock", "granite", "concrete", "pebble"), 0.66, 0.012, 85.0, "stone"),
    MaterialLook(("slate", "basalt"), 0.56, 0.022, 255.0, "stone"),
    MaterialLook(("marble", "ivory", "chalk"), 0.87, 0.015, 90.0, "stone"),
    MaterialLook(("brick", "clay", "terracotta"), 0.62, 0.095, 40.0, "grains"),
    MaterialLook(("sand", "grain", "gravel"), 0.79, 0.07, 86.0, "grains"),
    MaterialLook(("steel", "tin", "chrome", "aluminium", "aluminum"), 0.76, 0.014, 250.0, "steel"),
    MaterialLook(("iron", "lead", "anvil"), 0.58, 0.016, 265.0, "steel"),
    MaterialLook(("brass", "gold", "bronze"), 0.77, 0.105, 88.0, "steel"),
    MaterialLook(("copper",), 0.67, 0.105, 48.0, "steel"),
    MaterialLook(("ice", "snow"), 0.87, 0.045, 222.0, "ice", 0.72),
    MaterialLook(("glass", "gem"), 0.84, 0.045, 190.0, "ice", 0.55),
    MaterialLook(("water",), 0.70, 0.105, 240.0, "", 0.7),
    MaterialLook(("rubber", "tyre", "tire"), 0.47, 0.02, 300.0, "rubber"),
)
"""Every look; an earlier one counts where a name has words of two."""


@cache
def look_of(name: str) -> MaterialLook | None:
    """The look of a material by its name: words end at whatever is no letter, and longer ones may only end so
    ("sandstone" is stone). None if no word is known.
    """
    tokens = [token for token in re.split(r"[^a-z]+", name.lower()) if token]
    for end in (False, True):
        for look in LOOKS:
            if any(_means(token, word, end) for token in tokens for word in look.words):
                return look
    return None


def _means(token: str, word: str, end: bool) -> bool:
    if not end:
        return token in (word, word + "s", word + "en")
    return len(word) >= 4 and token.endswith(word)
