"""Checks on what a function of the public API is given, each with a message that names the call and the mend."""

from __future__ import annotations

import math
import os
from contextlib import suppress
from numbers import Integral, Real
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


def check_path(call: str, value: Any) -> None:
    """Raise `ArgumentError` unless `value` may be the path of a file."""
    check_kind(call, "the path of a file", value, str, os.PathLike)


def check_callback(call: str, value: Any) -> None:
    """Raise `ArgumentError` unless `value` is None, or can be called with how many steps are done."""
    if value is not None and not callable(value):
        raise ArgumentError(f"{call}: on_steps takes a function of the number of steps, not {shown(value)}")


def checked_list(call: str, wanted: str, value: Any) -> list[Any]:
    """The entries of `value`, which is called `wanted`; a text alone is none. Raises `ArgumentError`."""
    try:
        if not isinstance(value, (str, bytes)):
            return list(value)
    except TypeError:  # an array without dimensions says that it could be gone through
        pass
    raise ArgumentError(f"{call}: takes {wanted}, not {shown(value)}")


def checked_number(call: str, what: str, value: Any, least: float, most: float = math.inf) -> float:
    """`value` as a float from `least` to `most`; `what` says of what. Raises `ArgumentError`."""
    number: Any = value if isinstance(value, Real) and not isinstance(value, bool) else math.nan
    if least <= number <= most:
        with suppress(OverflowError):
            return float(number)
    bounds = f"from {least:g}" if most == math.inf else f"from {least:g} to {most:g}"
    raise ArgumentError(f"{call}: {what} takes a number {bounds}, not {shown(value)}")


def shown(value: Any, most: int = 60) -> str:
    """A value in a message: its repr, or what it is if that is long."""
    if isinstance(value, int) and value.bit_length() > 4 * most:
        return "a number of more than a hundred digits" if value.bit_length() > 340 else "a very large number"
    text = repr(value)
    return text if len(text) <= most else f"a {type(value).__name__}"
