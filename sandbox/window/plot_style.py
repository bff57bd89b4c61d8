"""How plots look: quiet frames, and lines in colours that are told apart, also by the colour-blind."""

from __future__ import annotations

from typing import Any

from imgui_bundle import imgui, implot

from sandbox.render.theme import DARK, Color, Theme, hex_color
from sandbox.window.gui_style import palette_of

_ON_DARK = tuple(
    map(hex_color, ("#6fb7ff", "#ffb454", "#7fd6a3", "#e58cc0", "#c9c1ff", "#f08a6c", "#8d97a3", "#5fd3d8"))
)
_ON_LIGHT = tuple(
    map(hex_color, ("#1f6fb2", "#b95f00", "#14805a", "#a8307a", "#5a4bb0", "#c03a1c", "#6a7480", "#007f88"))
)
"""Blue, orange, green, pink, violet, vermilion, grey, cyan, after Okabe and Ito: https://jfly.uni-koeln.de/color/"""
LINE_PIXELS = 1.8


def line_color(theme: Theme, number: int) -> Color:
    """The colour of the line of that number; -1 is that of the present."""
    colors = _ON_DARK if theme is DARK else _ON_LIGHT
    return palette_of(theme).accent if number < 0 else colors[number % len(colors)]


def line_look(theme: Theme, number: int) -> Any:
    """How ImPlot draws it."""
    look = implot.Spec()
    color = line_color(theme, number)
    look.line_color = look.fill_color = imgui.ImVec4(*color, 1.0)
    look.line_weight = 1.2 if number < 0 else LINE_PIXELS
    return look


def plot_style(theme: Theme) -> None:
    """Colours and measures of the plots that are drawn next."""
    colors, style = palette_of(theme), implot.get_style()
    for name, color, opacity in (
        ("frame_bg", colors.panel, 0.0), ("plot_bg", colors.inset, 1.0), ("plot_border", colors.line, 1.0),
        ("legend_bg", colors.inset, 0.75), ("legend_border", colors.line, 0.0), ("legend_text", colors.text, 1.0),
        ("title_text", colors.text, 1.0), ("axis_text", colors.faint, 1.0), ("axis_grid", colors.line, 0.8),
        ("axis_bg", colors.panel, 0.0), ("axis_bg_hovered", colors.panel, 0.0), ("axis_bg_active", colors.panel, 0.0),
    ):  # fmt: skip
        style.set_color_(getattr(implot.Col_, name), imgui.ImVec4(*color, opacity))
    style.plot_padding = imgui.ImVec2(4.0, 3.0)
    style.label_padding = imgui.ImVec2(3.0, 2.0)
    style.legend_inner_padding = imgui.ImVec2(3.0, 1.0)
    style.legend_padding = imgui.ImVec2(5.0, 3.0)
    style.minor_alpha = 0.0
