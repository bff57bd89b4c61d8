"""The free axis in the scene: a line through the pair with a handle that turns it, whatever tool is in hand."""

from __future__ import annotations

import math

from imgui_bundle import imgui

from sandbox.geometry.sat_rows import Vec
from sandbox.geometry.shape_box import box_of
from sandbox.window.sat.drawing import Drawing
from sandbox.window.sat.focus import Focus
from sandbox.window.sat.overlap_curve import axis_at
from sandbox.window.widgets import mark
from sandbox.window.workspace import Workspace

REACH, GRIP = 96.0, 13.0
"""Pixels from the middle of the pair to the handle, and half of what can be caught of it."""
FLAGS = (
    imgui.WindowFlags_.no_decoration
    | imgui.WindowFlags_.no_background
    | imgui.WindowFlags_.no_move
    | imgui.WindowFlags_.no_docking
    | imgui.WindowFlags_.no_saved_settings
    | imgui.WindowFlags_.no_focus_on_appearing
    | imgui.WindowFlags_.no_nav
)


def draw_handle(workspace: Workspace, drawing: Drawing, focus: Focus) -> None:
    """The line, and a window of the handle's size that takes the mouse there."""
    pivot = _pivot(workspace, drawing)
    unit = axis_at(focus.free or 0.0)
    tip = pivot[0] + REACH * unit[0], pivot[1] - REACH * unit[1]
    imgui.set_next_window_pos(imgui.ImVec2(tip[0] - GRIP, tip[1] - GRIP))
    imgui.set_next_window_size(imgui.ImVec2(2 * GRIP, 2 * GRIP))
    imgui.push_style_var(imgui.StyleVar_.window_padding, imgui.ImVec2(0.0, 0.0))
    imgui.push_style_var(imgui.StyleVar_.window_min_size, imgui.ImVec2(1.0, 1.0))
    imgui.begin("##sat handle", None, FLAGS)
    imgui.pop_style_var(2)
    imgui.invisible_button("##grip", imgui.ImVec2(2 * GRIP, 2 * GRIP))
    mark("sat.handle", "Drag to turn the axis; with Ctrl it does not click into place.")
    hot = imgui.is_item_active() or imgui.is_item_hovered()
    if imgui.is_item_active():
        mouse = imgui.get_io().mouse_pos
        angle = math.degrees(math.atan2(pivot[1] - mouse.y, mouse.x - pivot[0]))
        focus.turn(drawing.seen, angle, snap=not imgui.get_io().key_ctrl)
    imgui.end()
    _draw(drawing, pivot, unit, hot)


def _draw(drawing: Drawing, pivot: Vec, unit: Vec, hot: bool) -> None:
    from sandbox.window.overlay import packed_color

    pen, color = drawing.pen.overlay.pen, drawing.pen.palette.accent
    paint = packed_color(color, 0.95)
    ends = [imgui.ImVec2(pivot[0] + k * REACH * unit[0], pivot[1] - k * REACH * unit[1]) for k in (-1.0, 1.0)]
    pen.add_line(ends[0], ends[1], paint, 1.6)
    pen.add_circle_filled(imgui.ImVec2(*pivot), 3.0, paint, 16)
    pen.add_circle_filled(ends[1], 9.0 if hot else 7.0, packed_color(drawing.pen.theme.background, 0.9), 24)
    pen.add_circle(ends[1], 9.0 if hot else 7.0, paint, 24, 2.5)
    pen.add_circle_filled(ends[1], 3.5, paint, 16)


def _pivot(workspace: Workspace, drawing: Drawing) -> Vec:
    """The pixel between the two shapes: the middle of what their boxes share, or of what lies between them."""
    a, b = box_of(drawing.seen.a), box_of(drawing.seen.b)
    x, y = (max(a[0], b[0]) + min(a[2], b[2])) / 2, (max(a[1], b[1]) + min(a[3], b[3])) / 2
    return workspace.viewport.pixel((x, y))
