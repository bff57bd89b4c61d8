"""What is wrong with a file, over the scene that was read last."""

from __future__ import annotations

import re
import textwrap

from imgui_bundle import imgui

from sandbox.window.gui_style import palette_of
from sandbox.window.widgets import button, mark, wrapped
from sandbox.window.workspace import Workspace

MARGIN, WIDEST, MOST_SHARE = 14.0, 760.0, 0.6
"""Pixels around it and its greatest width, and the most that it takes of the height."""
_EXCERPT = re.compile(r" *\d* \|")
"""How lines begin that show the file: what stands below each other in them belongs together."""
NOT_READ = "The file has a mistake; what you see is how it was before.", "Mend it and save: it is read again by itself."
NOT_OPENED = "That could not be opened; what was there goes on.", ""
"""What is told above the mistake and below it."""
AGAIN = "It is shown again when the file changes and is still wrong."
FLAGS = (
    imgui.WindowFlags_.no_docking
    | imgui.WindowFlags_.no_saved_settings
    | imgui.WindowFlags_.no_decoration
    | imgui.WindowFlags_.always_auto_resize
)


def draw_problem(workspace: Workspace, words: tuple[str, str], problem: str, mono: object) -> bool:
    """The lines of an error, with their excerpts in the font `mono`. True once the user has read enough of it."""
    left, top, width, height = workspace.viewport.rect
    wide = min(WIDEST, width - 2 * MARGIN)
    imgui.set_next_window_pos(
        imgui.ImVec2(left + MARGIN, top + height - MARGIN), imgui.Cond_.always, imgui.ImVec2(0.0, 1.0)
    )
    imgui.set_next_window_size_constraints(imgui.ImVec2(wide, 40.0), imgui.ImVec2(wide, height * MOST_SHARE))
    imgui.begin("##problem", None, FLAGS)
    colors = palette_of(workspace.theme)
    imgui.push_style_color(imgui.Col_.text, imgui.ImVec4(*colors.accent, 1.0))
    imgui.text_unformatted(words[0])
    imgui.pop_style_color()
    imgui.push_font(mono, 0.0)  # type: ignore[arg-type]
    columns = int((wide - 3 * MARGIN) / imgui.calc_text_size("0").x)
    lines = [part for text in problem.splitlines() for part in broken(text, columns)]
    line = imgui.get_text_line_height() + 1.0
    rest = 3.0 * imgui.get_frame_height_with_spacing()
    size = imgui.ImVec2(0.0, min(height * MOST_SHARE - rest, line * (len(lines) + 1.0)))
    imgui.begin_child("lines", size, imgui.ChildFlags_.none, imgui.WindowFlags_.horizontal_scrollbar)
    imgui.push_style_var(imgui.StyleVar_.item_spacing, imgui.ImVec2(0.0, 1.0))
    for text in lines:
        imgui.text_unformatted(text)
    imgui.pop_style_var()
    imgui.end_child()
    imgui.pop_font()
    closed = button("problem.close", "Close", AGAIN if words[1] else "")
    if words[1]:
        imgui.same_line()
        wrapped(words[1])
    mark("problem")
    imgui.end()
    return closed


def broken(text: str, columns: int) -> list[str]:
    """A line of the message, between its words, in lines of so many letters at most; one of the file stays whole."""
    return [text] if _EXCERPT.match(text) else textwrap.wrap(text, max(columns, 20)) or [""]
