"""How large text and window are at first on a screen with many pixels; after that the user's own choice holds."""

from __future__ import annotations

from sandbox.render.camera import Size

USUAL_SIZE: Size = (1280, 800)
_LINES = 1440
"""A screen with so many lines shows text at its usual size; with more, its pixels are smaller."""


def first_scale(screen: Size) -> float:
    """How many times the usual size suits a screen of so many pixels: 1 to 3 in quarters."""
    return min(max(round(4.0 * min(screen[1], screen[0]) / _LINES) / 4.0, 1.0), 3.0)


def first_size(screen: Size) -> Size:
    """The size of the first window on a screen, in pixels, with room around it."""
    scale = first_scale(screen)
    width, height = round(scale * USUAL_SIZE[0]), round(scale * USUAL_SIZE[1])
    return min(width, round(0.9 * screen[0])), min(height, round(0.9 * screen[1]))
