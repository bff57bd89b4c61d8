"""Colours: a calm dark background, a hue for each family of bodies, and its members spread gently around it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

Color: TypeAlias = tuple[float, float, float]
"""sRGB, 0..1 each."""


def hex_color(text: str) -> Color:
    """`"#rrggbb"`, `"#rgb"` or a CSS colour name -> sRGB 0..1. Raises ValueError for anything else."""
    from PIL import ImageColor

    red, green, blue = ImageColor.getrgb(text)[:3]
    return red / 255, green / 255, blue / 255


@dataclass(frozen=True)
class Theme:
    """All colours of a picture.

    Families take their hues (degrees in OKLCH) from `hues`, and with each of them a difference in lightness, `lighter`:
    hues that look alike to the colour-blind differ in that. A large family spreads over `sweep` degrees and
    neighbours differ by up to `jitter`. `outline`, `static_outline` and `sleep` say how far (0..1) outlines
    move towards `light` and sleeping bodies towards the background.
    """

    background: Color
    grid_minor: Color
    grid_major: Color
    grid_axis: Color
    static: Color
    kinematic: Color
    frozen: Color
    light: Color
    ink: Color
    drag: Color
    joint: Color
    water: Color
    wind: Color
    gravity: Color
    flame: Color
    spark: Color = (1.0, 0.97, 0.88)
    shadow: Color = (0.0, 0.0, 0.0)
    shadow_opacity: float = 0.5
    hues: tuple[float, ...] = (28.0, 62.0, 92.0, 140.0, 178.0, 215.0, 250.0, 288.0, 325.0, 358.0)
    lighter: tuple[float, ...] = (0.0, -0.08, 0.0, 0.08, 0.0, 0.0, -0.08, 0.08, -0.08, -0.08)
    sweep: float = 75.0
    jitter: float = 26.0
    lightness: float = 0.745
    chroma: float = 0.105
    outline: float = 0.32
    static_outline: float = 0.22
    sleep: float = 0.26


DARK = Theme(
    background=hex_color("#12151b"),
    grid_minor=hex_color("#1a1f27"),
    grid_major=hex_color("#262d39"),
    grid_axis=hex_color("#313a48"),
    static=hex_color("#343c49"),
    kinematic=hex_color("#7d8fb3"),
    frozen=hex_color("#d9484f"),
    light=hex_color("#ffffff"),
    ink=hex_color("#0d0f13"),
    drag=hex_color("#ffd479"),
    joint=hex_color("#dfe5ee"),
    water=hex_color("#4aa3e0"),
    wind=hex_color("#a9c4d6"),
    gravity=hex_color("#a58be0"),
    flame=hex_color("#ff9a3d"),
)

LIGHT = Theme(
    background=hex_color("#fbfaf6"),
    grid_minor=hex_color("#f1efe8"),
    grid_major=hex_color("#e7e4da"),
    grid_axis=hex_color("#d5d1c4"),
    static=hex_color("#b9bdc6"),
    kinematic=hex_color("#8090b4"),
    frozen=hex_color("#c8343c"),
    light=hex_color("#12151b"),
    ink=hex_color("#ffffff"),
    drag=hex_color("#b06a00"),
    joint=hex_color("#3a4352"),
    water=hex_color("#2878b8"),
    wind=hex_color("#6b8496"),
    gravity=hex_color("#7a5cc0"),
    flame=hex_color("#e06a10"),
    shadow=hex_color("#2b2620"),
    shadow_opacity=0.26,
    lightness=0.6,
    chroma=0.13,
)
"""The same hues on paper: for pictures in pages that a reader may see light or dark."""

THEMES = {"dark": DARK, "light": LIGHT}
"""The themes by name."""
