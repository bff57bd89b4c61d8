"""The help over the scene: every key, tool and panel, read from their tables."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from imgui_bundle import imgui

from sandbox.window.actions.registry import ACTIONS, MENUS
from sandbox.window.panels.panel import Panel
from sandbox.window.tools.tool import Tool
from sandbox.window.widgets import mark, wrapped
from sandbox.window.workspace import Workspace

MOUSE = (
    ("Left button", "the tool in hand; on empty space it pans"),
    ("Middle or right button", "pan"),
    ("Wheel", "zoom about the pointer"),
)
WIDEST, HIGHEST, MARGIN = 980.0, 760.0, 24.0
WIDE_EMS, HIGH_EMS = 30.0, 20.0
"""What it needs to be read, in heights of the text."""
KEYS_EMS = 7.0
"""Widest column of keys, in heights of the text."""
Rows: TypeAlias = Sequence[tuple[str, str]]


def draw_help(workspace: Workspace, tools: dict[str, Tool], panels: dict[str, Panel]) -> None:
    """A window in the middle; Esc or F1 closes it."""
    left, top, width, height = _room(workspace)
    wide, high = min(WIDEST, width - 2 * MARGIN), min(HIGHEST, height - 2 * MARGIN)
    middle = imgui.ImVec2(left + width / 2, top + height / 2)
    imgui.set_next_window_pos(middle, imgui.Cond_.always, imgui.ImVec2(0.5, 0.5))
    imgui.set_next_window_size(imgui.ImVec2(wide, high))
    flags = imgui.WindowFlags_.no_docking | imgui.WindowFlags_.no_saved_settings | imgui.WindowFlags_.no_collapse
    shown, still_open = imgui.begin("Keys and mouse", True, flags | imgui.WindowFlags_.no_move)
    mark("help")
    blocks = _blocks(tools, panels)
    columns = 2 if wide > 620.0 else 1
    if shown and imgui.begin_table("help", columns, imgui.TableFlags_.sizing_stretch_same):
        imgui.table_next_row()
        for column in range(columns):
            imgui.table_set_column_index(column)
            for title, rows in blocks[column::columns]:
                _draw_block(title, rows)
        imgui.end_table()
    imgui.end()
    if not still_open:
        workspace.help_shown = False


def _room(workspace: Workspace) -> tuple[float, float, float, float]:
    """Left, top, width and height (pixels) of the scene, or of the whole window where the scene is small."""
    _, _, width, height = workspace.viewport.rect
    if min(width / WIDE_EMS, height / HIGH_EMS) >= imgui.get_font_size():
        return workspace.viewport.rect
    size = imgui.get_io().display_size
    return 0.0, 0.0, size.x, size.y


def _blocks(tools: dict[str, Tool], panels: dict[str, Panel]) -> list[tuple[str, Rows]]:
    """(title, (keys, help) of each row) of every block, so that two columns of them are about as long."""
    menus: dict[str, Rows] = {
        menu: [(", ".join(one.keys), one.help) for one in ACTIONS if one.menu == menu and one.keys] for menu in MENUS
    }
    return [
        ("Time", menus["Time"]),
        ("Tools", [(one.key, f"{one.title}. {one.told()}") for one in tools.values() if one.key]),
        ("Mouse", MOUSE),
        ("Panels", [(one.key, f"{one.title}: {one.help}") for one in panels.values() if one.key]),
        ("Edit", menus["Edit"]),
        ("View", menus["View"]),
        ("File", [*menus["File"], *menus["Help"]]),
    ]


def _draw_block(title: str, rows: Rows) -> None:
    imgui.separator_text(title)
    if imgui.begin_table(f"help {title}", 2):
        longest = max(imgui.calc_text_size(keys).x for keys, _ in rows)
        wide = min(longest + 0.5 * imgui.get_font_size(), imgui.get_font_size() * KEYS_EMS)
        imgui.table_setup_column("keys", imgui.TableColumnFlags_.width_fixed, wide)
        imgui.table_setup_column("help", imgui.TableColumnFlags_.width_stretch)
        for keys, help_line in rows:
            imgui.table_next_row()
            imgui.table_next_column()
            imgui.text_wrapped(keys)
            imgui.table_next_column()
            wrapped(help_line)
        imgui.end_table()
