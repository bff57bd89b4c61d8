"""The screen of scenes: those opened lately, those of this folder, and the shipped ones by theme, with pictures."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pygame
from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.scene.catalog import Entry, search
from sandbox.window.card_grid import Row, card_rows, move
from sandbox.window.gallery_card import ABOUT_HEIGHT, PICTURE_SHARE, Card, draw_card
from sandbox.window.gui_style import apply_style, palette_of
from sandbox.window.overlay import Overlay, shorten
from sandbox.window.path_search import is_path, path_entries
from sandbox.window.screen import Canvas, Screen
from sandbox.window.thumbnails import Thumbnails
from sandbox.window.widgets import begin_picture, mark, text

CARD_GAP, HEADING_HEIGHT, HEAD_HEIGHT = 14.0, 48.0, 112.0
NARROWEST, WIDEST, WIDE_SHARE = 216.0, 1280.0, 0.8
"""Least width of a card, and the most that all cards of a row take: pixels, or a share of a larger window."""
PAD, EDGE = 8.0, 3.0
"""Pixels left of the cards and above them, where the frame of the chosen one has room."""
MOST_COLUMNS = 6
"""Few themes have more scenes; beyond that, cards are larger."""

_MOVES = {
    pygame.K_LEFT: (-1, 0), pygame.K_RIGHT: (1, 0), pygame.K_UP: (0, -1), pygame.K_DOWN: (0, 1),
    pygame.K_PAGEUP: (0, -3), pygame.K_PAGEDOWN: (0, 3),
}  # fmt: skip
"""Keys -> (right, down)."""
_WINDOW_FLAGS = int(
    imgui.WindowFlags_.no_title_bar | imgui.WindowFlags_.no_resize | imgui.WindowFlags_.no_move
    | imgui.WindowFlags_.no_collapse | imgui.WindowFlags_.no_background | imgui.WindowFlags_.no_nav
    | imgui.WindowFlags_.no_saved_settings | imgui.WindowFlags_.no_docking
)  # fmt: skip


class Gallery:
    """Cards of scenes under headings; what is typed filters them. `open_scene` gives the chosen one's screen."""

    counts = True

    def __init__(self, entries: list[Entry], open_scene: Callable[[Path], Screen]) -> None:
        self._all = self._entries = entries
        self._by_theme = True
        """Whether cards stand under headings: what was searched for stands in the order in which it fits."""
        self._open = open_scene
        self.message = ""
        self.search = ""
        self._selected = 0
        self._chosen: Path | None = None
        self._leaving = False
        self._scroll_to_selected = False
        self._focused = self._entered = False
        self._scale = 1.0
        self._field = 0
        self._rows: list[Row] = []
        self._thumbnails: Thumbnails | None = None

    def handle(self, event: pygame.event.Event, taken: tuple[bool, bool] = (False, False)) -> None:
        """Arrow keys, Enter and Esc; all else is typed into the search."""
        if event.type == pygame.DROPFILE:
            self._chosen = Path(event.file)
        if event.type != pygame.KEYDOWN:
            return
        if event.key == pygame.K_ESCAPE:
            self._leaving = not self.search
            self._write_search("")
        elif event.key in (pygame.K_RETURN, pygame.K_KP_ENTER) and self._entries:
            self._chosen = self._entries[self._selected].path
        elif event.key in _MOVES and self._rows:
            self._selected = move(self._rows, self._selected, *_MOVES[event.key])
            self._scroll_to_selected = True
        elif not taken[1] and event.unicode.isprintable():
            self._write_search(self.search + event.unicode)

    def update(self, elapsed: float) -> Screen | None:
        """Go where the user wants to."""
        if self._leaving:
            self._leaving = False
            return None
        if self._chosen is None:
            return self
        chosen, self._chosen, self.message = self._chosen, None, ""
        if chosen.is_dir():
            self._write_search(os.path.join("" if chosen.is_absolute() else ".", chosen, ""))
            return self
        return self._open(chosen)

    def say(self, message: str) -> None:
        """Show a message above the cards until the next choice."""
        self.message = message.splitlines()[0]

    def know(self, entries: list[Entry]) -> None:
        """Show these from now on, of those that there are the ones that were searched for."""
        self._all = entries
        self._look_for(self.search)

    def draw(self, canvas: Canvas) -> None:
        """Heading, search, message, cards."""
        if self._thumbnails is None:
            self._thumbnails = Thumbnails(canvas.display.context)
        canvas.clear()
        scale = self._scale = canvas.text_scale
        apply_style(canvas.theme, scale)
        begin_picture()
        width, height = canvas.display.size
        wide = min(max(WIDEST * scale, WIDE_SHARE * width), width - 48.0)
        left = (width - wide) / 2
        overlay = Overlay(canvas.gui, scale=scale)
        colors = palette_of(canvas.theme)
        overlay.text(left, 26.0 * scale, "sandbox", colors.text, size=32.0, bold=True)
        hint = "type words, or a path from / ~ or .  ·  arrows and Enter, or click  ·  Esc leaves"
        count = len(self._entries)
        shown = self.message or f"{count} scene{'' if count == 1 else 's'}"
        room = wide - overlay.width(hint) - 30.0
        overlay.text(left, 74.0 * scale, shorten(overlay, shown, room), colors.accent if self.message else colors.faint)
        if room > 120.0 * scale:
            overlay.text(left + wide - overlay.width(hint), 74.0 * scale, hint, colors.faint)
        self._draw_search(left + 150.0 * scale, min(360.0 * scale, wide - 150.0 * scale))
        self._draw_cards(canvas, left, wide, height)

    def _look_for(self, words: str) -> None:
        """Show what has all of these words, or what lies at the path that they are."""
        if words != self.search or self._entries is not self._all:
            self._selected = 0
        self.search = words
        self._by_theme = is_path(words) or not words.strip()
        if is_path(words):
            self._entries = path_entries(words)
        else:
            self._entries = self._all if self._by_theme else search(self._all, words)

    def _write_search(self, words: str) -> None:
        """As if they had been typed. ImGui's field keeps its own text while it is in use: another takes its place."""
        self._look_for(words)
        self._field, self._focused = self._field + 1, False

    def _draw_search(self, left: float, width: float) -> None:
        imgui.set_next_window_pos(imgui.ImVec2(left, 26.0 * self._scale))
        imgui.set_next_window_size(imgui.ImVec2(width, 44.0 * self._scale))
        imgui.begin("##search", None, _WINDOW_FLAGS | imgui.WindowFlags_.no_scrollbar)
        imgui.set_next_item_width(-1.0)
        if not self._focused:
            imgui.set_keyboard_focus_here()
            self._focused, self._entered = True, False
        imgui.push_id(self._field)
        hint = f"{icons.ICON_FA_MAGNIFYING_GLASS}  title, theme or file"
        words = text("gallery.search", "", self.search, hint, at_end=not self._entered)
        self._entered = self._entered or imgui.is_item_active()
        imgui.pop_id()
        if words != self.search:
            self._look_for(words)
        imgui.end()

    def _draw_cards(self, canvas: Canvas, left: float, wide: float, height: float) -> None:
        head = HEAD_HEIGHT * self._scale
        imgui.set_next_window_pos(imgui.ImVec2(left - PAD, head))
        imgui.set_next_window_size(imgui.ImVec2(wide + 3.5 * PAD, height - head))
        imgui.push_style_var(imgui.StyleVar_.window_padding, imgui.ImVec2(0.0, 0.0))
        imgui.begin("##scenes", None, _WINDOW_FLAGS)
        imgui.pop_style_var()
        fitting = int((wide + CARD_GAP) / (NARROWEST * self._scale + CARD_GAP))
        columns = min(max(fitting, 1), MOST_COLUMNS)
        self._rows = card_rows([entry.theme if self._by_theme else "" for entry in self._entries], columns)
        card = (wide - CARD_GAP * (columns - 1)) / columns
        self._draw_grid(canvas, (card, card * PICTURE_SHARE + ABOUT_HEIGHT * self._scale))
        imgui.end()

    def _draw_grid(self, canvas: Canvas, card: tuple[float, float]) -> None:
        top, overlay = EDGE, Overlay(canvas.gui, imgui.get_window_draw_list(), self._scale)
        colors = palette_of(canvas.theme)
        for row in self._rows:
            for column, theme in row.headings:
                imgui.set_cursor_pos(imgui.ImVec2(PAD + column * (card[0] + CARD_GAP), top))
                at = imgui.get_cursor_screen_pos()
                overlay.text(at.x, at.y + 14.0 * self._scale, _heading(theme), colors.accent, size=18.0)
            top += HEADING_HEIGHT * self._scale if row.headings else 0.0
            for column, number in enumerate(row.cards):
                self._draw_card(canvas, overlay, number, (PAD + column * (card[0] + CARD_GAP), top, *card))
            top += card[1] + CARD_GAP
        imgui.set_cursor_pos(imgui.ImVec2(PAD, top))
        imgui.dummy(imgui.ImVec2(1.0, 16.0))

    def _draw_card(self, canvas: Canvas, overlay: Overlay, number: int, box: tuple[float, float, float, float]) -> None:
        entry = self._entries[number]
        imgui.set_cursor_pos(imgui.ImVec2(box[0], box[1]))
        corner = imgui.get_cursor_screen_pos()
        if imgui.invisible_button(f"card {number} {entry.path}", imgui.ImVec2(box[2], box[3])):
            self._chosen = entry.path
        mark(f"card.{entry.path.name.split('.')[0]}", entry.about)
        if imgui.is_item_hovered() and _mouse_moved():
            self._selected = number
        if number == self._selected and self._scroll_to_selected:
            imgui.set_scroll_here_y(0.5)
            self._scroll_to_selected = False
        if imgui.is_item_visible() and self._thumbnails is not None:
            picture = self._thumbnails.texture(entry.path)
            card = Card(entry, picture, number == self._selected, palette_of(canvas.theme))
            draw_card(overlay, card, (corner.x, corner.y), (box[2], box[3]))


def _heading(theme: str) -> str:
    return theme.replace("-", " ").replace("_", " ").capitalize()


def _mouse_moved() -> bool:
    delta = imgui.get_io().mouse_delta
    return bool(delta.x or delta.y)
