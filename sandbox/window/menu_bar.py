"""The menus at the top, made of the table of actions, with the scene's title and figures beside them."""

from __future__ import annotations

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.render.number_text import counted
from sandbox.window.actions.registry import ACTIONS, MENUS
from sandbox.window.at_rest import asleep
from sandbox.window.fitting import fitting
from sandbox.window.panels.panel import Panel
from sandbox.window.widgets import mark
from sandbox.window.workspace import Workspace

READABLE_EMS = 10.0
"""Width, in heights of the text, from which a title that is cut says something."""


def draw_menu_bar(workspace: Workspace, panels: dict[str, Panel]) -> float:
    """Draw it; gives its height in pixels."""
    if not imgui.begin_main_menu_bar():
        return 0.0
    if (wanted := workspace.steering.menu_to_open(MENUS)) is not None:
        imgui.open_popup(wanted)
    for menu in MENUS:
        opened = imgui.begin_menu(menu)
        mark(f"menu.{menu.lower()}")
        if opened:
            _draw_actions(workspace, menu)
            if menu == "View":
                _draw_panel_items(workspace, panels)
            imgui.end_menu()
    _draw_title(workspace)
    height = imgui.get_window_height()
    imgui.end_main_menu_bar()
    return float(height)


def _draw_actions(workspace: Workspace, menu: str) -> None:
    for action in ACTIONS:
        if action.menu == menu and not action.held:
            keys = action.keys[0] if action.keys else ""
            checked = action.checked is not None and action.checked(workspace)
            clicked, _ = imgui.menu_item(f"{action.title}  ", keys, checked, action.enabled(workspace))
            mark(f"menu.{action.name}", action.help)
            if clicked:
                action.run(workspace)


def _draw_panel_items(workspace: Workspace, panels: dict[str, Panel]) -> None:
    imgui.separator()
    for panel in panels.values():
        clicked, _ = imgui.menu_item(f"{panel.icon}  {panel.title}  ", panel.key, panel.name in workspace.panels)
        mark(f"menu.panel.{panel.name}", panel.help)
        if clicked:
            workspace.toggle_panel(panel.name)


def _draw_title(workspace: Workspace) -> None:
    """The title in the middle, with what to watch for as its tooltip; figures at the right. What has no room is left
    out, and a long title cut."""
    world, title = workspace.session.world, workspace.session.title
    width, used = imgui.get_window_width(), imgui.get_cursor_pos_x()
    frozen = int(world.state.counters[0].frozen_count)
    figures = [
        counted(len(world.names), "body", "bodies"), counted(len(world.contacts), "contact"),
        f"{1000.0 * workspace.session.step_cost:5.2f} ms/step", f"{workspace.fps:3.0f} fps",
    ]  # fmt: skip
    resting = asleep(world)
    rest = [f"{icons.ICON_FA_MOON} {resting} asleep"] if resting else []
    text = "    ".join([*([f"{frozen} frozen"] if frozen else []), *rest, *figures])
    right = width - imgui.calc_text_size(text).x - 14.0
    if right < used + 20.0:
        right = width
    else:
        imgui.set_cursor_pos_x(right)
        imgui.text_disabled(text)
        mark("figures", "Who sleeps (and is drawn darker), bodies, contacts, time of a step, pictures a second")
    room, about = right - used - 32.0, workspace.session.scene.about
    shown = fitting(title, room) if room >= READABLE_EMS * imgui.get_font_size() else title
    size = imgui.calc_text_size(shown).x
    if size <= room:
        imgui.set_cursor_pos_x(min(max((width - size) / 2, used + 16.0), right - 16.0 - size))
        imgui.text_unformatted(shown)
        mark("title", about if shown == title else f"{title}\n\n{about}".rstrip())
