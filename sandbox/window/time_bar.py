"""Time at the bottom edge: the scrubber over all that is known, and the buttons that run, step and rewind."""

from __future__ import annotations

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.window.actions.registry import BY_NAME
from sandbox.window.hud import speed_text
from sandbox.window.scrubber import Scrubber
from sandbox.window.widgets import button, mark
from sandbox.window.workspace import Workspace

BUTTONS = (
    ("start", icons.ICON_FA_BACKWARD_FAST), ("step-back", icons.ICON_FA_BACKWARD_STEP), ("pause", ""),
    ("step", icons.ICON_FA_FORWARD_STEP), ("end", icons.ICON_FA_FORWARD_FAST), ("restart", icons.ICON_FA_ROTATE_LEFT),
    ("slower", icons.ICON_FA_MINUS), ("faster", icons.ICON_FA_PLUS), ("undo", icons.ICON_FA_ARROW_ROTATE_LEFT),
    ("redo", icons.ICON_FA_ARROW_ROTATE_RIGHT),
)  # fmt: skip


def draw_time_bar(workspace: Workspace, scrubber: Scrubber, hint: str) -> None:
    """The scrubber above; the buttons, figures and `hint`, what the tool in hand does, below."""
    scrubber.draw(workspace)
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
    """At the right edge; what does not fit is said under the pointer."""
    left, room = imgui.get_cursor_pos_x() + 20.0, imgui.get_content_region_avail().x - 24.0
    if room <= 60.0:
        return
    shown = hint
    while imgui.calc_text_size(shown).x > room and " " in shown:
        shown = shown.removesuffix(" …").rpartition(" ")[0] + " …"
    imgui.set_cursor_pos_x(left + max(room - imgui.calc_text_size(shown).x, 0.0))
    imgui.text_disabled(shown)
    mark("hint", hint if shown != hint else "")
