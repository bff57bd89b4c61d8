"""One card of the gallery: a picture, the title, and what to watch for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from imgui_bundle import imgui

from sandbox.scene.catalog import Entry
from sandbox.window.gui_style import Palette
from sandbox.window.overlay import Overlay, packed_color, shorten, split_line

PICTURE_SHARE = 171 / 304
"""Height of the picture as a share of its width."""
ABOUT_HEIGHT = 74.0
INDENT, ROUNDING = 11.0, 9.0


@dataclass(frozen=True)
class Card:
    """What it shows: an entry, its picture (a moderngl texture) once there is one, and whether it is chosen."""

    entry: Entry
    picture: Any
    lit: bool
    colors: Palette


def draw_card(overlay: Overlay, card: Card, at: tuple[float, float], size: tuple[float, float]) -> None:
    """Draw it with its corner at a pixel; about in two lines at most, an edge of light when it is chosen."""
    (x, y), colors, entry, scale = at, card.colors, card.entry, overlay.scale
    if card.lit:
        overlay.panel((x - 2.0, y - 2.0, x + size[0] + 2.0, y + size[1] + 2.0), colors.accent, 0.9, ROUNDING + 2.0)
    overlay.panel((x, y, x + size[0], y + size[1]), colors.panel, 1.0, ROUNDING)
    high = size[0] * PICTURE_SHARE
    _draw_picture(overlay, card, (x, y, x + size[0], y + high))
    low, opposite = imgui.ImVec2(x, y), imgui.ImVec2(x + size[0], y + size[1])
    overlay.pen.add_rect(low, opposite, packed_color(colors.line, 1.0), ROUNDING)
    indent = scale * INDENT
    room = size[0] - 2 * indent
    overlay.text(x + indent, y + high + 8.0 * scale, shorten(overlay, entry.title, room), colors.text)
    first, rest = split_line(overlay, entry.about, room, 14.0)
    overlay.text(x + indent, y + high + 31.0 * scale, first, colors.faint, size=14.0)
    overlay.text(x + indent, y + high + 48.0 * scale, shorten(overlay, rest, room, 14.0), colors.faint, size=14.0)


def _draw_picture(overlay: Overlay, card: Card, box: tuple[float, float, float, float]) -> None:
    low, high = imgui.ImVec2(box[0], box[1]), imgui.ImVec2(box[2], box[3])
    corners = imgui.ImDrawFlags_.round_top
    if card.picture is None:
        overlay.pen.add_rect_filled(low, high, packed_color(card.colors.inset, 1.0), ROUNDING, corners)
        return
    texture = imgui.ImTextureRef(card.picture.glo)
    whole = imgui.ImVec2(0.0, 0.0), imgui.ImVec2(1.0, 1.0)
    overlay.pen.add_image_rounded(texture, low, high, *whole, 0xFFFFFFFF, ROUNDING, corners)
