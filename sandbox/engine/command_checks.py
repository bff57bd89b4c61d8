"""What holds for the numbers of every command."""

from __future__ import annotations

import math
from dataclasses import fields
from numbers import Real
from typing import Any

from sandbox.engine.guard import MAX_COORDINATE
from sandbox.engine.pushes import SPEED_LIMIT
from sandbox.errors import CommandError

GRAVITY_LIMIT = 1e6
"""Strongest gravity a command may set along an axis, in m/s^2."""

_LIMITS = {
    **dict.fromkeys(("position", "angle", "point", "target", "radius"), MAX_COORDINATE),
    **dict.fromkeys(("velocity", "angular_velocity", "speed"), SPEED_LIMIT),
    "gravity": GRAVITY_LIMIT,
}
"""Largest size of a number, by the name of its field; the others may be as large as they like."""
_NOT_NEGATIVE = ("hertz", "damping_ratio", "strongest")


def title(command: Any) -> str:
    """How messages begin: the command, and whom it is for."""
    for field in ("body", "joint", "region"):
        if hasattr(command, field):
            return f"{type(command).__name__} of {getattr(command, field)!r}"
    return type(command).__name__


def check_numbers(command: Any) -> None:
    """Raise `CommandError` unless every number of a command is finite and within the limit of its field."""
    for item in fields(command):
        value = getattr(command, item.name)
        for number in value if isinstance(value, tuple) else (value,):
            if isinstance(number, Real) and not isinstance(number, bool):
                _check(command, item.name, number)


def _check(command: Any, field: str, number: Any) -> None:
    limit = _LIMITS.get(field, math.inf)
    if not math.isfinite(number):
        raise CommandError(f"{title(command)}: {field} must be a finite number, not {number}")
    if abs(number) > limit:
        raise CommandError(f"{title(command)}: {field} of {number:g} is past the limit of {limit:g}")
    if field in _NOT_NEGATIVE and number < 0:
        raise CommandError(f"{title(command)}: {field} must not be negative")
