"""How elements are painted: presentation attributes, `style`, and style sheets of simple selectors.

Source: SVG 2, chapter 6 "Styling".
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from PIL import ImageColor

from sandbox.formats.svg.sheet import Sheet, Style, declarations
from sandbox.formats.xml_tree import Element

_INHERITED = ("fill", "stroke", "stroke-width", "fill-rule", "visibility", "color", "fill-opacity", "stroke-opacity")
_OWN = ("display", "clip-path", "mask", "opacity", "transform", "transform-origin")
_START = {"fill": "black", "stroke": "none", "stroke-width": "1", "fill-rule": "nonzero", "visibility": "visible"}


def style_of(element: Element, sheet: Sheet, parent: Style | None = None, around: Sequence[Element] = ()) -> Style:
    """The style of an element, with what it inherits."""
    style = dict(_START) if parent is None else {key: parent[key] for key in _INHERITED if key in parent}
    given = {key: element.get(key) for key in (*_INHERITED, *_OWN) if element.get(key)}
    given |= sheet.of(element, around)
    given |= declarations(element.get("style"))
    return style | {key: value for key, value in given.items() if key in (*_INHERITED, *_OWN) and value != "inherit"}


def is_painted(style: Style, what: str) -> bool:
    """Whether "fill" or "stroke" shows."""
    return style.get(what) not in ("none", "transparent") and not _is_clear(style.get(f"{what}-opacity", ""))


def is_hidden(style: Style) -> bool:
    """Whether nothing of an element shows, nor of what is in it."""
    return style.get("display") == "none" or _is_clear(style.get("opacity", ""))


def _is_clear(opacity: str) -> bool:
    return re.fullmatch(r"\+?0*\.?0*%?", opacity) is not None and "0" in opacity


def colour_of(style: Style) -> str:
    """The colour of the filling as a scene has it, "" if it is no plain one."""
    text = style.get("fill", "")
    if text == "currentColor":
        text = style.get("color", "")
    try:
        red, green, blue = ImageColor.getrgb(text)[:3]
    except ValueError:
        return ""
    return f"#{red:02x}{green:02x}{blue:02x}"
