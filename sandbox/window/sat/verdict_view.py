"""The verdict: what the engine says and what pymunk says, the way out, the runner-up and the margin between them."""

from __future__ import annotations

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.geometry.sat_rows import Vec
from sandbox.render.number_text import metres, point, short
from sandbox.render.sat_labels import headline
from sandbox.render.theme import Color
from sandbox.window.gui_style import Palette
from sandbox.window.overlay import packed_color
from sandbox.window.sat.colors import SatColors
from sandbox.window.sat.inspection import Inspection
from sandbox.window.sat.measure import scaled
from sandbox.window.widgets import mark, row

CARD, ROUNDING = 62.0, 6.0
NARROWEST = 108.0
"""Width of a card, in pixels at the usual size of text, below which the two stand above each other."""


def draw_verdict(seen: Inspection, palette: Palette, colors: SatColors) -> None:
    """Two cards beside each other, or above, and below them how the shapes get apart."""
    table, opinion = seen.table, seen.opinion
    contact = table.contact
    wide = imgui.get_content_region_avail().x
    spacing = imgui.get_style().item_spacing.x
    half = (wide - spacing) / 2
    across, down = half + spacing, 0.0
    if half < scaled(NARROWEST):
        half, across, down = wide, 0.0, scaled(CARD) + spacing
    corner = imgui.get_cursor_screen_pos()
    ours = None if contact is None else (contact.depth, contact.normal)
    _card(corner.x, corner.y, half, "sandbox", _said(ours, seen), _color(ours is not None, seen, colors), palette)
    if opinion.asked:
        theirs = None if opinion.depth is None or opinion.normal is None else (opinion.depth, opinion.normal)
        words = _said(theirs, None)
        color = _color(theirs is not None, seen, colors)
    else:
        words, color = ("not asked", ""), palette.faint
    _card(corner.x + across, corner.y + down, half, "pymunk", words, color, palette)
    sign = (corner.x + across - spacing / 2, corner.y + 15.0) if across else (corner.x + wide - 15.0, corner.y + down)
    _sign(*sign, opinion.same and opinion.asked, palette, colors)
    imgui.dummy(imgui.ImVec2(wide, scaled(CARD) + down))
    mark("sat.verdict", headline(table, seen.names))
    if opinion.remark:
        _wrapped(opinion.remark, colors.out if not opinion.same else palette.faint)
    if contact is not None:
        row(
            "way out",
            f"({short(contact.mtv[0])}, {short(contact.mtv[1])}) m",
            "Minimum translation vector of the second shape.",
        )
    second = table.runner_up
    if second is not None:
        margin = metres(seen.deciding.separation - second.separation)
        row("runner-up", f"axis {second.number}, {margin} more", "The next shortest way out, along any other line.")


def _said(answer: tuple[float, Vec] | None, seen: Inspection | None) -> tuple[str, str]:
    """Two lines: how deep and which way, or that they are apart."""
    if answer is not None:
        return f"overlap {metres(answer[0])}", f"normal {point((_rounded(answer[1][0]), _rounded(answer[1][1])))}"
    if seen is None:
        return "apart", "no contact"
    gap = seen.deciding.separation
    return (
        ("touching", "which is not colliding")
        if gap == 0.0
        else (f"gap {metres(gap)}", f"on axis {seen.deciding.number}")
    )


def _rounded(value: float) -> float:
    return round(value, 4) + 0.0


def _color(hit: bool, seen: Inspection, colors: SatColors) -> Color:
    return colors.out if hit else colors.gap


def _card(x: float, y: float, wide: float, name: str, words: tuple[str, str], color: Color, palette: Palette) -> None:
    pen, high = imgui.get_window_draw_list(), scaled(CARD)
    pen.add_rect_filled(
        imgui.ImVec2(x, y), imgui.ImVec2(x + wide, y + high), packed_color(palette.inset, 1.0), ROUNDING
    )
    pen.add_rect_filled(imgui.ImVec2(x, y + 6), imgui.ImVec2(x + 3, y + high - 6), packed_color(color, 1.0), 1.5)
    font = imgui.get_font()
    lines = ((name, palette.faint, 13.0, 6.0), (words[0], color, 15.5, 22.0), (words[1], palette.faint, 13.0, 41.0))
    pen.push_clip_rect(imgui.ImVec2(x, y), imgui.ImVec2(x + wide - 4, y + high), True)
    for text, ink, size, down in lines:
        pen.add_text(
            font, scaled(size), imgui.ImVec2(round(x + 11), round(y + scaled(down))), packed_color(ink, 1.0), text
        )
    pen.pop_clip_rect()


def _sign(x: float, y: float, same: bool, palette: Palette, colors: SatColors) -> None:
    """Whether the two say the same."""
    pen, color = imgui.get_window_draw_list(), colors.gap if same else colors.out
    pen.add_circle_filled(imgui.ImVec2(x, y), 12.0, packed_color(palette.panel, 1.0), 24)
    pen.add_circle_filled(imgui.ImVec2(x, y), 9.5, packed_color(color, 1.0), 24)
    text = icons.ICON_FA_CHECK if same else icons.ICON_FA_NOT_EQUAL
    size = imgui.calc_text_size(text)
    font = imgui.get_font()
    wide, high = size.x * 0.8, size.y * 0.8
    pen.add_text(
        font,
        imgui.get_font_size() * 0.8,
        imgui.ImVec2(x - wide / 2, y - high / 2),
        packed_color(palette.panel, 1.0),
        text,
    )


def _wrapped(words: str, color: Color) -> None:
    imgui.push_text_wrap_pos(0.0)
    imgui.push_style_color(imgui.Col_.text, imgui.ImVec4(*color, 1.0))
    imgui.text_unformatted(words)
    imgui.pop_style_color()
    imgui.pop_text_wrap_pos()
