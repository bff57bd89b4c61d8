"""How panels look: ImGui's colours and measures, to go with the theme of the scene."""

from __future__ import annotations

from dataclasses import dataclass

from imgui_bundle import imgui, implot

from sandbox.render.theme import DARK, Color, Theme, hex_color


@dataclass(frozen=True)
class Palette:
    """Colours of panels and of what is written over the scene."""

    panel: Color
    inset: Color
    raised: Color
    hovered: Color
    line: Color
    text: Color
    faint: Color
    accent: Color
    """What is on, chosen or running."""
    on_accent: Color
    second: Color
    """The second of two things that are told apart by colour."""


ON_DARK = Palette(
    panel=hex_color("#171b22"), inset=hex_color("#0f1217"), raised=hex_color("#252c37"), hovered=hex_color("#323b49"),
    line=hex_color("#2a313d"), text=hex_color("#e6eaf1"), faint=hex_color("#8e99aa"), accent=hex_color("#ffd479"),
    on_accent=hex_color("#1b1608"), second=hex_color("#6fb7ff"),
)  # fmt: skip
ON_LIGHT = Palette(
    panel=hex_color("#ffffff"), inset=hex_color("#f2f0ea"), raised=hex_color("#e9e6dd"), hovered=hex_color("#dcd8cb"),
    line=hex_color("#d9d5c8"), text=hex_color("#20242c"), faint=hex_color("#6c7382"), accent=hex_color("#b06a00"),
    on_accent=hex_color("#fff8e8"), second=hex_color("#1f6fb2"),
)  # fmt: skip


def palette_of(theme: Theme) -> Palette:
    """The colours of panels beside a scene in `theme`."""
    return ON_DARK if theme is DARK else ON_LIGHT


def apply_style(theme: Theme, text_scale: float = 1.0) -> None:
    """Make all panels look as they are to look beside a scene in `theme`, text `text_scale` times as large."""
    colors, style = palette_of(theme), imgui.get_style()
    (imgui.style_colors_dark if theme is DARK else imgui.style_colors_light)()
    (implot.style_colors_dark if theme is DARK else implot.style_colors_light)()
    style.font_scale_main = text_scale
    room = max(text_scale, 1.0) ** 0.5  # around large text, but not so much that little is left for it
    style.window_padding = imgui.ImVec2(10.0 * room, 8.0 * room)
    style.frame_padding = imgui.ImVec2(7.0 * room, 4.0 * room)
    style.item_spacing = imgui.ImVec2(7.0 * room, 5.0 * room)
    style.window_border_size = style.popup_border_size = 1.0
    style.frame_rounding = style.grab_rounding = style.popup_rounding = 5.0
    style.window_rounding = style.child_rounding = 7.0
    style.tab_rounding = 5.0
    style.tab_min_width_shrink = 44.0 * text_scale  # an icon and a letter or two, before tabs are scrolled away
    style.tab_bar_border_size = 1.0
    style.scrollbar_size, style.scrollbar_rounding = 10.0, 5.0
    style.docking_separator_size = 1.0
    style.window_menu_button_position = imgui.Dir.none
    for names, color, opacity in _paints(colors):
        for name in names.split():
            style.set_color_(getattr(imgui.Col_, name), imgui.ImVec4(*color, opacity))


def _paints(colors: Palette) -> tuple[tuple[str, Color, float], ...]:
    return (
        ("window_bg popup_bg menu_bar_bg title_bg title_bg_active title_bg_collapsed", colors.panel, 1.0),
        ("child_bg docking_empty_bg scrollbar_bg modal_window_dim_bg", colors.panel, 0.0),
        ("frame_bg checkbox_selected_bg", colors.inset, 1.0),
        ("button header tab_selected tab_dimmed_selected scrollbar_grab", colors.raised, 1.0),
        ("button_hovered header_hovered frame_bg_hovered frame_bg_active tab_hovered scrollbar_grab_hovered "
         "separator_hovered resize_grip_hovered", colors.hovered, 1.0),
        ("tab tab_dimmed", colors.panel, 1.0),
        ("button_active header_active check_mark slider_grab slider_grab_active separator_active resize_grip_active "
         "tab_selected_overline scrollbar_grab_active docking_preview nav_cursor", colors.accent, 0.75),
        ("border separator table_border_light table_border_strong tab_dimmed_selected_overline", colors.line, 1.0),
        ("table_header_bg", colors.inset, 1.0),
        ("table_row_bg_alt", colors.raised, 0.25),
        ("text", colors.text, 1.0),
        ("text_disabled", colors.faint, 1.0),
        ("text_selected_bg", colors.accent, 0.3),
        ("resize_grip", colors.line, 0.0),
    )  # fmt: skip
