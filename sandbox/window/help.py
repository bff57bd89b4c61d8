"""The help over the scene: every key, tool and panel, read from their tables."""

from __future__ import annotations

from imgui_bundle import imgui

from sandbox.window.actions.registry import ACTIONS, MENUS
from sandbox.window.panels.panel import Panel
from sandbox.window.tools.tool import Tool
from sandbox.window.widgets import mark
from sandbox.window.workspace import Workspace

MOUSE = (
    ("Left button", "the tool in hand; on empty space it pans"),
    ("Middle or right button", "pan"),
    ("Wheel", "zoom about the pointer"),
)
WIDEST, MARGIN = 900.0, 24.0


def draw_help(workspace: Workspace, tools: dict[str, Tool], panels: dict[str, Panel]) -> None:
    """A window in the middle; Esc or F1 closes it."""
    left, top, width, height = workspace.viewport.rect
    wide = min(WIDEST, width - 2 * MARGIN)
    imgui.set_next_window_pos(
        imgui.ImVec2(left + width / 2, top + height / 2), imgui.Cond_.always, imgui.ImVec2(0.5, 0.5)
    )
    imgui.set_next_window_size_constraints(imgui.ImVec2(wide, 80.0), imgui.ImVec2(wide, height - 2 * MARGIN))
    flags = imgui.WindowFlags_.no_docking | imgui.WindowFlags_.no_saved_settings | imgui.WindowFlags_.no_collapse
    shown, still_open = imgui.begin(
        "Keys and mouse", True, flags | imgui.WindowFlags_.no_move | imgui.WindowFlags_.always_auto_resize
    )
    mark("help")
    if shown and imgui.begin_table("help", 2 if wide > 560.0 else 1):
        for menu in MENUS:
            rows = [(", ".join(one.keys), one.help) for one in ACTIONS if one.menu == menu and one.keys]
            _draw_block(menu, rows)
        _draw_block("Mouse", MOUSE)
        _draw_block("Tools", [(one.key, f"{one.title}: {one.help}") for one in tools.values() if one.key])
        _draw_block("Panels", [(one.key, f"{one.title}: {one.help}") for one in panels.values() if one.key])
        imgui.end_table()
    imgui.end()
    if not still_open:
        workspace.help_shown = False


def _draw_block(title: str, rows: object) -> None:
    imgui.table_next_column()
    imgui.separator_text(title)
    for keys, help_line in rows:  # type: ignore[attr-defined]
        imgui.text_unformatted(keys)
        imgui.same_line(imgui.get_font_size() * 7.5)
        imgui.push_text_wrap_pos(0.0)
        imgui.text_disabled(help_line)
        imgui.pop_text_wrap_pos()
