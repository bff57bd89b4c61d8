"""Checks on what a function of the public API is given, each with a message that names the call and the mend."""

from __future__ import annotations

import math
from numbers import Integral
from typing import Any

from sandbox.errors import ArgumentError

MOST_WORKERS = 64
"""Threads that share the steps of a world."""


def checked_count(call: str, value: Any, what: str = "steps", least: int = 0, most: float = math.inf) -> int:
    """`value` as a whole number from `least` to `most`. Raises `ArgumentError`."""
    if type(value) is int and least <= value <= most:  # asking for an abstract type takes ten times as long
        return value
    if isinstance(value, bool) or not isinstance(value, Integral) or not least <= int(value) <= most:
        bounds = f"from {least}" if most == math.inf else f"from {least} to {most}"
        raise ArgumentError(f"{call}: takes a whole number of {what} {bounds}, not {shown(value)}")
    return int(value)


def check_kind(call: str, wanted: str, value: Any, *kinds: type[Any]) -> None:
    """Raise `ArgumentError` unless `value` is of one of `kinds`, which are called `wanted`."""
    if not isinstance(value, kinds):
        raise ArgumentError(f"{call}: takes {wanted}, not {shown(value)}")


def shown(value: Any, most: int = 60) -> str:
    """A value in a message: its repr, or what it is if that is long."""
    if isinstance(value, int) and value.bit_length() > 4 * most:
        return "a number of more than a hundred digits" if value.bit_length() > 340 else "a very large number"
    text = repr(value)
    return text if len(text) <= most else f"a {type(value).__name__}"
