"""What is said under the pointer."""

from __future__ import annotations

from imgui_bundle import imgui

WIDE_EMS = 36.0
"""Width of lines, in heights of the text, where the window has room for it."""


def tooltip(words: str) -> None:
    """Say it in this picture, over as many lines as it takes."""
    if not imgui.begin_tooltip():
        return
    margin = 2.0 * imgui.get_style().window_padding.x + imgui.get_font_size()
    imgui.push_text_wrap_pos(min(WIDE_EMS * imgui.get_font_size(), imgui.get_main_viewport().size.x - margin))
    imgui.text_unformatted(words)
    imgui.pop_text_wrap_pos()
    imgui.end_tooltip()
