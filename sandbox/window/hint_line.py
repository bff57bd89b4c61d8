"""What the tool in hand says, at the right end of the line of time: keys first, then as many words as find room."""

from __future__ import annotations

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.window.gui_style import Palette
from sandbox.window.hint import Hint
from sandbox.window.keycaps import Keycaps
from sandbox.window.widgets import mark

READABLE_EMS = 14.0
"""Width, in heights of the text, from which shortened words say something."""
SIGN_EMS, GAP_EMS = 2.5, 1.2
"""What is kept free for the sign of a hint that has no room, and before the hint, in heights of the text."""


class HintLine:
    """One hint. What does not fit is said under the pointer; where nothing would, a sign stands for it."""

    def __init__(self, hint: Hint, colors: Palette) -> None:
        self._hint, self._size = hint, imgui.get_font_size()
        self._caps = Keycaps(imgui.get_window_draw_list(), self._size, colors)

    @property
    def least(self) -> float:
        """Pixels that others are to leave to it: for its keys, or for its sign."""
        return max(self._caps.width(self._hint.keys, words=False) + GAP_EMS * self._size, SIGN_EMS * self._size)

    def draw(self) -> None:
        """At the right edge of the line."""
        room = imgui.get_content_region_avail().x - 4.0 - GAP_EMS * self._size
        keys = self._hint.keys
        told = self._caps.width(keys) <= room
        wide = self._caps.width(keys, told)
        if keys and wide > room:
            return self._put(icons.ICON_FA_CIRCLE_INFO, 0.0, False)
        between = GAP_EMS * self._size if keys else 0.0
        words = self._fitting(room - wide - between) if told else ""
        if not words and not keys and self._hint.words:
            words = icons.ICON_FA_CIRCLE_INFO
        self._put(words, wide + (between if words else 0.0), told)

    def _put(self, words: str, wide: float, told: bool) -> None:
        """Words, and the keys behind them, which with the gap before them are so wide."""
        corner = imgui.get_cursor_screen_pos()
        total = wide + imgui.calc_text_size(words).x
        right = corner.x + imgui.get_content_region_avail().x - 4.0
        x = right - total
        y = corner.y + imgui.get_style().frame_padding.y
        color = imgui.get_color_u32(imgui.Col_.text_disabled)
        imgui.get_window_draw_list().add_text(imgui.ImVec2(round(x), round(y)), color, words)
        if wide:
            self._caps.draw(right - self._caps.width(self._hint.keys, told), y, self._hint.keys, told)
        imgui.set_cursor_screen_pos(imgui.ImVec2(x, corner.y))
        imgui.dummy(imgui.ImVec2(max(total, 1.0), imgui.get_frame_height()))
        mark("hint", "" if told and words == self._hint.words else self._hint.text)

    def _fitting(self, room: float) -> str:
        """As many words as find room, with an ellipsis; none where they would say nothing."""
        words = self._hint.words
        if imgui.calc_text_size(words).x <= room:
            return words
        if room < READABLE_EMS * self._size:
            return ""
        while imgui.calc_text_size(words).x > room and " " in words:
            words = words.removesuffix(" …").rpartition(" ")[0] + " …"
        return words
