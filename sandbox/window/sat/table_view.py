"""The table of the test, live: one row an axis, its four projections, gap or way out, and small bars of both."""

from __future__ import annotations

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.geometry.sat_rows import SatRow
from sandbox.render.number_text import metres, short
from sandbox.render.sat_labels import axis_name
from sandbox.render.theme import Color
from sandbox.window.gui_style import Palette
from sandbox.window.overlay import packed_color
from sandbox.window.sat.colors import SatColors
from sandbox.window.sat.focus import Focus
from sandbox.window.sat.inspection import Inspection
from sandbox.window.sat.measure import scaled
from sandbox.window.widgets import mark

ROW, MOST_ROWS = 36.0, 9
"""Height of a row in pixels, and how many are shown before the table scrolls."""
WIDE, NARROW = 430.0, 300.0
"""Pixels from which the axis is written out as well, and below which all is written smaller."""
LEAST = 0.2
"""How small that is at least: in a panel without room the table is cut off."""
TEXT, UNTESTED = 13.0, 0.78
"""Size of what is written, and the opacity of rows that the test did not need."""


class TableView:
    """Draws the table of one inspection."""

    def __init__(self, seen: Inspection, focus: Focus, palette: Palette, colors: SatColors) -> None:
        self.seen, self.focus, self.palette, self.colors = seen, focus, palette, colors
        self._high = scaled(ROW)
        rows = seen.table.rows
        shorter = [min(row.amax - row.amin, row.bmax - row.bmin) / row.length for row in rows]
        self._half = max(1.1 * one + max(row.separation, 0.0) / 2 for one, row in zip(shorter, rows, strict=True))

    def draw(self) -> None:
        """Header and rows; says what is pointed at, and takes clicks."""
        self.focus.pointed = None
        wide = imgui.get_content_region_avail().x
        rows = self.seen.table.rows
        scrolls = len(rows) > MOST_ROWS
        wide -= imgui.get_style().scrollbar_size if scrolls else 0.0
        shrink = min(max(wide / scaled(NARROW), LEAST), 1.0)
        columns = _Columns(wide, shrink)
        imgui.push_font(None, TEXT * shrink)
        self._header(columns)
        imgui.push_style_var(imgui.StyleVar_.item_spacing, imgui.ImVec2(0.0, 0.0))
        imgui.begin_child("##sat rows", imgui.ImVec2(0.0, self._high * min(len(rows), MOST_ROWS)))
        clipper = imgui.ListClipper()
        clipper.begin(len(rows), self._high)
        while clipper.step():
            for number in range(clipper.display_start, clipper.display_end):
                self._row(rows[number], columns)
        clipper.end()
        imgui.end_child()
        imgui.pop_style_var()
        imgui.pop_font()

    def _header(self, columns: _Columns) -> None:
        corner = imgui.get_cursor_screen_pos()
        words = [(columns.owner, "edge", False), (columns.last, "gap/overlap", True)]
        words += [
            (at, word, True) for at, word in zip(columns.numbers, ("a min", "a max", "b min", "b max"), strict=True)
        ]
        if columns.axis is not None:
            words.append((columns.axis, "axis", False))
        for at, word, right in words:
            _text(corner.x + at, corner.y, word, self.palette.faint, right)
        imgui.dummy(imgui.ImVec2(0.0, scaled(TEXT) + 3.0))

    def _row(self, row: SatRow, columns: _Columns) -> None:
        seen, name = self.seen, f"sat.row.{row.number}"
        corner = imgui.get_cursor_screen_pos()
        clicked, _ = imgui.selectable(f"##{name}", self.focus.chosen == row.number, 0, imgui.ImVec2(0.0, self._high))
        hovered = imgui.is_item_hovered()
        mark(name, self._tip(row) if hovered else "")
        if hovered:
            self.focus.pointed = row.number
        if clicked:
            self.focus.chosen = None if self.focus.chosen == row.number else row.number
            self.focus.free = self.focus.step = None
        untested = row.number > seen.tested
        self._plate(row, corner, columns)
        self._words(row, corner, columns, UNTESTED if untested else 1.0)
        self._bars(row, corner, columns, 0.7 * UNTESTED if untested else 1.0)
        self._arrow(row, corner, columns, UNTESTED if untested else 1.0)
        if row.stopped:
            self._exit_line(corner, columns)

    def _plate(self, row: SatRow, corner: imgui.ImVec2, columns: _Columns) -> None:
        """A lit ground under the row that is pointed at, and a stripe at the one that decides."""
        pen, least = imgui.get_window_draw_list(), imgui.ImVec2(corner.x, corner.y + 1)
        most = imgui.ImVec2(corner.x + columns.width, corner.y + self._high - 1)
        if self.focus.lit == row.number:
            pen.add_rect_filled(least, most, packed_color(self.palette.hovered, 0.9), 4.0)
        if row is self.seen.deciding:
            color = self.colors.gap if row.gap else self.colors.mtv
            pen.add_rect_filled(least, most, packed_color(color, 0.13), 4.0)
            pen.add_rect_filled(least, imgui.ImVec2(corner.x + 3, most.y), packed_color(color, 1.0), 1.5)

    def _words(self, row: SatRow, corner: imgui.ImVec2, columns: _Columns, strength: float) -> None:
        x, y = corner.x, corner.y + scaled(4.0)
        _text(x + columns.number, y, str(row.number), self.palette.faint, True, strength)
        _text(x + columns.owner, y, _owner(row), self.colors.of(row.owner), False, strength)
        if columns.axis is not None:
            _text(
                x + columns.axis, y, f"({short(row.axis[0])}, {short(row.axis[1])})", self.palette.text, False, strength
            )
        colors = (self.colors.a, self.colors.a, self.colors.b, self.colors.b)
        for at, value, color in zip(columns.numbers, (row.amin, row.amax, row.bmin, row.bmax), colors, strict=True):
            words = short(value) if columns.axis is not None else narrow(value)
            _text(x + at, y, words, color, True, strength)
        second = row is self.seen.table.runner_up
        outcome = self.colors.mtv if row is self.seen.deciding and not row.gap else self.colors.outcome(row)
        _text(x + columns.last, y, metres(abs(row.separation)), outcome, True, strength)
        note = icons.ICON_FA_HAND if row.stopped else "2nd" if second else ""
        if note:
            _text(
                x + columns.owner,
                y + scaled(15.0),
                note,
                outcome if row.stopped else self.palette.faint,
                False,
                strength,
            )

    def _bars(self, row: SatRow, corner: imgui.ImVec2, columns: _Columns, strength: float) -> None:
        """Both intervals, about what they share, in one scale for all rows."""
        pen = imgui.get_window_draw_list()
        left, right, top = corner.x + columns.bars, corner.x + columns.width - 4.0, corner.y + scaled(22.0)
        low, high = max(row.amin, row.bmin) / row.length, min(row.amax, row.bmax) / row.length
        middle, scale = (low + high) / 2, (right - left) / (2.0 * self._half)

        def x(value: float) -> float:
            return min(max((left + right) / 2 + (value - middle) * scale, left), right)

        first, last = sorted((x(low), x(high)))
        band = imgui.ImVec2(first - 0.5, top - 2.0), imgui.ImVec2(last + 0.5, top + 10.0)
        pen.add_rect_filled(*band, packed_color(self.colors.outcome(row), 0.38 * strength), 1.0)
        ends = ((self.colors.a, row.amin, row.amax, top), (self.colors.b, row.bmin, row.bmax, top + 5.0))
        for color, least, most, y in ends:
            start, end = imgui.ImVec2(x(least / row.length), y), imgui.ImVec2(x(most / row.length), y + 3.0)
            pen.add_rect_filled(start, end, packed_color(color, strength), 1.5)

    def _arrow(self, row: SatRow, corner: imgui.ImVec2, columns: _Columns, strength: float) -> None:
        """Which way the axis points."""
        x, y, half = corner.x + columns.number - 5.0, corner.y + scaled(26.0), scaled(6.0)
        ux, uy = row.axis[0] / row.length * half, -row.axis[1] / row.length * half
        pen, color = imgui.get_window_draw_list(), packed_color(self.colors.of(row.owner), strength)
        tip = imgui.ImVec2(x + ux, y + uy)
        pen.add_line(imgui.ImVec2(x - ux, y - uy), tip, color, 1.5)
        for side in (1.0, -1.0):
            barb = imgui.ImVec2(tip.x - 0.55 * ux + side * 0.45 * uy, tip.y - 0.55 * uy - side * 0.45 * ux)
            pen.add_line(tip, barb, color, 1.5)

    def _exit_line(self, corner: imgui.ImVec2, columns: _Columns) -> None:
        y = corner.y + self._high - 0.5
        color = packed_color(self.colors.gap, 0.9)
        imgui.get_window_draw_list().add_line(
            imgui.ImVec2(corner.x, y), imgui.ImVec2(corner.x + columns.width, y), color, 1.5
        )

    def _tip(self, row: SatRow) -> str:
        state = "not tested: an earlier axis leaves a gap" if row.number > self.seen.tested else ""
        state = "the test stops here" if row.stopped else state
        state = "the least overlap: the way out" if row is self.seen.table.mtv_row else state
        axis = f"axis ({short(row.axis[0])}, {short(row.axis[1])}), {axis_name(row, self.seen.names)}"
        return f"{axis}\n{state}" if state else axis


class _Columns:
    """Where columns begin or, of numbers, end, in pixels from the left."""

    def __init__(self, width: float, shrink: float) -> None:
        self.width = width
        wide, unit = width >= scaled(WIDE), scaled(shrink)
        self.number, self.owner, self.bars = 20.0 * unit, 27.0 * unit, 60.0 * unit
        self.axis = 72.0 * unit if wide else None
        start, self.last = (190.0 if wide else 48.0) * unit, width - 4.0
        each = (width - 78.0 * unit - start) / 4.0
        self.numbers = [start + each * (k + 1) for k in range(4)]


def narrow(value: float) -> str:
    """A number in seven letters at most, with as many digits as fit."""
    words = (f"{value:.{digits}g}" for digits in (4, 3, 2))
    return next((word for word in (short(value), *words) if len(word) <= 7), f"{value:.0e}")


def _owner(row: SatRow) -> str:
    if row.owner == "corners":
        ends = zip((row.edge, row.other), row.centers, strict=True)
        return "-".join("c" if center else f"v{number}" for number, center in ends)
    return f"{row.owner} E{row.edge}"


def _text(x: float, y: float, text: str, color: Color, right: bool, strength: float = 1.0) -> None:
    """One line in the window being drawn, beginning or, with `right`, ending at x."""
    if right:
        x -= imgui.calc_text_size(text).x
    imgui.get_window_draw_list().add_text(imgui.ImVec2(round(x), round(y)), packed_color(color, strength), text)
