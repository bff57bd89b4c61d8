"""Widgets with a name, a tooltip and units, in one look. Their places are known, so that scripts can click them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from imgui_bundle import imgui

from sandbox.window.tooltip import tooltip

Box = tuple[float, float, float, float]
"""Left, top, right, bottom in pixels of the window."""

LABEL_EMS = 8.0
"""Width of the left column of rows, in heights of the text."""
NARROW_EMS = 14.0
"""Where there is less room than that, names stand above what they name instead of left of it."""
LEAST_DIGITS = 2
BESIDE, PAIR_GAP = 12.0, 7.0
"""Pixels of a field that its number leaves free, and between two fields of one pair, which are told apart so."""
DECIMALS = {"m": 4, "m/s": 3, "m/s²": 3, "°": 2, "°/s": 2}
"""Decimals that a person makes something of, by unit; finer ones are rounding, and flicker."""
EXACT = imgui.SliderFlags_.no_round_to_format

places: dict[str, Box] = {}
"""Where each widget of the last picture lies, by name."""
hidden: set[str] = set()
"""Those of them that are scrolled out of sight, where a click would go to something else."""
_pressed: set[str] = set()
"""Widgets that were pressed, until the pointer leaves them."""


def begin_picture() -> None:
    """Forget where the widgets of the picture before were."""
    places.clear()
    hidden.clear()


def mark(name: str, tip: str = "") -> None:
    """Note the place of the widget drawn last, and give it a tooltip, which a press closes until the pointer leaves."""
    low, high = imgui.get_item_rect_min(), imgui.get_item_rect_max()
    places[name] = (low.x, low.y, high.x, high.y)
    if not imgui.is_item_visible():
        hidden.add(name)
    if imgui.is_item_active():
        _pressed.add(name)
    elif name in _pressed and not imgui.is_item_hovered(imgui.HoveredFlags_.allow_when_disabled):
        _pressed.discard(name)
    if not tip or name in _pressed:
        return
    if imgui.is_item_hovered(imgui.HoveredFlags_.for_tooltip | imgui.HoveredFlags_.allow_when_disabled):
        tooltip(tip)


def button(name: str, label: str, tip: str = "", *, on: bool = False, enabled: bool = True, width: float = 0.0) -> bool:
    """A button; `on` shows it lit. True in the picture in which it is clicked."""
    if on:
        lit = imgui.get_style_color_vec4(imgui.Col_.button_active)
        imgui.push_style_color(imgui.Col_.button, lit)
        imgui.push_style_color(imgui.Col_.button_hovered, lit)
        imgui.push_style_color(imgui.Col_.text, lit_ink())
    imgui.begin_disabled(not enabled)
    clicked = imgui.button(f"{label}##{name}", imgui.ImVec2(width, 0.0))
    imgui.end_disabled()
    if on:
        imgui.pop_style_color(3)
    mark(name, tip)
    return bool(clicked)


def lit_ink() -> imgui.ImVec4:
    """What is written on something lit, which is bright in any theme: the darker of text and ground."""
    colors = [imgui.get_style_color_vec4(one) for one in (imgui.Col_.text, imgui.Col_.window_bg)]
    return min(colors, key=lambda color: color.x + color.y + color.z)


def checkbox(name: str, label: str, value: bool, tip: str = "") -> bool:
    """A box to tick, with an edge, so that it is seen empty as well; gives what it is now."""
    edge = imgui.get_style_color_vec4(imgui.Col_.text_disabled)
    imgui.push_style_color(imgui.Col_.border, imgui.ImVec4(edge.x, edge.y, edge.z, 0.5))
    imgui.push_style_var(imgui.StyleVar_.frame_border_size, 1.0)
    _, value = imgui.checkbox(f"{label}##{name}", value)
    imgui.pop_style_var()
    imgui.pop_style_color()
    mark(name, tip)
    return bool(value)


@dataclass(frozen=True)
class Scale:
    """How a number is shown and dragged: its unit, how much a pixel changes it, its limits, how many digits.

    `mixed` says that there are several, of which the one given is the first.
    """

    unit: str = ""
    speed: float = 0.01
    low: float = 0.0
    high: float = 0.0
    digits: int = 4
    mixed: bool = False

    def shown(self, value: float) -> float:
        """A number as it is shown: to the decimals of its unit."""
        return round(float(value), DECIMALS.get(self.unit, 5)) + 0.0 if math.isfinite(value) else float(value)

    def format(self, values: Sequence[float], width: float) -> tuple[str, int]:
        """As ImGui takes it, with as many digits, and then the unit, as find room in `width` pixels, and whether drags
        round to that: only to all digits.
        """
        if self.mixed:
            return "mixed", 0
        for unit in (self.unit, ""):
            for digits in range(self.digits, LEAST_DIGITS - 1, -1):
                texts = [f"{value:.{digits}g} {unit}".rstrip() for value in values]
                if max(imgui.calc_text_size(text).x for text in texts) <= width - BESIDE:
                    return f"%.{digits}g {unit}".rstrip(), 0 if digits == self.digits else EXACT
        return f"%.{LEAST_DIGITS}g", EXACT


PLAIN = Scale()


def drag(name: str, label: str, value: float, tip: str = "", scale: Scale = PLAIN) -> tuple[bool, float]:
    """A number that is dragged or typed, with its unit. (changed, number)."""
    shown, flags = scale.format([value], imgui.calc_item_width())
    changed, got = imgui.drag_float(f"{label}##{name}", value, scale.speed, scale.low, scale.high, shown, flags)
    mark(name, tip)
    return bool(changed), as_written(value, got)


def drag2(
    name: str, label: str, value: tuple[float, float], tip: str = "", scale: Scale = PLAIN
) -> tuple[bool, tuple[float, float]]:
    """Two numbers beside each other, NAME.x and NAME.y. (changed, numbers)."""
    wide = f"{label}##{name}"
    imgui.push_style_var(imgui.StyleVar_.item_inner_spacing, imgui.ImVec2(PAIR_GAP, 0.0))
    each = 0.5 * (imgui.calc_item_width() - imgui.get_style().item_inner_spacing.x)
    shown, flags = scale.format(value, each)
    changed, got = imgui.drag_float2(wide, list(value), scale.speed, scale.low, scale.high, shown, flags)
    imgui.pop_style_var()
    mark(name, tip)
    left, top, right, bottom = places[name]
    middle = 0.5 * (left + right)
    places[f"{name}.x"], places[f"{name}.y"] = (left, top, middle, bottom), (middle, top, right, bottom)
    return bool(changed), (as_written(value[0], got[0]), as_written(value[1], got[1]))


def as_written(before: float, got: float) -> float:
    """The number that was meant by one of ImGui's, which have 32 bits: 0.3 and not 0.300000012, and to the last bit
    what was there `before` if it is still that.
    """
    return before if np.float32(before) == np.float32(got) else float(str(np.float32(got)))


def integer(
    name: str, label: str, value: int, tip: str = "", *, limits: tuple[int, int] = (0, 0), shown: str = "%d"
) -> tuple[bool, int]:
    """A whole number that is dragged or typed, `shown` in C's format. (changed, number)."""
    changed, value = imgui.drag_int(f"{label}##{name}", value, 0.05, limits[0], limits[1], shown)
    mark(name, tip)
    return bool(changed), int(value)


def text(name: str, label: str, value: str, hint: str = "", at_end: bool = False) -> str:
    """A line of text to type; gives what it is now. With `at_end`, what is typed next comes behind what is there."""
    flags, place = (imgui.InputTextFlags_.callback_always, _to_end) if at_end else (0, None)
    _, value = imgui.input_text_with_hint(f"{label}##{name}", hint, value, flags, place)
    mark(name)
    return str(value)


def _to_end(data: imgui.InputTextCallbackData) -> int:
    """Put the cursor behind the text, with nothing selected, as it all is when a field is entered by program."""
    data.clear_selection()
    data.cursor_pos = data.buf_text_len
    return 0


def choice(name: str, label: str, value: str, options: Sequence[str], tip: str = "") -> str:
    """One of several words; gives what is chosen now."""
    at = options.index(value) if value in options else 0
    _, at = imgui.combo(f"{label}##{name}", at, list(options))
    mark(name, tip)
    return options[at]


def section(label: str) -> bool:
    """A heading that opens and closes what comes below it; open at first."""
    return bool(imgui.collapsing_header(label, imgui.TreeNodeFlags_.default_open))


def is_narrow() -> bool:
    """Whether the panel that is drawn has no room for two columns."""
    return bool(imgui.get_window_width() < NARROW_EMS * imgui.get_font_size())


def same_line_if_fits(label: str) -> None:
    """What comes next is a button with a label; it stands beside the last one if there is room."""
    style = imgui.get_style()
    wide = imgui.calc_text_size(label).x + 2 * style.frame_padding.x
    right = imgui.get_window_pos().x + imgui.get_window_width() - style.window_padding.x
    if imgui.get_item_rect_max().x + style.item_spacing.x + wide <= right:
        imgui.same_line()


def label(words: str, tip: str = "") -> None:
    """The name of the widget that comes next, which fills the rest of the line."""
    imgui.align_text_to_frame_padding()
    imgui.text_disabled(words)
    if tip and imgui.is_item_hovered():
        tooltip(tip)
    if not is_narrow():
        imgui.same_line(imgui.get_font_size() * LABEL_EMS)
    imgui.set_next_item_width(-1.0)


def progress_bar(name: str, share: float, tip: str = "", width: float = -1.0) -> None:
    """A bar of which `share` (0 to 1) is full; `width` in pixels, or the rest of the line."""
    imgui.push_style_color(imgui.Col_.plot_histogram, imgui.get_style_color_vec4(imgui.Col_.check_mark))
    imgui.progress_bar(share, imgui.ImVec2(width, imgui.get_font_size() * 0.6), "")
    imgui.pop_style_color()
    mark(name, tip)


def row(label: str, value: str, tip: str = "") -> None:
    """A name and what it is, in two columns."""
    imgui.text_disabled(label)
    if is_narrow():
        imgui.same_line()
    else:
        imgui.same_line(imgui.get_font_size() * LABEL_EMS)
    imgui.push_text_wrap_pos(0.0)
    imgui.text_unformatted(value)
    imgui.pop_text_wrap_pos()
    if tip and imgui.is_item_hovered():
        tooltip(tip)


def wrapped(words: str) -> None:
    """A paragraph in the quiet colour."""
    imgui.push_text_wrap_pos(0.0)
    imgui.push_style_color(imgui.Col_.text, imgui.get_style_color_vec4(imgui.Col_.text_disabled))
    imgui.text_unformatted(words)
    imgui.pop_style_color()
    imgui.pop_text_wrap_pos()
