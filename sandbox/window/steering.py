"""Menus and panels by the keyboard: ImGui's own navigation, but only while it is asked for.

At other times arrows, Enter and Tab are the scene's. Esc comes back, and so does a click, or a choice from a menu.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import pygame
from imgui_bundle import imgui

from sandbox.window.gui import ANY_POPUP

MENUS, PANELS = "menus", "panels"
KEYS = {
    pygame.K_LEFT, pygame.K_RIGHT, pygame.K_UP, pygame.K_DOWN, pygame.K_RETURN, pygame.K_KP_ENTER, pygame.K_TAB,
    pygame.K_SPACE, pygame.K_HOME, pygame.K_END, pygame.K_PAGEUP, pygame.K_PAGEDOWN,
}  # fmt: skip
"""They go to menus and panels meanwhile."""
SIDEWAYS = {pygame.K_LEFT: -1, pygame.K_RIGHT: 1}
PASSING = 2
"""Pictures in which ImGui closes a menu that one leaves sideways, before the next one opens."""


@dataclass
class Steering:
    """Where the keyboard is: `what` is MENUS, PANELS, or nothing where it is the scene's."""

    what: str = ""
    panel: str = ""
    _menu: int = 0
    _coming: int | None = None
    """Pictures until the next menu or panel is gone to."""
    _landing: int | None = None
    """Pictures until the keyboard is in the panel, `_window` in ImGui's words."""
    _window: str = ""

    def begin(self, what: str) -> None:
        """Go through the menus, or through the next of the open panels."""
        self.what, self._menu, self._coming = what, 0, 0
        self.set_keys()

    def takes(self, event: pygame.event.Event) -> bool:
        """Whether menus and panels have a key for themselves; Esc and the mouse end it."""
        if not self.what:
            return False
        if event.type == pygame.MOUSEBUTTONDOWN:
            self.what = ""
        if event.type != pygame.KEYDOWN:
            return False
        if event.key == pygame.K_ESCAPE:
            self._leave()
            return True
        if self.what == MENUS and event.key in SIDEWAYS:
            self._menu, self._coming = self._menu + SIDEWAYS[event.key], PASSING
        return event.key in KEYS

    def set_keys(self) -> None:
        """Let keys move among the widgets of the next picture, or not."""
        flags, on = imgui.get_io().config_flags, imgui.ConfigFlags_.nav_enable_keyboard
        imgui.get_io().config_flags = flags | on if self.what else flags & ~on
        if self._coming is not None:
            imgui.set_nav_cursor_visible(True)
        self._land()

    def menu_to_open(self, menus: Sequence[str]) -> str | None:
        """The one of all menus that is to open in this picture, if any."""
        return menus[self._menu % len(menus)] if self.what == MENUS and self._coming == 0 else None

    def end_picture(self, panels: dict[str, str], front: str) -> None:
        """After the widgets of a picture. `panels` are the open ones, with what ImGui calls their windows; `front` is
        the first one that is not hidden, "" if all are, as in a window without room for any."""
        if self.what == MENUS and self._coming is None and not imgui.is_popup_open("", ANY_POPUP):
            self.what = ""  # something was chosen
        if self.what == PANELS and self._coming == 0:
            self._next_panel(panels, front)
        if not self.what:
            self.panel = ""
        self._coming = self._coming - 1 if self._coming else None

    def _leave(self) -> None:
        """Close what is open in a panel, or come back."""
        opened = imgui.is_popup_open("", ANY_POPUP)
        if self.what == MENUS or not opened:
            self.what = ""
        if opened:
            imgui.internal.close_popup_to_level(0, True)

    def _next_panel(self, panels: dict[str, str], front: str) -> None:
        names = list(panels)
        if not names:
            self.what = ""
            return
        before = names.index(self.panel) if self.panel in names else names.index(front or names[0]) - 1
        self.panel = names[(before + 1) % len(names)]
        imgui.set_window_focus(panels[self.panel])
        self._landing, self._window = PASSING, panels[self.panel]

    def _land(self) -> None:
        """Go to the first widget of the panel; asked for before it is drawn, once it is in front."""
        self._landing = self._landing - 1 if self._landing else None
        if self._landing != 0:
            return
        window, focused = imgui.internal.find_window_by_name(self._window), imgui.get_current_context().nav_window
        if window is not None and focused is not None and focused.id_ == window.id_:  # nothing else has come in front
            imgui.internal.nav_init_window(window, True)
            imgui.set_nav_cursor_visible(True)
