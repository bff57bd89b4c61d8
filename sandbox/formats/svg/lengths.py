"""Lengths of SVG in pixels of CSS, of which 96 make an inch."""

from __future__ import annotations

import re

_LENGTH = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([a-zA-Z%]*)\s*")
_UNITS = {
    "": 1.0, "px": 1.0, "pt": 96 / 72, "pc": 16.0, "in": 96.0, "cm": 96 / 2.54, "mm": 96 / 25.4, "q": 96 / 101.6,
    "em": 16.0, "rem": 16.0, "ex": 8.0,
}  # fmt: skip


def length(text: str, whole: float = 0.0, default: float = 0.0) -> float:
    """A length in pixels; `whole` is what 100 % are. The default if it is none."""
    match = _LENGTH.fullmatch(text)
    if match is None:
        return default
    number, unit = float(match[1]), match[2].lower()
    if unit == "%":
        return number / 100.0 * whole if whole else default
    return number * _UNITS[unit] if unit in _UNITS and abs(number) < 1e12 else default


def numbers(text: str) -> list[float]:
    """The numbers of a list, such as `points` or `viewBox`."""
    found = re.findall(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", text)
    return [float(each) for each in found if abs(float(each)) < 1e12]
