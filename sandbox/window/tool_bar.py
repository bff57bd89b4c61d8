"""The tools at the left edge, in groups."""

from __future__ import annotations

from imgui_bundle import imgui

from sandbox.window.tools.registry import GROUPS
from sandbox.window.tools.tool import Tool
from sandbox.window.widgets import button
from sandbox.window.workspace import Workspace

TOOL_BAR_WIDTH = 46.0


def draw_tool_bar(workspace: Workspace, tools: dict[str, Tool]) -> None:
    """A button for each tool; the one in hand is lit."""
    imgui.push_style_var(imgui.StyleVar_.item_spacing, imgui.ImVec2(4.0, 4.0))
    for number, (_, kinds) in enumerate(GROUPS):
        if number:
            imgui.separator()
        for kind in kinds:
            keys = f"   [{kind.key}]" if kind.key else ""
            tip = f"{kind.title}{keys}\n{kind.help}"
            if button(f"tool.{kind.name}", kind.icon, tip, on=workspace.tool.name == kind.name, width=-1.0):
                workspace.choose_tool(tools[kind.name])
    imgui.pop_style_var()
