"""Where the pointer is, and how long a metre is, at the lower edge of the scene."""

from __future__ import annotations

import math

from sandbox.window.gui_style import palette_of
from sandbox.window.overlay import Overlay
from sandbox.window.workspace import Workspace

WIDEST_PIXELS = 120.0
MARGIN = 12.0
PAD = 6.0
SIZE = 14.0


def draw_scale_bar(overlay: Overlay, workspace: Workspace, pointer: tuple[float, float]) -> float:
    """A bar of a round length, and the coordinates of the pointer (a pixel of the window) in metres. Gives the pixel of
    the window where it begins."""
    viewport, colors = workspace.viewport, palette_of(workspace.theme)
    left, top, width, height = viewport.rect
    if width < 240 or height < 120:
        return float(left + width)
    length = round_length(WIDEST_PIXELS / viewport.camera.scale)
    pixels = length * viewport.camera.scale
    right, y = left + width - MARGIN, top + height - MARGIN
    text, place, scale = length_text(length), _place(workspace, pointer), overlay.scale
    wide = overlay.width(place, SIZE)
    start = right - pixels - (20.0 + wide if place else 0.0)
    overlay.panel((start - PAD, y - 8.0 - scale * SIZE, right + PAD, y + 5.0), colors.panel, 0.85, 6.0)
    for box in (
        (right - pixels, y - 2.0, right, y),
        (right - pixels, y - 7.0, right - pixels + 1.5, y),
        (right - 1.5, y - 7.0, right, y),
    ):
        overlay.panel(box, colors.faint, 0.9, 0.0)
    middle = right - pixels / 2 - overlay.width(text, SIZE) / 2
    overlay.text(middle, y - 6.0 - scale * SIZE, text, colors.faint, size=SIZE)
    if place:
        overlay.text(start, y - 2.0 - scale * SIZE, place, colors.faint, size=SIZE)
    return start - PAD


def _place(workspace: Workspace, pointer: tuple[float, float]) -> str:
    """The coordinates of the pointer with as many digits as a pixel is worth; nothing outside the scene."""
    viewport = workspace.viewport
    if not viewport.holds(pointer):
        return ""
    digits = max(2 - math.floor(math.log10(max(1.0 / viewport.camera.scale, 1e-12))) - 2, 0)
    x, up = viewport.point(pointer)
    return f"{x:.{digits}f}, {up:.{digits}f} m"


def round_length(most: float) -> float:
    """The greatest 1, 2 or 5 times a power of ten that is at most `most`, in metres."""
    power = 10.0 ** math.floor(math.log10(most))
    return next(times * power for times in (5.0, 2.0, 1.0) if times * power <= most * (1.0 + 1e-12))


def length_text(length: float) -> str:
    """A length in metres with a unit that keeps the number short."""
    for unit, size in (("km", 1e3), ("m", 1.0), ("cm", 1e-2), ("mm", 1e-3)):
        if length >= size:
            return f"{length / size:g} {unit}"
    return f"{length * 1e6:g} µm"
