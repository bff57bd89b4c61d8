"""The screen that lists the shipped scenes: click one, or choose with the arrow keys and press Enter."""

from __future__ import annotations

from collections.abc import Callable
from itertools import groupby
from pathlib import Path

import pygame
from imgui_bundle import imgui

from sandbox.window.gui import Pen
from sandbox.window.hud import FAINT, PANEL, TEXT, WARM
from sandbox.window.scene_index import Entry
from sandbox.window.screen import Screen, Stage

CARD_HEIGHT, CARD_GAP, HEADING_HEIGHT, WIDEST, NARROWEST = 64.0, 10.0, 44.0, 1120.0, 340.0
HEAD_HEIGHT = 108.0


class SceneList:
    """Cards of scenes under headings of themes. `open_scene` gives the screen for the chosen file."""

    counts = True

    def __init__(self, entries: list[Entry], open_scene: Callable[[Path], Screen]) -> None:
        self._entries = entries
        self._open = open_scene
        self._message = ""
        self._selected = 0
        self._chosen: int | None = None
        self._leaving = False
        self._scroll_to_selected = False
        self._columns = 1

    def handle(self, event: pygame.event.Event) -> None:
        """Arrow keys, Enter and Esc."""
        if event.type != pygame.KEYDOWN:
            return
        if event.key == pygame.K_ESCAPE:
            self._leaving = True
        elif event.key in (pygame.K_RETURN, pygame.K_KP_ENTER) and self._entries:
            self._chosen = self._selected
        else:
            self._move(event.key)

    def update(self, elapsed: float) -> Screen | None:
        """Go where the user wants to."""
        if self._leaving:
            return None
        if self._chosen is None:
            return self
        chosen, self._chosen, self._leaving, self._message = self._chosen, None, False, ""
        return self._open(self._entries[chosen].path)

    def say(self, message: str) -> None:
        """Show a message above the cards until the next choice."""
        self._message = message.splitlines()[0]

    def draw(self, stage: Stage) -> None:
        """Heading, message, cards."""
        stage.clear()
        width, height = stage.display.size
        wide = min(WIDEST, width - 48.0)
        left = (width - wide) / 2
        pen = Pen(stage.gui)
        pen.text(left, 30.0, "sandbox", TEXT, size=32.0, bold=True)
        self._subtitle(pen, left, wide)
        self._cards(stage, left, wide, height)

    def _subtitle(self, pen: Pen, left: float, wide: float) -> None:
        hint = "arrows and Enter, or click  ·  Esc leaves"
        text = self._message or f"{len(self._entries)} scenes"
        pen.text(
            left, 70.0, shorten(pen, text, wide - pen.width(hint) - 30.0), WARM if self._message else FAINT
        )
        pen.text(left + wide - pen.width(hint), 70.0, hint, FAINT)

    def _cards(self, stage: Stage, left: float, wide: float, height: float) -> None:
        imgui.set_next_window_pos(imgui.ImVec2(left - 8.0, HEAD_HEIGHT))
        imgui.set_next_window_size(imgui.ImVec2(wide + 28.0, height - HEAD_HEIGHT))
        flags = (
            imgui.WindowFlags_.no_decoration | imgui.WindowFlags_.no_background | imgui.WindowFlags_.no_move
        )
        flags |= imgui.WindowFlags_.no_nav
        imgui.begin("scenes", None, int(flags) & ~int(imgui.WindowFlags_.no_scrollbar))
        self._columns = max(int((wide + CARD_GAP) / (NARROWEST + CARD_GAP)), 1)
        card = (wide - CARD_GAP * (self._columns - 1)) / self._columns
        self._grid(Pen(stage.gui, imgui.get_window_draw_list()), (card, CARD_HEIGHT))
        imgui.end()

    def _grid(self, pen: Pen, card: tuple[float, float]) -> None:
        top = 8.0
        numbered = list(enumerate(self._entries))
        for theme, group in groupby(numbered, key=lambda item: item[1].theme):
            imgui.set_cursor_pos(imgui.ImVec2(8.0, top))
            at = imgui.get_cursor_screen_pos()
            pen.text(
                at.x, at.y + 8.0, theme.replace("-", " ").replace("_", " ").capitalize(), WARM, size=18.0
            )
            top += HEADING_HEIGHT
            for place, (number, entry) in enumerate(group):
                column, row = place % self._columns, place // self._columns
                x = 8.0 + column * (card[0] + CARD_GAP)
                self._card(pen, number, entry, (x, top + row * (CARD_HEIGHT + CARD_GAP)), card)
            top += (row + 1) * (CARD_HEIGHT + CARD_GAP) + 8.0
        imgui.set_cursor_pos(imgui.ImVec2(8.0, top))
        imgui.dummy(imgui.ImVec2(1.0, 16.0))

    def _card(
        self, pen: Pen, number: int, entry: Entry, at: tuple[float, float], card: tuple[float, float]
    ) -> None:
        imgui.set_cursor_pos(imgui.ImVec2(*at))
        corner = imgui.get_cursor_screen_pos()
        if imgui.invisible_button(f"card {number}", imgui.ImVec2(*card)):
            self._chosen = number
        if imgui.is_item_hovered() and self._mouse_moved():
            self._selected = number
        if number == self._selected and self._scroll_to_selected:
            imgui.set_scroll_here_y(0.5)
            self._scroll_to_selected = False
        draw_card(pen, entry, (corner.x, corner.y), card, number == self._selected)

    def _mouse_moved(self) -> bool:
        delta = imgui.get_io().mouse_delta
        return bool(delta.x or delta.y)

    def _move(self, key: int) -> None:
        steps = {
            pygame.K_LEFT: -1, pygame.K_RIGHT: 1, pygame.K_UP: -self._columns, pygame.K_DOWN: self._columns,
            pygame.K_PAGEUP: -4 * self._columns, pygame.K_PAGEDOWN: 4 * self._columns,
            pygame.K_HOME: -len(self._entries), pygame.K_END: len(self._entries),
        }  # fmt: skip
        if key in steps and self._entries:
            self._selected = min(max(self._selected + steps[key], 0), len(self._entries) - 1)
            self._scroll_to_selected = True


def draw_card(pen: Pen, entry: Entry, at: tuple[float, float], card: tuple[float, float], lit: bool) -> None:
    """One card: title above, about below, brighter with an edge of light when it is selected."""
    x, y = at
    if lit:
        pen.panel((x - 1.5, y - 1.5, x + card[0] + 1.5, y + card[1] + 1.5), WARM, 0.75, 11.5)
    pen.panel((x, y, x + card[0], y + card[1]), PANEL, 1.0, 10.0)
    room = card[0] - 32.0
    pen.text(x + 16.0, y + 11.0, shorten(pen, entry.title, room, 18.0), TEXT, size=18.0)
    pen.text(x + 16.0, y + 36.0, shorten(pen, entry.about, room, 15.0), FAINT, size=15.0)


def shorten(pen: Pen, text: str, room: float, size: float = 16.0) -> str:
    """`text`, cut with an ellipsis where it would be wider than `room` pixels."""
    if pen.width(text, size) <= room:
        return text
    low, high = 0, len(text)
    while low < high:
        middle = (low + high + 1) // 2
        fits = pen.width(text[:middle].rstrip() + "…", size) <= room
        low, high = (middle, high) if fits else (low, middle - 1)
    return text[:low].rstrip() + "…"
