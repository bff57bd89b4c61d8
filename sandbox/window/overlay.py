"""Text, panels and arcs at pixel positions, and text fitted into a width."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any

from imgui_bundle import imgui

from sandbox.render.label import Label
from sandbox.render.theme import Color
from sandbox.window.fitting import fitting
from sandbox.window.gui import TEXT_SIZE, Gui

HALO = ((-1, -1), (1, -1), (-1, 1), (1, 1), (0, 1), (0, -1), (1, 0), (-1, 0))
"""Pixels by which words are moved to make their halo."""


class Overlay:
    """Draws text and panels at pixel positions over the picture (or into `target`, an ImGui draw list).

    Text is `scale` times as large as asked for.
    """

    def __init__(self, gui: Gui, target: Any = None, scale: float = 1.0) -> None:
        self.gui = gui
        self.scale = scale
        self.pen: Any = target if target is not None else imgui.get_background_draw_list()

    @contextmanager
    def within(self, rect: tuple[int, int, int, int]) -> Iterator[None]:
        """Cut off what is drawn meanwhile at the edges of a rectangle: left, top, width, height."""
        left, top, width, height = rect
        self.pen.push_clip_rect(imgui.ImVec2(left, top), imgui.ImVec2(left + width, top + height), True)
        try:
            yield
        finally:
            self.pen.pop_clip_rect()

    def text(
        self,
        x: float,
        y: float,
        text: str,
        color: Color,
        opacity: float = 1.0,
        size: float = TEXT_SIZE,
        bold: bool = False,
    ) -> None:
        """Write one line with its top left corner at (x, y)."""
        font = self.gui.bold if bold else self.gui.regular
        self.pen.add_text(font, size * self.scale, imgui.ImVec2(round(x), round(y)), packed_color(color, opacity), text)

    def width(self, text: str, size: float = TEXT_SIZE, bold: bool = False) -> float:
        """Pixels that a line of text takes."""
        points = size * self.scale / imgui.get_style().font_scale_main  # which ImGui multiplies by, but not `text`
        imgui.push_font(self.gui.bold if bold else self.gui.regular, points)
        width = float(imgui.calc_text_size(text).x)
        imgui.pop_font()
        return width

    def labels(self, labels: Iterable[Label], rect: tuple[int, int, int, int], halo: Color) -> None:
        """Write the labels of a picture that fills `rect` (left, top, width, height in pixels), each with a halo, so
        that it is read over marks and bodies.
        """
        for label in labels:
            width = self.width(label.text, label.size)
            left = label.at[0] - {"left": 0.0, "middle": 0.5, "right": 1.0}[label.anchor] * width
            x, y = rect[0] + left, rect[1] + label.at[1] - 0.55 * self.scale * label.size
            for dx, dy in HALO:
                self.text(x + dx, y + dy, label.text, halo, 0.6, label.size)
            self.text(x, y, label.text, label.color, 1.0, label.size)

    def panel(self, box: tuple[float, float, float, float], color: Color, opacity: float, rounding: float) -> None:
        """Fill a rectangle (left, top, right, bottom) with round corners."""
        low, high = imgui.ImVec2(box[0], box[1]), imgui.ImVec2(box[2], box[3])
        self.pen.add_rect_filled(low, high, packed_color(color, opacity), rounding)

    def arc(self, x: float, y: float, radius: float, turn: tuple[float, float], color: Color, width: float) -> None:
        """Stroke a part of a circle between two angles in radians."""
        self.pen.path_arc_to(imgui.ImVec2(x, y), radius, turn[0], turn[1], 32)
        self.pen.path_stroke(packed_color(color, 1.0), thickness=width)


def packed_color(color: Color, opacity: float) -> int:
    """A colour as ImGui's 32-bit number."""
    return int(imgui.color_convert_float4_to_u32(imgui.ImVec4(*color, opacity)))


def shorten(overlay: Overlay, text: str, room: float, size: float = TEXT_SIZE) -> str:
    """`text`, cut with an ellipsis where it would be wider than `room` pixels."""
    return fitting(text, room, lambda words: overlay.width(words, size))


def split_line(overlay: Overlay, text: str, room: float, size: float = TEXT_SIZE) -> tuple[str, str]:
    """As many words of `text` as fit into `room` pixels, at least one, and the rest."""
    words = text.split()
    count = len(words)
    while count > 1 and overlay.width(" ".join(words[:count]), size) > room:
        count -= 1
    return " ".join(words[:count]), " ".join(words[count:])
