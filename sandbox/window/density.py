"""How large text and window are on a screen: as the system says, or as its pixels suggest. What the user chooses by
hand goes before."""

from __future__ import annotations

from sandbox.render.camera import Size

USUAL_SIZE: Size = (1280, 800)
_LINES = 1440
"""A screen with so many lines shows text at its usual size; with more, its pixels are smaller."""


def suited_scale(screen: Size, told: float | None = None) -> float:
    """How many times the usual size suits a screen of so many pixels: 1 to 3 in quarters. `told` is what the system
    says, if it does.
    """
    scale = min(screen) / _LINES if told is None else told
    return min(max(round(4.0 * scale) / 4.0, 1.0), 3.0)


def first_size(screen: Size, scale: float) -> Size:
    """The size of the first window on a screen, in pixels, with room around it, where all is `scale` times as large."""
    width, height = round(scale * USUAL_SIZE[0]), round(scale * USUAL_SIZE[1])
    return min(width, round(0.9 * screen[0])), min(height, round(0.9 * screen[1]))
