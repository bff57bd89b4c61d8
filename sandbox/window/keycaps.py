"""Keys as they lie on a keyboard: a drawn cap with its sign, and beside it what it does."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.window.gui_style import Palette
from sandbox.window.hint import Key
from sandbox.window.overlay import packed_color

SIGNS = {
    "Left": icons.ICON_FA_ARROW_LEFT, "Right": icons.ICON_FA_ARROW_RIGHT, "Up": icons.ICON_FA_ARROW_UP,
    "Down": icons.ICON_FA_ARROW_DOWN,
}  # fmt: skip
DEVICES = {"Mouse": icons.ICON_FA_COMPUTER_MOUSE, "Pad": icons.ICON_FA_GAMEPAD}
"""First words of caps that are no keys."""
PAD, RIM = 0.42, 0.2
"""Room beside and around what stands on a cap, in heights of the text."""
BETWEEN, BESIDE, APART = 0.2, 0.4, 1.1
"""From cap to cap of one key, from cap to words, and from one key to the next, in heights of the text."""
Lines = list[list[Key]]


class Keycaps:
    """Draws keys with `pen`, an ImGui draw list, with text `size` pixels high."""

    def __init__(self, pen: Any, size: float, colors: Palette) -> None:
        self._pen, self._size, self._colors = pen, size, colors

    def width(self, keys: Sequence[Key], words: bool = True) -> float:
        """Pixels that keys take in one line, with or without what they do."""
        return sum(self._key(key, words) for key in keys) + max(len(keys) - 1, 0) * APART * self._size

    def lines(self, keys: Sequence[Key], room: float, words: bool = True) -> Lines:
        """Keys in lines, each as many as fit into `room` pixels, at least one."""
        return list(self._lines(keys, room, words))

    def draw(self, x: float, y: float, keys: Sequence[Key], words: bool = True) -> None:
        """One line of keys, whose text has its upper edge at y."""
        for key in keys:
            at = x
            for cap in key.caps:
                self._draw_cap(at, y, cap)
                at += self._cap(cap) + BETWEEN * self._size
            if words:
                self._text(at + (BESIDE - BETWEEN) * self._size, y, key.does, self._colors.faint)
            x += self._key(key, words) + APART * self._size

    def _lines(self, keys: Sequence[Key], room: float, words: bool) -> Iterator[list[Key]]:
        line: list[Key] = []
        for key in keys:
            if line and self.width([*line, key], words) > room:
                yield line
                line = []
            line.append(key)
        if line:
            yield line

    def _key(self, key: Key, words: bool) -> float:
        caps = sum(self._cap(cap) for cap in key.caps) + (len(key.caps) - 1) * BETWEEN * self._size
        return caps + (BESIDE * self._size + self._measure(key.does) if words else 0.0)

    def _cap(self, cap: str) -> float:
        """Its width: at least a square."""
        return max(self._measure(sign_of(cap)) + 2 * PAD * self._size, (1.0 + 2 * RIM) * self._size)

    def _draw_cap(self, x: float, y: float, cap: str) -> None:
        """A plate with a darker lower edge, as a key has it."""
        sign, wide, rim, size = sign_of(cap), self._cap(cap), RIM * self._size, self._size
        low, high = imgui.ImVec2(round(x), round(y - rim)), imgui.ImVec2(round(x + wide), round(y + size + rim))
        edge, face = packed_color(self._colors.faint, 0.55), packed_color(self._colors.raised, 1.0)
        rounding = 0.28 * size
        self._pen.add_rect_filled(low, high, edge, rounding)
        inner = imgui.ImVec2(low.x + 1.0, low.y + 1.0), imgui.ImVec2(high.x - 1.0, high.y - max(round(0.16 * size), 2))
        self._pen.add_rect_filled(*inner, face, rounding - 1.0)
        self._text(x + (wide - self._measure(sign)) / 2, y - 0.06 * size, sign, self._colors.text)

    def _measure(self, text: str) -> float:
        return float(imgui.calc_text_size(text).x) * self._size / imgui.get_font_size()

    def _text(self, x: float, y: float, text: str, color: tuple[float, float, float]) -> None:
        at = imgui.ImVec2(round(x), round(y))
        self._pen.add_text(imgui.get_font(), self._size, at, packed_color(color, 1.0), text)


def sign_of(cap: str) -> str:
    """What stands on a cap: an arrow for Left, the sign of a mouse before the name of its button."""
    device, _, rest = cap.partition(" ")
    return f"{DEVICES[device]} {rest}" if device in DEVICES else SIGNS.get(cap, cap)
