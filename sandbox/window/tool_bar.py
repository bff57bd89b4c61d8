"""The tools at the left edge, in groups."""

from __future__ import annotations

from imgui_bundle import imgui

from sandbox.window.tools.registry import GROUPS
from sandbox.window.tools.tool_box import ToolBox
from sandbox.window.widgets import button

TOOL_BAR_WIDTH = 46.0


def draw_tool_bar(tool_box: ToolBox) -> None:
    """A button for each tool; the one in hand is lit."""
    imgui.push_style_var(imgui.StyleVar_.item_spacing, imgui.ImVec2(4.0, 4.0))
    for number, (_, kinds) in enumerate(GROUPS):
        if number:
            imgui.separator()
        for kind in kinds:
            keys = f"   [{kind.key}]" if kind.key else ""
            tip = f"{kind.title}{keys}\n{kind.help}"
            if button(f"tool.{kind.name}", kind.icon, tip, on=tool_box.tool.name == kind.name, width=-1.0):
                tool_box.choose(kind.name)
    imgui.pop_style_var()
