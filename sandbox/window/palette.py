"""The command palette: everything that can be done, found by typing a word of it, chosen with arrows and Enter."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.render.overlays.registry import OVERLAYS
from sandbox.window.actions.registry import ACTIONS
from sandbox.window.panels.inspector import finder
from sandbox.window.panels.panel import Panel
from sandbox.window.tools.tool_box import ToolBox
from sandbox.window.widgets import mark, text, wrapped
from sandbox.window.workspace import Workspace

WIDTH, TOP, ROWS = 560.0, 48.0, 12
MOST = 200
"""Offers that are listed at most: who has as many types another letter."""
_FLAGS = (
    imgui.WindowFlags_.no_title_bar | imgui.WindowFlags_.no_resize | imgui.WindowFlags_.no_move
    | imgui.WindowFlags_.no_docking | imgui.WindowFlags_.no_saved_settings | imgui.WindowFlags_.no_nav
)  # fmt: skip


@dataclass(frozen=True)
class Offer:
    """One thing that can be done: its `title`, what kind of thing it is, its `keys`, one line of `help`."""

    title: str
    kind: str
    keys: str
    help: str
    run: Callable[[], object]


class Palette:
    """Opened by `Workspace.palette_shown`; it takes the keyboard until something is chosen or Esc."""

    def __init__(self, workspace: Workspace, tool_box: ToolBox, panels: Mapping[str, Panel]) -> None:
        self._workspace = workspace
        self._tool_box = tool_box
        self._panels = panels
        self._words = ""
        self._row = 0

    def draw(self) -> None:
        """The line to type in, and what fits it."""
        workspace = self._workspace
        if not workspace.palette_shown:
            self._words, self._row = "", 0
            return
        left, top, width, height = workspace.viewport.rect
        wide = min(WIDTH * workspace.text_scale, width - 16.0)
        imgui.set_next_window_pos(imgui.ImVec2(left + (width - wide) / 2, top + min(TOP, height / 8)))
        imgui.set_next_window_size(imgui.ImVec2(wide, 0.0))
        imgui.begin("##palette", None, _FLAGS)
        self._draw_words()
        self._draw_offers(matching(list(self.offers()), self._words), height)
        imgui.end()
        mark("palette")
        if imgui.is_key_pressed(imgui.Key.escape):
            workspace.palette_shown = False

    def _draw_words(self) -> None:
        if not imgui.is_any_item_active():  # at first
            imgui.set_keyboard_focus_here()
        imgui.set_next_item_width(-1.0)
        words = text("palette.words", "", self._words, f"{icons.ICON_FA_MAGNIFYING_GLASS}  what is to be done")
        if imgui.is_item_deactivated():  # by Enter: what is typed in the next picture is for it as well
            imgui.set_keyboard_focus_here(-1)
        if words != self._words:
            self._words, self._row = words, 0

    def _draw_offers(self, found: list[Offer], height: float) -> None:
        if not found:
            imgui.text_disabled("Nothing of that name: try another word, or Esc.")
            return
        down, up = imgui.is_key_pressed(imgui.Key.down_arrow), imgui.is_key_pressed(imgui.Key.up_arrow)
        self._row = (self._row + down - up) % len(found)
        line = imgui.get_text_line_height_with_spacing()
        rows = min(len(found), ROWS, max(int(height / line) - 6, 2))
        imgui.begin_child("offers", imgui.ImVec2(0.0, rows * line + 4.0))
        for number, offer in enumerate(found):
            if self._draw_offer(offer, number == self._row, moved=down or up):
                self._choose(offer)
        imgui.end_child()
        if imgui.is_key_pressed(imgui.Key.enter) or imgui.is_key_pressed(imgui.Key.keypad_enter):
            self._choose(found[self._row])
        else:
            wrapped(found[self._row].help)

    def _draw_offer(self, offer: Offer, on: bool, moved: bool) -> bool:
        clicked, _ = imgui.selectable(f"{offer.title}##{offer.kind}", on)
        mark(f"palette.{offer.kind.lower()}.{offer.title.lower()}", offer.help)
        if on and moved:
            imgui.set_scroll_here_y(0.5)
        told = f"{offer.kind}   {offer.keys}" if offer.keys else offer.kind
        room = imgui.get_content_region_avail().x - imgui.calc_text_size(told).x - 4.0
        if room > imgui.calc_text_size(offer.title).x + 16.0:
            imgui.same_line(room)
            imgui.text_disabled(told)
        return bool(clicked)

    def _choose(self, offer: Offer) -> None:
        self._workspace.palette_shown = False
        offer.run()

    def offers(self) -> Iterator[Offer]:
        """All that can be done now: actions, tools, panels, overlays, and what there is to select."""
        workspace = self._workspace
        for action in ACTIONS:
            if not action.held and action.name != "palette" and action.enabled(workspace):
                keys = action.keys[0] if action.keys else ""
                yield Offer(action.title, action.menu, keys, action.help, partial(action.run, workspace))
        for tool in self._tool_box.tools.values():
            yield Offer(tool.title, "Tool", tool.key, tool.told(), partial(self._tool_box.choose, tool.name))
        for panel in self._panels.values():
            yield Offer(panel.title, "Panel", panel.key, panel.help, partial(workspace.toggle_panel, panel.name))
        for overlay in OVERLAYS.values():
            yield Offer(overlay.title, "Overlay", "", overlay.help, partial(workspace.toggle_overlay, overlay.name))
        for one in finder.everything(workspace.session.world) if self._words else ():
            yield Offer(one.name, one.sort.capitalize(), "", "Select it.", partial(finder.select, workspace, one))


def matching(offers: list[Offer], words: str) -> list[Offer]:
    """Those that have every word in title, kind or help, `MOST` at most; first those whose title begins so, then those
    which need no help for it."""
    wanted = words.lower().split()

    def holds(text: str) -> bool:
        return all(word in text.lower() for word in wanted)

    def rank(one: Offer) -> tuple[bool, bool]:
        return not one.title.lower().startswith(words.lower()), not holds(f"{one.kind} {one.title}")

    return sorted((one for one in offers if holds(f"{one.kind} {one.title} {one.help}")), key=rank)[:MOST]
