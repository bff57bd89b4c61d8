"""A section of a lesson as it is read: title, paragraphs, lists, and code on plates."""

from __future__ import annotations

from imgui_bundle import imgui

from sandbox.window.gui_style import palette_of
from sandbox.window.lessons.lesson import Block, Section
from sandbox.window.overlay import packed_color
from sandbox.window.sat.measure import scaled
from sandbox.window.workspace import Workspace

WIDEST = 760.0
"""Pixels that a line of words takes at most: longer ones are hard to read."""
TITLE, CODE = 20.0, 14.0


def draw_words(section: Section, name: str, workspace: Workspace) -> None:
    """All of a section, in a part of the panel that scrolls; `name` tells it from others."""
    imgui.begin_child(f"##{name}")
    imgui.push_text_wrap_pos(min(imgui.get_content_region_avail().x, scaled(WIDEST)))
    imgui.push_font(None, TITLE)
    imgui.text_unformatted(section.title)
    imgui.pop_font()
    for number, block in enumerate(section.blocks):
        imgui.dummy(imgui.ImVec2(0.0, scaled(2.0)))
        if block.kind == "code":
            _draw_code(workspace, block, number)
            continue
        if block.kind == "item":
            imgui.bullet()
            imgui.same_line()
        imgui.text_unformatted(block.text)
    imgui.pop_text_wrap_pos()
    imgui.end_child()


def _draw_code(workspace: Workspace, block: Block, number: int) -> None:
    """Lines of code on a plate; those that are too wide scroll."""
    fonts = imgui.get_io().fonts.fonts
    plain = max(block.text) < "\u0100"  # the font of code has no other letters
    imgui.push_font(fonts[len(fonts) - 1] if plain else None, CODE)
    padding, style = imgui.ImVec2(8.0, 6.0), imgui.get_style()
    wide = min(imgui.get_content_region_avail().x, scaled(WIDEST))
    size = imgui.calc_text_size(block.text)
    high = size.y + 2 * padding.y + (style.scrollbar_size if size.x + 2 * padding.x > wide else 0.0)
    imgui.push_style_color(imgui.Col_.child_bg, packed_color(palette_of(workspace.theme).inset, 1.0))
    imgui.push_style_var(imgui.StyleVar_.window_padding, padding)
    flags = imgui.WindowFlags_.horizontal_scrollbar | imgui.WindowFlags_.no_scroll_with_mouse
    shape = imgui.ChildFlags_.always_use_window_padding
    imgui.begin_child(f"##code {number}", imgui.ImVec2(wide, high + 2.0), shape, flags)
    imgui.text_unformatted(block.text)
    imgui.end_child()
    imgui.pop_style_var()
    imgui.pop_style_color()
    imgui.pop_font()
