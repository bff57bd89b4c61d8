"""The tools at the left edge: one button each, or where that would take too much of the window, one for each group."""

from __future__ import annotations

import math

from imgui_bundle import imgui

from sandbox.window.tools.registry import GROUPS
from sandbox.window.tools.tool import Tool
from sandbox.window.tools.tool_box import ToolBox
from sandbox.window.widgets import button, mark

GAP, PAD = 2.0, 6.0
BUTTON_WIDTH = 2.0
"""In heights of the text."""
MOST_COLUMNS = 2
"""Where more were needed, each group is a button that opens it."""
Kinds = tuple[type[Tool], ...]


def tool_bar_width(height: float) -> float:
    """Pixels that it takes across where it has `height` pixels down."""
    columns = _columns(height) or _group_columns(height)
    return columns * (BUTTON_WIDTH * imgui.get_font_size() + GAP) - GAP + 2 * PAD


def draw_tool_bar(tool_box: ToolBox, height: float) -> None:
    """A button for each tool, or for each group; the one in hand is lit."""
    columns = _columns(height)
    imgui.push_style_var(imgui.StyleVar_.item_spacing, imgui.ImVec2(GAP, GAP))
    for number, (title, kinds) in enumerate(GROUPS):
        if columns:
            if number and columns == 1:
                imgui.separator()
            _draw_tools(tool_box, kinds, columns)
            continue
        if number % _group_columns(height):
            imgui.same_line()
        if len(kinds) == 1:
            _draw_tools(tool_box, kinds, 1)
        else:
            _draw_group(tool_box, title, kinds)
    imgui.pop_style_var()


def _draw_tools(tool_box: ToolBox, kinds: Kinds, columns: int) -> None:
    for place, kind in enumerate(kinds):
        if place % columns:
            imgui.same_line()
        if _button(f"tool.{kind.name}", kind, _told(kind), tool_box):
            tool_box.choose(kind.name)


def _draw_group(tool_box: ToolBox, title: str, kinds: Kinds) -> None:
    """The tool of a group that was in hand last; a click shows them all beside it, with their names."""
    latest = next(kind for kind in kinds if kind.name == tool_box.latest[title])
    tip = f"{title}: {', '.join(kind.title for kind in kinds)}"
    clicked = _button(f"tools.{title.lower()}", latest, tip, tool_box)
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


def _button(name: str, kind: type[Tool], tip: str, tool_box: ToolBox) -> bool:
    wide = BUTTON_WIDTH * imgui.get_font_size()
    return button(name, kind.icon, tip, on=tool_box.tool.name == kind.name, width=wide)


def _told(kind: type[Tool]) -> str:
    keys = f"   [{kind.key}]" if kind.key else ""
    return f"{kind.title}{keys}\n{kind.told()}"


def _columns(height: float) -> int:
    """The fewest columns in which all tools fit; 0 if these were too many."""
    for columns in range(1, MOST_COLUMNS + 1):
        rows = sum(math.ceil(len(kinds) / columns) for _, kinds in GROUPS)
        separators = (len(GROUPS) - 1) * (GAP + 1.0) if columns == 1 else 0.0
        if rows * _row() + separators + 2 * PAD <= height:
            return columns
    return 0


def _group_columns(height: float) -> int:
    """The fewest columns in which a button for each group fits."""
    return math.ceil(len(GROUPS) / max(int((height - 2 * PAD + GAP) / _row()), 1))


def _row() -> float:
    return float(imgui.get_frame_height()) + GAP
