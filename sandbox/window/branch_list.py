"""The futures that were left for another one: a button with how many there are, and the list that it opens."""

from __future__ import annotations

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.replay.moment import Future
from sandbox.window.widgets import button, mark
from sandbox.window.workspace import Workspace

TIP = "Futures that you left for another one. Choose one to go to where it parts from this; Ctrl+Z leads back."


def branch_icon(workspace: Workspace) -> str:
    """What stands on the button."""
    return f"{icons.ICON_FA_CODE_BRANCH} {len(workspace.session.timeline.branches)}"


def draw_branches(workspace: Workspace) -> None:
    """The button, and while it is open the list, the latest first."""
    if button("time.branches", branch_icon(workspace), TIP):
        imgui.open_popup("branches")
    place = imgui.get_item_rect_min()
    imgui.set_next_window_pos(imgui.ImVec2(place.x, place.y - 4.0), imgui.Cond_.always, imgui.ImVec2(0.0, 1.0))
    if imgui.begin_popup("branches"):
        imgui.text_disabled("other futures")
        branches = workspace.session.timeline.branches
        for number in reversed(range(len(branches))):
            chosen, _ = imgui.menu_item(
                f"{told(branches[number])}##{number}", _parts(workspace, branches[number]), False
            )
            mark(f"branch.{number}")
            if chosen:
                workspace.session.switch(number)
        imgui.end_popup()


def told(branch: Future) -> str:
    """What was done last in a future."""
    return branch.label or "nothing done"


def _parts(workspace: Workspace, branch: Future) -> str:
    """From where to where it is another one, in seconds."""
    seconds = float(workspace.session.world.state.settings[0].step_seconds)
    start = workspace.session.timeline.parts_from(branch)
    return f"{seconds * (start or 0):.2f} to {seconds * branch.length:.2f} s"
