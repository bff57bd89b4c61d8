"""The question at a start whether to go on with a session that ended without a goodbye."""

from __future__ import annotations

from imgui_bundle import imgui

from sandbox.render.camera import Size
from sandbox.render.number_text import counted
from sandbox.window.leftover import Leftover
from sandbox.window.time_bar import time_bar_height
from sandbox.window.widgets import button

FLAGS = (
    imgui.WindowFlags_.no_docking
    | imgui.WindowFlags_.no_saved_settings
    | imgui.WindowFlags_.no_decoration
    | imgui.WindowFlags_.always_auto_resize
)
GAP = 12.0
"""Pixels."""


def draw_offer(leftover: Leftover, size: Size) -> bool | None:
    """Over the time bar of a window of `size` pixels; notes are at the top.

    True to go on with it, False to forget it, None as yet undecided.
    """
    place = imgui.ImVec2(size[0] / 2, size[1] - time_bar_height() - GAP)
    imgui.set_next_window_pos(place, imgui.Cond_.always, imgui.ImVec2(0.5, 1.0))
    imgui.begin("##offer", None, FLAGS)
    title = leftover.title or leftover.scene.source
    done = f"{counted(leftover.steps, 'step')}, {counted(len(leftover.commands), 'command')}"
    imgui.text_unformatted(f"A session was cut off: {title}")
    imgui.text_disabled(done)
    answer: bool | None = None
    if button("offer.restore", "Go on with it", "The scene, all that was done, and all of it to be undone."):
        answer = True
    imgui.same_line()
    if button("offer.discard", "Forget it", "It is deleted for good."):
        answer = False
    imgui.end()
    return answer
