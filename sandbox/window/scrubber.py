"""The scrubber: a track over all that is known, to go to any moment, and with Shift to choose a range."""

from __future__ import annotations

from imgui_bundle import imgui

from sandbox.render.theme import Color
from sandbox.window.gui_style import Palette, palette_of
from sandbox.window.overlay import packed_color
from sandbox.window.time_marks import TimeMark, Track
from sandbox.window.tooltip import tooltip
from sandbox.window.widgets import mark
from sandbox.window.workspace import Workspace

HEIGHT, KNOB = 18.0, 7.0
"""Pixels: of the track with all that stands on it, and the radius of the knob, which has room at both ends."""
HINT = "Drag: to any moment. Shift and drag: a range for an export."
MOST_TICKS = 2000


class Scrubber:
    """`draw` draws it and does what the mouse asks for; knows where a range was begun."""

    def __init__(self) -> None:
        self._begun: int | None = None

    def draw(self, workspace: Workspace) -> None:
        """A track from step 0 to the last one known, with a tick for each act and a flag for each mark."""
        timeline = workspace.session.timeline
        imgui.set_cursor_pos_x(imgui.get_cursor_pos_x() + KNOB)
        corner, width = imgui.get_cursor_screen_pos(), max(imgui.get_content_region_avail().x - KNOB, 1.0)
        imgui.invisible_button("scrubber", imgui.ImVec2(width, HEIGHT))
        mark("time.scrubber")
        track = Track(corner.x, width, timeline.length)
        flags = workspace.time_marks.all()
        if imgui.is_item_activated():
            self._begun = track.step(imgui.get_io().mouse_pos.x) if imgui.get_io().key_shift else None
        if imgui.is_item_active():
            self._drag(workspace, track, flags)
        elif imgui.is_item_hovered():
            _tell(workspace, track, flags)
        _paint(workspace, track, corner.y, flags)

    def _drag(self, workspace: Workspace, track: Track, flags: list[TimeMark]) -> None:
        """The hand takes time along, or with Shift the end of a range; without a way it chooses none."""
        x = imgui.get_io().mouse_pos.x
        if self._begun is not None:
            first, last = sorted((self._begun, track.step(x)))
            workspace.time_marks.chosen = (first, last) if last > first else None
            return
        near = track.near(x, flags)
        wanted = near[0].step if near else track.step(x)
        workspace.session.clock.paused = True
        if wanted != workspace.session.timeline.step_count:
            workspace.session.seek(wanted)


def time_text(workspace: Workspace, step: int) -> str:
    """A step as people read it: seconds and number."""
    seconds = step * float(workspace.session.world.state.settings[0].step_seconds)
    return f"{seconds:.2f} s, step {step:,}"


def _tell(workspace: Workspace, track: Track, flags: list[TimeMark]) -> None:
    x = imgui.get_io().mouse_pos.x
    near = track.near(x, flags)
    lines = [time_text(workspace, near[0].step if near else track.step(x)), *(flag.tip for flag in near)]
    chosen = workspace.time_marks.chosen
    if chosen is not None:
        lines.append(f"chosen: steps {chosen[0]:,} to {chosen[1]:,}")
    tooltip("\n".join([*lines, *([] if near else [HINT])]))


def _paint(workspace: Workspace, track: Track, top: float, flags: list[TimeMark]) -> None:
    timeline, colors = workspace.session.timeline, palette_of(workspace.theme)
    pen, y = imgui.get_window_draw_list(), top + HEIGHT / 2

    def bar(left: float, right: float, half: float, color: Color, opacity: float = 1.0) -> None:
        low, high = imgui.ImVec2(left, y - half), imgui.ImVec2(right, y + half)
        pen.add_rect_filled(low, high, packed_color(color, opacity), min(half, 3.0))

    here = track.x(timeline.step_count)
    chosen = workspace.time_marks.chosen
    if chosen is not None and chosen[0] < timeline.length:
        bar(track.x(chosen[0]), track.x(min(chosen[1], timeline.length)), HEIGHT / 2, colors.accent, 0.28)
    bar(track.left, track.left + track.width, 2.5, colors.raised)
    bar(track.left, here, 2.5, colors.accent)
    tick = packed_color(colors.second, 0.9)
    for step in timeline.act_steps[-MOST_TICKS:]:
        x = track.x(step)
        pen.add_line(imgui.ImVec2(x, y - 7.0), imgui.ImVec2(x, y + 7.0), tick, 1.5)
    for flag in flags:
        if flag.step <= timeline.length:
            _flag(pen, track.x(flag.step), y, colors, flag)
    pen.add_circle_filled(imgui.ImVec2(here, y), KNOB, packed_color(colors.accent, 1.0), 24)


def _flag(pen: imgui.ImDrawList, x: float, y: float, colors: Palette, flag: TimeMark) -> None:
    """A pole with a pennant, clear of the knob, which would hide it."""
    color = packed_color(getattr(colors, flag.color), 1.0)
    side = -1.0 if flag.step > 0 and x > imgui.get_window_pos().x + imgui.get_window_width() - 24.0 else 1.0
    pen.add_line(imgui.ImVec2(x, y - 9.0), imgui.ImVec2(x, y + 9.0), color, 2.0)
    tip, low = imgui.ImVec2(x + side * 9.0, y - 5.0), imgui.ImVec2(x, y - 1.0)
    pen.add_triangle_filled(imgui.ImVec2(x, y - 9.0), tip, low, color)
