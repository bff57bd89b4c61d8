"""The tour through the test: back, on, and one sentence a step."""

from __future__ import annotations

from collections.abc import Sequence

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.render.number_text import counted
from sandbox.window.sat.focus import Focus
from sandbox.window.sat.tour import Step
from sandbox.window.widgets import button, mark
from sandbox.window.workspace import Workspace


def draw_tour(steps: Sequence[Step], focus: Focus, workspace: Workspace) -> None:
    """The buttons and the step that is told, or how to begin."""
    at = focus.step
    if at is None:
        if button(
            "sat.tour.start",
            f"{icons.ICON_FA_PLAY}  Tell it step by step",
            "Axes, projections, outcome, contact points.",
        ):
            focus.step, focus.free, focus.chosen = 0, None, None
            workspace.session.clock.paused = True
        imgui.same_line()
        imgui.text_disabled(counted(len(steps), "step"))
        return
    at = focus.step = min(at, len(steps) - 1)
    if button("sat.tour.back", icons.ICON_FA_ARROW_LEFT, "The step before", enabled=at > 0):
        focus.step = at - 1
    imgui.same_line()
    if button("sat.tour.next", icons.ICON_FA_ARROW_RIGHT, "The next step", enabled=at < len(steps) - 1):
        focus.step = at + 1
    imgui.same_line()
    imgui.align_text_to_frame_padding()
    imgui.text_disabled(f"{at + 1} of {len(steps)}")
    imgui.same_line()
    if button("sat.tour.end", icons.ICON_FA_XMARK, "Back to the whole"):
        focus.step = None
    step = steps[at]
    imgui.push_text_wrap_pos(0.0)
    imgui.text_unformatted(step.title)
    imgui.text_disabled(step.text)
    imgui.pop_text_wrap_pos()
    mark("sat.tour.text")
