"""Time at the bottom edge: the scrubber over all that is known, and the buttons that run, step and rewind."""

from __future__ import annotations

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.window.actions.registry import BY_NAME
from sandbox.window.gui_style import palette_of
from sandbox.window.hud import speed_text
from sandbox.window.overlay import packed_color
from sandbox.window.widgets import button, mark
from sandbox.window.workspace import Workspace

BUTTONS = (
    ("start", icons.ICON_FA_BACKWARD_FAST), ("step-back", icons.ICON_FA_BACKWARD_STEP), ("pause", ""),
    ("step", icons.ICON_FA_FORWARD_STEP), ("end", icons.ICON_FA_FORWARD_FAST), ("restart", icons.ICON_FA_ROTATE_LEFT),
    ("slower", icons.ICON_FA_MINUS), ("faster", icons.ICON_FA_PLUS), ("undo", icons.ICON_FA_ARROW_ROTATE_LEFT),
    ("redo", icons.ICON_FA_ARROW_ROTATE_RIGHT),
)  # fmt: skip
TRACK_HEIGHT = 18.0


def draw_time_bar(workspace: Workspace, hint: str) -> None:
    """The scrubber above; the buttons, figures and `hint`, what the tool in hand does, below."""
    _draw_scrubber(workspace)
    clock, timeline = workspace.session.clock, workspace.session.timeline
    for name, icon in BUTTONS:
        action = BY_NAME[name]
        shown = icon or (icons.ICON_FA_PLAY if clock.paused else icons.ICON_FA_PAUSE)
        keys = f"   [{action.keys[0]}]"
        if button(f"time.{name}", shown, f"{action.title}{keys}\n{action.help}", enabled=action.enabled(workspace)):
            action.run(workspace)
        imgui.same_line()
        if name == "faster":
            imgui.text_disabled(f"{speed_text(clock.speed):>6} ")
            imgui.same_line()
    behind = timeline.length - timeline.step_count
    known = f"   {behind:,} steps known ahead" if behind else ""
    imgui.text_unformatted(f"{workspace.session.world.time:8.2f} s")
    imgui.same_line()
    imgui.text_disabled(f"step {timeline.step_count:,}{known}")
    imgui.same_line()
    _draw_hint(hint)


def _draw_hint(hint: str) -> None:
    """At the right edge, cut where there is no room."""
    left, room = imgui.get_cursor_pos_x() + 20.0, imgui.get_content_region_avail().x - 24.0
    width = imgui.calc_text_size(hint).x
    if room > 60.0:
        imgui.set_cursor_pos_x(left + max(room - width, 0.0))
        imgui.text_disabled(hint)


def _draw_scrubber(workspace: Workspace) -> None:
    """A track from step 0 to the last one known, with a tick for each act."""
    timeline, colors = workspace.session.timeline, palette_of(workspace.theme)
    corner, width = imgui.get_cursor_screen_pos(), max(imgui.get_content_region_avail().x, 1.0)
    imgui.invisible_button("scrubber", imgui.ImVec2(width, TRACK_HEIGHT))
    length = max(timeline.length, 1)
    if imgui.is_item_active():
        share = (imgui.get_io().mouse_pos.x - corner.x) / width
        workspace.session.clock.paused = True
        wanted = round(min(max(share, 0.0), 1.0) * timeline.length)
        if wanted != timeline.step_count:
            workspace.session.seek(wanted)
    mark("time.scrubber", "Drag to any moment. What you do there begins another future; undo brings this one back.")
    pen, y = imgui.get_window_draw_list(), corner.y + TRACK_HEIGHT / 2

    def rect(left: float, right: float, half: float, color: tuple[float, float, float]) -> None:
        low, high = imgui.ImVec2(corner.x + left, y - half), imgui.ImVec2(corner.x + right, y + half)
        pen.add_rect_filled(low, high, packed_color(color, 1.0), half)

    here = width * timeline.step_count / length
    rect(0.0, width, 2.5, colors.raised)
    rect(0.0, here, 2.5, colors.accent)
    for step in timeline.act_steps[-2000:]:
        x = corner.x + width * step / length
        color = packed_color(colors.second, 0.9)
        pen.add_line(imgui.ImVec2(x, y - 7.0), imgui.ImVec2(x, y + 7.0), color, 1.5)
    pen.add_circle_filled(imgui.ImVec2(corner.x + here, y), 7.0, packed_color(colors.accent, 1.0), 24)
