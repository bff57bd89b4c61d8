"""The screen that lists the shipped scenes: click one, or choose with the arrow keys and press Enter."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pygame
from imgui_bundle import imgui

from sandbox.window.card_grid import Row, card_rows, move
from sandbox.window.gui import Gui
from sandbox.window.hud import FAINT, PANEL, TEXT, WARM
from sandbox.window.overlay import Overlay, shorten, split_line
from sandbox.window.scene_index import Entry
from sandbox.window.screen import Canvas, Screen

CARD_HEIGHT, CARD_GAP, HEADING_HEIGHT, HEAD_HEIGHT = 86.0, 10.0, 48.0, 104.0
NARROWEST, WIDEST = 340.0, 1120.0
"""Least width of a card, and the most that all cards of a row take."""
PAD, INDENT = 8.0, 16.0

_MOVES = {
    pygame.K_LEFT: (-1, 0), pygame.K_RIGHT: (1, 0), pygame.K_UP: (0, -1), pygame.K_DOWN: (0, 1),
    pygame.K_PAGEUP: (0, -4), pygame.K_PAGEDOWN: (0, 4),
    pygame.K_HOME: (-100_000, 0), pygame.K_END: (100_000, 0),
}  # fmt: skip
"""Keys -> (right, down)."""
_WINDOW_FLAGS = int(
    imgui.WindowFlags_.no_title_bar | imgui.WindowFlags_.no_resize | imgui.WindowFlags_.no_move
    | imgui.WindowFlags_.no_collapse | imgui.WindowFlags_.no_background | imgui.WindowFlags_.no_nav
)  # fmt: skip


class SceneList:
    """Cards of scenes under headings of themes. `open_scene` gives the screen for the chosen file."""

    counts = True

    def __init__(self, entries: list[Entry], open_scene: Callable[[Path], Screen]) -> None:
        self._entries = entries
        self._open = open_scene
        self.message = ""
        self._selected = 0
        self._chosen: int | None = None
        self._leaving = False
        self._scroll_to_selected = False
        self._rows: list[Row] = []

    def handle(self, event: pygame.event.Event, taken: tuple[bool, bool] = (False, False)) -> None:
        """Arrow keys, Enter and Esc."""
        if event.type != pygame.KEYDOWN:
            return
        if event.key == pygame.K_ESCAPE:
            self._leaving = True
        elif event.key in (pygame.K_RETURN, pygame.K_KP_ENTER) and self._entries:
            self._chosen = self._selected
        elif event.key in _MOVES and self._rows:
            self._selected = move(self._rows, self._selected, *_MOVES[event.key])
            self._scroll_to_selected = True

    def update(self, elapsed: float) -> Screen | None:
        """Go where the user wants to."""
        if self._leaving:
            return None
        if self._chosen is None:
            return self
        chosen, self._chosen, self.message = self._chosen, None, ""
        return self._open(self._entries[chosen].path)

    def say(self, message: str) -> None:
        """Show a message above the cards until the next choice."""
        self.message = message.splitlines()[0]

    def draw(self, canvas: Canvas) -> None:
        """Heading, message, cards."""
        canvas.clear()
        width, height = canvas.display.size
        wide = min(WIDEST, width - 48.0)
        left = (width - wide) / 2
        overlay = Overlay(canvas.gui)
        overlay.text(left, 28.0, "sandbox", TEXT, size=32.0, bold=True)
        self._subtitle(overlay, left, wide)
        self._cards(canvas.gui, left, wide, height)

    def _subtitle(self, overlay: Overlay, left: float, wide: float) -> None:
        hint = "arrows and Enter, or click  ·  Esc leaves"
        text = self.message or f"{len(self._entries)} scenes"
        room = wide - overlay.width(hint) - 30.0
        overlay.text(left, 68.0, shorten(overlay, text, room), WARM if self.message else FAINT)
        overlay.text(left + wide - overlay.width(hint), 68.0, hint, FAINT)

    def _cards(self, gui: Gui, left: float, wide: float, height: float) -> None:
        imgui.set_next_window_pos(imgui.ImVec2(left - PAD, HEAD_HEIGHT))
        imgui.set_next_window_size(imgui.ImVec2(wide + 3.5 * PAD, height - HEAD_HEIGHT))
        imgui.begin("scenes", None, _WINDOW_FLAGS)
        columns = max(int((wide + CARD_GAP) / (NARROWEST + CARD_GAP)), 1)
        self._rows = card_rows([entry.theme for entry in self._entries], columns)
        card = (wide - CARD_GAP * (columns - 1)) / columns
        self._grid(Overlay(gui, imgui.get_window_draw_list()), (card, CARD_HEIGHT))
        imgui.end()

    def _grid(self, overlay: Overlay, card: tuple[float, float]) -> None:
        top = 0.0
        for row in self._rows:
            if row.heading is not None:
                imgui.set_cursor_pos(imgui.ImVec2(PAD, top))
                at = imgui.get_cursor_screen_pos()
                overlay.text(at.x, at.y + 14.0, _heading(row.heading), WARM, size=18.0)
                top += HEADING_HEIGHT
            for column, number in enumerate(row.cards):
                self._card(overlay, number, (PAD + column * (card[0] + CARD_GAP), top), card)
            top += CARD_HEIGHT + CARD_GAP
        imgui.set_cursor_pos(imgui.ImVec2(PAD, top))
        imgui.dummy(imgui.ImVec2(1.0, 16.0))

    def _card(self, overlay: Overlay, number: int, at: tuple[float, float], card: tuple[float, float]) -> None:
        imgui.set_cursor_pos(imgui.ImVec2(*at))
        corner = imgui.get_cursor_screen_pos()
        if imgui.invisible_button(f"card {number}", imgui.ImVec2(*card)):
            self._chosen = number
        if imgui.is_item_hovered() and _mouse_moved():
            self._selected = number
        if number == self._selected and self._scroll_to_selected:
            imgui.set_scroll_here_y(0.5)
            self._scroll_to_selected = False
        if imgui.is_item_visible():
            draw_card(overlay, self._entries[number], (corner.x, corner.y), card, number == self._selected)


def draw_card(overlay: Overlay, entry: Entry, at: tuple[float, float], card: tuple[float, float], lit: bool) -> None:
    """One card: title above, about below in two lines at most, with an edge of light when it is selected."""
    x, y = at
    if lit:
        overlay.panel((x - 1.5, y - 1.5, x + card[0] + 1.5, y + card[1] + 1.5), WARM, 0.75, 11.5)
    overlay.panel((x, y, x + card[0], y + card[1]), PANEL, 1.0, 10.0)
    room = card[0] - 2 * INDENT
    overlay.text(x + INDENT, y + 11.0, shorten(overlay, entry.title, room, 18.0), TEXT, size=18.0)
    first, rest = split_line(overlay, entry.about, room, 15.0)
    overlay.text(x + INDENT, y + 37.0, first, FAINT, size=15.0)
    overlay.text(x + INDENT, y + 56.0, shorten(overlay, rest, room, 15.0), FAINT, size=15.0)


def _heading(theme: str) -> str:
    return theme.replace("-", " ").replace("_", " ").capitalize()


def _mouse_moved() -> bool:
    delta = imgui.get_io().mouse_delta
    return bool(delta.x or delta.y)
