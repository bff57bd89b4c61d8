"""The tools at the left edge, in as many columns as the height asks for."""

from __future__ import annotations

import math

from imgui_bundle import imgui

from sandbox.window.tools.registry import GROUPS
from sandbox.window.tools.tool_box import ToolBox
from sandbox.window.widgets import button

GAP, PAD = 4.0, 6.0
BUTTON_WIDTH = 2.0
"""In heights of the text."""


def tool_bar_width(height: float) -> float:
    """Pixels that it takes across where it has `height` pixels down."""
    return _columns(height) * (BUTTON_WIDTH * imgui.get_font_size() + GAP) - GAP + 2 * PAD


def draw_tool_bar(tool_box: ToolBox, height: float) -> None:
    """A button for each tool; the one in hand is lit."""
    columns = _columns(height)
    imgui.push_style_var(imgui.StyleVar_.item_spacing, imgui.ImVec2(GAP, GAP))
    for number, (_, kinds) in enumerate(GROUPS):
        if number and columns == 1:
            imgui.separator()
        for place, kind in enumerate(kinds):
            if place % columns:
                imgui.same_line()
            keys = f"   [{kind.key}]" if kind.key else ""
            tip = f"{kind.title}{keys}\n{kind.help}"
            wide = BUTTON_WIDTH * imgui.get_font_size()
            if button(f"tool.{kind.name}", kind.icon, tip, on=tool_box.tool.name == kind.name, width=wide):
                tool_box.choose(kind.name)
    imgui.pop_style_var()


def _columns(height: float) -> int:
    """The fewest columns with which all groups fit, or as many as the largest group has tools."""
    row = imgui.get_frame_height() + GAP
    most = max(len(kinds) for _, kinds in GROUPS)
    for columns in range(1, most):
        rows = sum(math.ceil(len(kinds) / columns) for _, kinds in GROUPS)
        separators = (len(GROUPS) - 1) * (GAP + 1.0) if columns == 1 else 0.0
        if rows * row + separators + 2 * PAD <= height:
            return columns
    return most
