"""Colours as an author names them: `#3a7bd5`, or a name of CSS such as `tomato`."""

from __future__ import annotations

import re
from functools import cache

from sandbox.scene.near_names import did_you_mean

_HEX = re.compile(r"#[0-9a-fA-F]{6}")
COLOR_PATTERN = f"^({_HEX.pattern}|[a-z]+)$"


@cache
def named_colors() -> dict[str, str]:
    """The 148 names of CSS (https://www.w3.org/TR/css-color-4/#named-colors), each with its `#rrggbb`."""
    from PIL.ImageColor import colormap

    return {name: str(value) for name, value in colormap.items()}


def hex_color(color: str) -> str:
    """A colour as `#rrggbb`."""
    return color if color.startswith("#") else named_colors()[color]


def color_fault(color: str) -> str:
    """What is wrong with a colour; empty if nothing is."""
    if _HEX.fullmatch(color) or color in named_colors():
        return ""
    near = "" if color.startswith("#") else did_you_mean(color, named_colors())
    return 'must be a colour such as "#3a7bd5" or "tomato"' + (f": {near}" if near else "")
