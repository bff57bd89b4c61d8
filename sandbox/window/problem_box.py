"""What is wrong with the file on disk, over the scene that was read last."""

from __future__ import annotations

from imgui_bundle import imgui

from sandbox.window.gui_style import palette_of
from sandbox.window.widgets import button, mark, wrapped
from sandbox.window.workspace import Workspace

MARGIN, WIDEST = 14.0, 760.0
FLAGS = (
    imgui.WindowFlags_.no_docking
    | imgui.WindowFlags_.no_saved_settings
    | imgui.WindowFlags_.no_decoration
    | imgui.WindowFlags_.always_auto_resize
)


def draw_problem(workspace: Workspace, problem: str, mono: object) -> bool:
    """The lines of an error, with their excerpts in the font `mono`. True once the user has read enough of it."""
    left, top, width, height = workspace.viewport.rect
    wide = min(WIDEST, width - 2 * MARGIN)
    imgui.set_next_window_pos(
        imgui.ImVec2(left + MARGIN, top + height - MARGIN), imgui.Cond_.always, imgui.ImVec2(0.0, 1.0)
    )
    imgui.set_next_window_size_constraints(imgui.ImVec2(wide, 40.0), imgui.ImVec2(wide, height * 0.6))
    imgui.begin("##problem", None, FLAGS)
    colors = palette_of(workspace.theme)
    imgui.push_style_color(imgui.Col_.text, imgui.ImVec4(*colors.accent, 1.0))
    imgui.text_unformatted("The file has a mistake; what you see is how it was before.")
    imgui.pop_style_color()
    imgui.push_font(mono, 0.0)  # type: ignore[arg-type]
    imgui.push_text_wrap_pos(0.0)
    imgui.text_unformatted(problem)
    imgui.pop_text_wrap_pos()
    imgui.pop_font()
    closed = button("problem.close", "Close", "It is shown again when the file changes and is still wrong.")
    imgui.same_line()
    wrapped("Mend it and save: it is read again by itself.")
    mark("problem")
    imgui.end()
    return closed
