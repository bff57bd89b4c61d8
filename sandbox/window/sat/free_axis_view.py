"""The axis that is turned by hand: a dial, and the overlap as a function of its angle."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui, implot

from sandbox.render.number_text import metres
from sandbox.render.theme import Color
from sandbox.window.gui_style import Palette
from sandbox.window.overlay import packed_color
from sandbox.window.sat.colors import SatColors
from sandbox.window.sat.focus import Focus
from sandbox.window.sat.inspection import Inspection
from sandbox.window.sat.measure import scaled
from sandbox.window.sat.overlap_curve import axis_angle, overlap_at
from sandbox.window.widgets import button, mark

DIAL = 112.0
"""Pixels across the dial; the curve beside it is as high."""
RING = 9.0
"""Pixels: how thick the ring of the dial is."""
PLOT = implot.Flags_.canvas_only | implot.Flags_.no_frame
TICKS = (0.0, 45.0, 90.0, 135.0, 180.0)
LOCKED = implot.AxisFlags_.lock | implot.AxisFlags_.no_menus | implot.AxisFlags_.no_highlight


class FreeAxisView:
    """Draws dial and curve of one inspection."""

    def __init__(self, seen: Inspection, focus: Focus, palette: Palette, colors: SatColors) -> None:
        self.seen, self.focus, self.palette, self.colors = seen, focus, palette, colors

    @property
    def angle(self) -> float:
        """Degrees of the axis to show: the free one, or that of the row in focus."""
        if self.focus.free is not None:
            return self.focus.free
        row = self.focus.row(self.seen)
        return axis_angle(row.axis) if row is not None else 0.0

    def draw(self) -> None:
        """The figures, and below them the dial beside the curve."""
        self._figures()
        self._dial()
        imgui.same_line(0.0, 10.0)
        self._curve()

    def _dial(self) -> None:
        corner, radius = imgui.get_cursor_screen_pos(), scaled(DIAL) / 2
        imgui.invisible_button("##sat dial", imgui.ImVec2(2 * radius, 2 * radius))
        mark("sat.dial", "Turn the axis. It clicks into place at the axes of edges; hold Ctrl to turn it freely.\n"
             "The ring says on which axes there is a gap.")  # fmt: skip
        middle = corner.x + radius, corner.y + radius
        if imgui.is_item_active():
            mouse, io = imgui.get_io().mouse_pos, imgui.get_io()
            turned = math.degrees(math.atan2(middle[1] - mouse.y, mouse.x - middle[0]))
            self.focus.turn(self.seen, turned, snap=not io.key_ctrl)
        self._draw_dial(middle, radius)

    def _draw_dial(self, middle: tuple[float, float], radius: float) -> None:
        pen, center = imgui.get_window_draw_list(), imgui.ImVec2(*middle)
        pen.add_circle_filled(center, radius - RING, packed_color(self.palette.inset, 1.0), 64)
        curve, ring = self.seen.curve, radius - RING / 2
        # On a screen y points down, so angles run the other way; an axis is a line, so each half shows the same.
        for start, end, gap in _stretches(curve.angles, curve.overlap):
            color = packed_color(self.colors.gap if gap else self.colors.out, 0.85 if gap else 0.4)
            for half in (0.0, 180.0):
                pen.path_arc_to(center, ring, -math.radians(end + half), -math.radians(start + half), 0)
                pen.path_stroke(color, thickness=RING - 2.0)
        for row in self.seen.table.rows:
            color = packed_color(self.colors.of(row.owner), 1.0)
            for half in (0.0, math.pi):
                turn = math.radians(axis_angle(row.axis)) + half
                c, s, far = math.cos(turn), -math.sin(turn), radius - RING - 1
                p = imgui.ImVec2(middle[0] + c * (far - 7), middle[1] + s * (far - 7))
                q = imgui.ImVec2(middle[0] + c * far, middle[1] + s * far)
                pen.add_line(p, q, color, 2.0)
        turn = math.radians(self.angle)
        x, y = math.cos(turn) * (radius - RING - 11), -math.sin(turn) * (radius - RING - 11)
        on = self.focus.free is not None
        color = packed_color(self.palette.accent if on else self.palette.faint, 1.0)
        pen.add_line(imgui.ImVec2(middle[0] - x, middle[1] - y), imgui.ImVec2(middle[0] + x, middle[1] + y), color, 2.0)
        pen.add_circle_filled(imgui.ImVec2(middle[0] + x, middle[1] + y), 5.0, color, 20)

    def _figures(self) -> None:
        angle = self.angle % 180.0
        overlap = float(overlap_at(self.seen.a, self.seen.b, np.array([angle]))[0])
        imgui.align_text_to_frame_padding()
        imgui.text_unformatted(f"{angle:.1f}°")
        imgui.same_line(0.0, 16.0)
        color, word = (self.colors.out, "overlap") if overlap > 0.0 else (self.colors.gap, "gap")
        imgui.push_style_color(imgui.Col_.text, imgui.ImVec4(*color, 1.0))
        imgui.text_unformatted(f"{word} {metres(abs(overlap))}")
        imgui.pop_style_color()
        imgui.same_line(0.0, 16.0)
        on = self.focus.free is not None
        words = "  by hand" if imgui.get_content_region_avail().x > scaled(90.0) else ""
        if button("sat.free", icons.ICON_FA_ROTATE + words, "Turn an axis in the scene, or stop doing so.", on=on):
            self.focus.free, self.focus.step = (None if on else self.angle), None

    def _moral(self) -> str:
        """What the curve shows."""
        least, most = self.seen.curve.limits
        if least > 0.0:
            return "there is no gap on any line"
        return "there is a gap on every line" if most <= 0.0 else "there is a gap on some lines"

    def _curve(self) -> None:
        least, most = self.seen.curve.limits
        pad = 0.12 * max(most - least, 1e-9)
        low, high = min(least, 0.0) - pad, max(most, 0.0) + pad
        imgui.push_font(None, 12.0)
        implot.push_style_var(implot.StyleVar_.plot_padding, imgui.ImVec2(12.0, 6.0))
        implot.push_style_color(implot.Col_.plot_bg, imgui.ImVec4(*self.palette.inset, 1.0))
        implot.push_style_color(implot.Col_.plot_border, imgui.ImVec4(*self.palette.line, 1.0))
        if implot.begin_plot("##sat curve", imgui.ImVec2(imgui.get_content_region_avail().x - 4.0, scaled(DIAL)), PLOT):
            implot.setup_axes("", "", LOCKED, LOCKED | implot.AxisFlags_.no_grid_lines)
            implot.setup_axis_limits(implot.ImAxis_.x1, 0.0, 180.0, implot.Cond_.always)
            implot.setup_axis_limits(implot.ImAxis_.y1, low, high, implot.Cond_.always)
            implot.setup_axis_ticks(implot.ImAxis_.x1, list(TICKS), [f"{at:g}°" for at in TICKS])
            self._plot()
            implot.end_plot()
        tip = "Overlap in metres over the angle of the axis; below 0, a gap. Drag to turn the axis.\nA dot is an axis"
        mark("sat.curve", f"{tip} of the table: {self._moral()}.")
        implot.pop_style_color(2)
        implot.pop_style_var()
        imgui.pop_font()

    def _plot(self) -> None:
        curve = self.seen.curve
        shared, gap = np.maximum(curve.overlap, 0.0), np.minimum(curve.overlap, 0.0)
        implot.plot_shaded("out", curve.angles, shared, 0.0, _spec(self.colors.out, fill=0.28))
        implot.plot_shaded("gap", curve.angles, gap, 0.0, _spec(self.colors.gap, fill=0.28))
        implot.plot_line("zero", np.array([0.0, 180.0]), np.zeros(2), _spec(self.palette.faint))
        implot.plot_line("overlap", curve.angles, curve.overlap, _spec(self.palette.text, weight=1.8))
        self._marks()
        if implot.is_plot_hovered() and imgui.is_mouse_down(imgui.MouseButton_.left):
            free = not imgui.get_io().key_ctrl
            self.focus.turn(self.seen, min(max(implot.get_plot_mouse_pos().x, 0.0), 179.99), snap=free)

    def _marks(self) -> None:
        """A dot for each axis of the table, and the cursor."""
        pen = implot.get_plot_draw_list()
        limits = implot.get_plot_limits()
        at = self.angle % 180.0
        top, bottom = implot.plot_to_pixels(at, limits.y.max), implot.plot_to_pixels(at, limits.y.min)
        implot.push_plot_clip_rect()
        color = self.palette.accent if self.focus.free is not None else self.palette.faint
        pen.add_line(top, bottom, packed_color(color, 0.9), 1.5)
        for row in self.seen.table.rows:
            spot = implot.plot_to_pixels(axis_angle(row.axis), -row.separation)
            deciding = row is self.seen.deciding
            pen.add_circle_filled(spot, 5.5 if deciding else 4.0, packed_color(self.palette.inset, 1.0), 20)
            own = self.colors.of(row.owner) if not deciding else self.colors.gap if row.gap else self.colors.mtv
            strength = 1.0 if row.number <= self.seen.tested else 0.45
            pen.add_circle_filled(spot, 4.2 if deciding else 2.8, packed_color(own, strength), 20)
            if self.focus.hovered == row.number:
                pen.add_circle(spot, 7.0, packed_color(self.palette.accent, 1.0), 24, 1.5)
        implot.pop_plot_clip_rect()


def _spec(color: Color, weight: float = 1.0, fill: float = 1.0) -> implot.Spec:
    paint = imgui.ImVec4(*color, 1.0)
    return implot.Spec(line_color=paint, line_weight=weight, fill_color=paint, fill_alpha=fill)


def _stretches(angles: np.ndarray, overlap: np.ndarray) -> list[tuple[float, float, bool]]:
    """(start, end, gap): the stretches of angles on which there is a gap, and those between."""
    gap = overlap <= 0.0
    turns = [0, *(np.flatnonzero(gap[1:] != gap[:-1]) + 1).tolist(), len(angles) - 1]
    ends = pairwise(turns)
    return [(float(angles[i]), float(angles[j]), bool(gap[i])) for i, j in ends if j > i]
