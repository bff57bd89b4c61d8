"""Time at the bottom edge: the scrubber over all that is known, and the buttons that run, step and rewind."""

from __future__ import annotations

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.render.number_text import counted
from sandbox.window import scrubber as track
from sandbox.window.actions.registry import BY_NAME
from sandbox.window.branch_list import branch_icon, draw_branches
from sandbox.window.gui_style import palette_of
from sandbox.window.hint import Hint
from sandbox.window.hint_line import HintLine
from sandbox.window.hud import speed_text
from sandbox.window.scrubber import Scrubber
from sandbox.window.widgets import button
from sandbox.window.workspace import Workspace

BUTTONS = (
    ("start", icons.ICON_FA_BACKWARD_FAST), ("step-back", icons.ICON_FA_BACKWARD_STEP), ("pause", ""),
    ("step", icons.ICON_FA_FORWARD_STEP), ("end", icons.ICON_FA_FORWARD_FAST), ("restart", icons.ICON_FA_ROTATE_LEFT),
    ("slower", icons.ICON_FA_MINUS), ("faster", icons.ICON_FA_PLUS), ("undo", icons.ICON_FA_REPLY),
    ("redo", icons.ICON_FA_SHARE),
)  # fmt: skip
LEAST_NEEDED = ("start", "end"), ("slower", "faster"), ("step-back", "step"), ("restart",)
"""Left out, in that order, where not all buttons find room: their keys and the menu Time do the same."""
PAD = 6.0


def time_bar_height() -> float:
    """Pixels that it takes: the scrubber and a row of buttons, with room around them."""
    return float(track.HEIGHT + imgui.get_style().item_spacing.y + imgui.get_frame_height() + 2 * PAD + 7.0)


def draw_time_bar(workspace: Workspace, scrubber: Scrubber, hint: Hint) -> None:
    """The scrubber above; the buttons, figures and `hint`, what the tool in hand does, below."""
    scrubber.draw(workspace)
    clock = workspace.session.clock
    buttons = [*BUTTONS, *([("branches", branch_icon(workspace))] if workspace.session.timeline.branches else [])]
    for name, icon in _fitting(buttons, f"{speed_text(clock.speed):>6} "):
        if name == "branches":
            draw_branches(workspace)
            imgui.same_line()
            continue
        action = BY_NAME[name]
        shown = icon or (icons.ICON_FA_PLAY if clock.paused else icons.ICON_FA_PAUSE)
        keys = f"   [{action.keys[0]}]"
        if button(f"time.{name}", shown, f"{action.title}{keys}\n{action.help}", enabled=action.enabled(workspace)):
            action.run(workspace)
        imgui.same_line()
        if name == "faster":
            imgui.text_disabled(f"{speed_text(clock.speed):>6} ")
            imgui.same_line()
    line = HintLine(hint, palette_of(workspace.theme))
    _draw_figures(workspace, line.least)
    line.draw()


def _fitting(buttons: list[tuple[str, str]], speed: str) -> list[tuple[str, str]]:
    """Those of the buttons that find room beside the time; `speed` stands behind "faster"."""
    style = imgui.get_style()
    room = imgui.get_content_region_avail().x - 4.0 * imgui.get_font_size()
    for names in LEAST_NEEDED:
        wide = [imgui.calc_text_size(icon or icons.ICON_FA_PAUSE).x + 2 * style.frame_padding.x for _, icon in buttons]
        wide += [imgui.calc_text_size(speed).x] if ("faster", icons.ICON_FA_PLUS) in buttons else []
        if sum(wide) + style.item_spacing.x * len(wide) <= room:
            break
        buttons = [one for one in buttons if one[0] not in names]
    return buttons


def _draw_figures(workspace: Workspace, room: float) -> None:
    """The time, the step and what is known ahead, as far as they leave `room` pixels to the hint."""
    timeline = workspace.session.timeline
    behind = timeline.length - timeline.step_count
    words = [f"{workspace.session.world.time:8.2f} s", f"step {timeline.step_count:,}"]
    words += [f"  {counted(behind, 'step')} known ahead"] if behind else []
    for number, text in enumerate(words):
        if imgui.calc_text_size(text).x > imgui.get_content_region_avail().x - room:
            break
        (imgui.text_disabled if number else imgui.text_unformatted)(text)
        imgui.same_line()
