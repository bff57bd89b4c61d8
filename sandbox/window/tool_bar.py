"""The tools at the left edge: a button each, with words where there is room for them; else one for each group."""

from __future__ import annotations

import math

from imgui_bundle import imgui

from sandbox.window.tools.registry import GROUPS
from sandbox.window.tools.tool import Tool
from sandbox.window.tools.tool_box import ToolBox
from sandbox.window.widgets import button, lit_ink, mark

GAP, PAD = 2.0, 6.0
BUTTON_WIDTH, KEY_WIDTH = 2.0, 1.4
"""In heights of the text: a button without words, and what the key takes at the end of one with words."""
MOST_COLUMNS = 2
"""Where more were needed, each group is a button that opens it."""
MOST_SHARE = 0.13
"""Of the width of the window, what the tools may take with words."""
Kinds = tuple[type[Tool], ...]


class ToolBar:
    """Tools in `height` pixels down at the edge of a window that is `across` pixels wide."""

    def __init__(self, height: float, across: float) -> None:
        self._columns = _columns(height)
        self._group_columns = math.ceil(len(GROUPS) / max(int((height - 2 * PAD + GAP) / _row()), 1))
        words = _words_width()
        self._words = self._columns == 1 and words + 2 * PAD <= MOST_SHARE * across
        self._titled = self._words and _height(1) + len(GROUPS) * _title() <= height
        wide = BUTTON_WIDTH * imgui.get_font_size()
        self._button_width = words if self._words else wide
        columns = self._columns or self._group_columns
        self.width = columns * (self._button_width + GAP) - GAP + 2 * PAD
        """Pixels that they take across."""

    def draw(self, tool_box: ToolBox) -> None:
        """A button for each tool, or for each group; the one in hand is lit."""
        imgui.push_style_var(imgui.StyleVar_.item_spacing, imgui.ImVec2(GAP, GAP))
        for number, (title, kinds) in enumerate(GROUPS):
            if self._columns:
                if number and self._columns == 1:
                    imgui.separator()
                if self._titled:
                    imgui.text_disabled(title)
                self._draw_tools(tool_box, kinds, self._columns)
                continue
            if number % self._group_columns:
                imgui.same_line()
            if len(kinds) == 1:
                self._draw_tools(tool_box, kinds, 1)
            else:
                self._draw_group(tool_box, title, kinds)
        imgui.pop_style_var()

    def _draw_tools(self, tool_box: ToolBox, kinds: Kinds, columns: int) -> None:
        for place, kind in enumerate(kinds):
            if place % columns:
                imgui.same_line()
            if self._button(f"tool.{kind.name}", kind, _told(kind), tool_box):
                tool_box.choose(kind.name)

    def _draw_group(self, tool_box: ToolBox, title: str, kinds: Kinds) -> None:
        """The tool of a group that was in hand last; a click shows them all beside it, with their names."""
        latest = next(kind for kind in kinds if kind.name == tool_box.latest[title])
        tip = f"{title}: {', '.join(kind.title for kind in kinds)}"
        clicked = self._button(f"tools.{title.lower()}", latest, tip, tool_box)
        low, high = imgui.get_item_rect_min(), imgui.get_item_rect_max()
        side = 0.3 * imgui.get_font_size()
        corners = imgui.ImVec2(high.x - 3.0, high.y - 3.0 - side), imgui.ImVec2(high.x - 3.0 - side, high.y - 3.0)
        color = imgui.get_color_u32(imgui.Col_.text_disabled)
        imgui.get_window_draw_list().add_triangle_filled(*corners, imgui.ImVec2(high.x - 3.0, high.y - 3.0), color)
        if clicked:
            imgui.open_popup(title)
        imgui.set_next_window_pos(imgui.ImVec2(high.x + PAD, low.y), imgui.Cond_.appearing)
        if imgui.begin_popup(title):
            for kind in kinds:
                chosen, _ = imgui.menu_item(f"{kind.icon}  {kind.title}  ", kind.key, tool_box.tool.name == kind.name)
                mark(f"tool.{kind.name}", kind.told())
                if chosen:
                    tool_box.choose(kind.name)
            imgui.end_popup()

    def _button(self, name: str, kind: type[Tool], tip: str, tool_box: ToolBox) -> bool:
        lit = tool_box.tool.name == kind.name
        label = f"{kind.icon}  {kind.title}" if self._words else kind.icon
        imgui.push_style_var(imgui.StyleVar_.button_text_align, imgui.ImVec2(0.0 if self._words else 0.5, 0.5))
        clicked = button(name, label, tip, on=lit, width=self._button_width)
        imgui.pop_style_var()
        if self._words and kind.key:
            high, padding = imgui.get_item_rect_max(), imgui.get_style().frame_padding
            x = high.x - padding.x - imgui.calc_text_size(kind.key).x
            at = imgui.ImVec2(round(x), imgui.get_item_rect_min().y + padding.y)
            ink = lit_ink() if lit else imgui.get_style_color_vec4(imgui.Col_.text_disabled)
            imgui.get_window_draw_list().add_text(at, imgui.get_color_u32(ink), kind.key)
        return clicked


def _told(kind: type[Tool]) -> str:
    keys = f"   [{kind.key}]" if kind.key else ""
    return f"{kind.title}{keys}\n{kind.told()}"


def _columns(height: float) -> int:
    """The fewest columns in which all tools fit; 0 if these were too many."""
    return next((columns for columns in range(1, MOST_COLUMNS + 1) if _height(columns) <= height), 0)


def _height(columns: int) -> float:
    """Pixels that all tools take down in so many columns."""
    rows = sum(math.ceil(len(kinds) / columns) for _, kinds in GROUPS)
    separators = (len(GROUPS) - 1) * (GAP + 1.0) if columns == 1 else 0.0
    return rows * _row() + separators + 2 * PAD


def _words_width() -> float:
    """Pixels of a button that has room for the longest words and a key."""
    longest = max(imgui.calc_text_size(f"{kind.icon}  {kind.title}").x for _, kinds in GROUPS for kind in kinds)
    return float(longest + KEY_WIDTH * imgui.get_font_size() + 2 * imgui.get_style().frame_padding.x)


def _row() -> float:
    return float(imgui.get_frame_height()) + GAP


def _title() -> float:
    return float(imgui.get_text_line_height()) + GAP
