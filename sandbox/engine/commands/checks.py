"""What holds for the fields of every command: their types, and the sizes of their numbers."""

from __future__ import annotations

import math
import sys
from collections.abc import Collection, Iterator
from dataclasses import fields, replace
from functools import cache
from numbers import Integral, Real
from types import UnionType
from typing import Any, TypeVar, Union, get_args, get_origin, get_type_hints

import numpy as np

from sandbox.arguments import shown
from sandbox.engine.bodies.quarantine import MAX_COORDINATE
from sandbox.errors import CommandError

T = TypeVar("T")

SPEED_LIMIT = 1e6
"""Highest velocity a command may set or cause, in m/s or rad/s."""
GRAVITY_LIMIT = 1e6
"""Strongest gravity a command may set along an axis, in m/s^2."""
TIME_LIMIT = 1e9
"""Latest time of a path that a command may set, in s."""

AREAS = ("inside", "disc", "outline")
"""Fields that say where a region is."""
_PLACES = ("lower", "upper", "min", "max", "rest", "length")
"""Fields that say where a joint is to be, in m or rad."""
LIMITS = {
    **dict.fromkeys(("position", "angle", "point", "target", "radius", "pointer", *AREAS, *_PLACES), MAX_COORDINATE),
    **dict.fromkeys(("velocity", "angular_velocity", "speed"), SPEED_LIMIT),
    "gravity": GRAVITY_LIMIT,
    "value": 1.0,
    "time": TIME_LIMIT,
}
"""Largest size of a number, by the name of its field; the others may be as large as they like."""
_NOT_NEGATIVE = ("hertz", "damping_ratio", "strongest", "max_force", "time")
_IDS = ("body", "joint", "region", "name")
_WORDS = {float: "a number", int: "a whole number", bool: "True or False", str: "a text"}


def title(command: Any) -> str:
    """How messages begin: the command, and whom it is for."""
    for field in _IDS:
        if hasattr(command, field):
            return f"{type(command).__name__} of {shown(getattr(command, field))}"
    return type(command).__name__


def checked(command: T, unlimited: Collection[str] = ()) -> T:
    """A command with Python's own numbers inside.

    Raises `CommandError` unless all fields have their types, and every number is finite, or plus infinity in a field
    that is `unlimited`, and within the limit of its field.
    """
    kind: Any = type(command)
    floats = _made_plain(command, kind)
    if floats is not None:
        return replace(command, **floats) if floats else command  # type: ignore[type-var]
    plain: dict[str, Any] = {}
    for name, types in _types(kind).items():
        value = getattr(command, name)
        if (value is None and type(None) in types) or name in _IDS:  # ids are looked up, and refused, by the directory
            continue
        wanted = [one for one in types if one is not type(None)]
        fitting = next((one for one in wanted if _is(value, one)), None)
        if fitting is None:
            words = " or ".join(_told(one) for one in wanted)
            raise CommandError(f"{title(command)}: {name} must be {words}, not {shown(value)}")
        for number in _flat(value) if get_origin(fitting) is tuple else (value,):
            endless = name in unlimited and number == math.inf
            if isinstance(number, Real) and not isinstance(number, bool) and not endless:
                _check(command, name, number)
        plain[name] = _floats(value) if get_origin(fitting) is tuple else fitting(value)
    changed: Any = replace(command, **plain)  # type: ignore[type-var]
    return changed  # type: ignore[no-any-return]


def _made_plain(command: Any, kind: Any) -> dict[str, Any] | None:
    """The floats of those fields that have whole numbers of Python's, where a command has nothing but those, floats,
    pairs of both, and None, of sizes that are right: most have, and need no closer look. None: others may be right."""
    found: dict[str, Any] = {}
    for name, optional, pair, most in _plain_fields(kind):
        value = getattr(command, name)
        if value is None and optional:
            continue
        if pair and (type(value) is not tuple or len(value) != 2):
            return None
        for number in value if pair else (value,):
            if type(number) is not float:
                if type(number) is not int:
                    return None
                found[name] = value
            if not -most <= number <= most:
                return None
    return {name: _floats(value) if type(value) is tuple else float(value) for name, value in found.items()}


@cache
def _plain_fields(kind: Any) -> list[tuple[str, bool, bool, float]]:
    """The fields of a command but for ids: the name, whether it may be None, whether it is a pair of numbers, and the
    largest size, which is below zero where more than the size decides."""
    found = []
    for name, types in _types(kind).items():
        if name not in _IDS:
            pair = types[0] == tuple[float, float]
            plain = (pair or types[0] is float) and name not in _NOT_NEGATIVE
            most = min(LIMITS.get(name, math.inf), sys.float_info.max) if plain else -1.0
            found.append((name, type(None) in types, pair, most))
    return found


@cache
def _types(kind: Any) -> dict[str, tuple[Any, ...]]:
    """For each field of a command, the types that it may have."""
    hints = get_type_hints(kind)
    return {
        item.name: get_args(hint) if get_origin(hint) in (Union, UnionType) else (hint,)
        for item in fields(kind) for hint in (hints[item.name],)
    }  # fmt: skip


def _is(value: Any, kind: Any) -> bool:
    """Whether a value may stand for a type; NumPy's numbers, and lists and arrays for tuples, may."""
    if get_origin(kind) is tuple:
        if not isinstance(value, (tuple, list, np.ndarray)) or getattr(value, "shape", None) == ():
            return False  # an array without dimensions has no length
        parts = get_args(kind)
        wanted = [parts[0]] * len(value) if parts[-1] is Ellipsis else parts
        return len(value) == len(wanted) and all(map(_is, value, wanted))
    if kind is bool:
        return isinstance(value, (bool, np.bool_))
    if kind in (float, int):
        return isinstance(value, Real if kind is float else Integral) and not isinstance(value, bool)
    return isinstance(value, kind)


def _told(kind: Any) -> str:
    """A type in words."""
    if get_origin(kind) is not tuple:
        return _WORDS[kind]
    parts = get_args(kind)
    if parts[-1] is Ellipsis:
        return "a list of pairs of numbers"
    return "a pair of numbers (x, y)" if len(parts) == 2 else f"{len(parts)} numbers"


def _flat(value: Any) -> Iterator[Any]:
    """The numbers of a tuple, and of tuples in it."""
    for part in value:
        yield from (part,) if isinstance(part, Real) else _flat(part)


def _floats(value: Any) -> tuple[Any, ...]:
    return tuple(float(part) if isinstance(part, Real) else _floats(part) for part in value)


def _check(command: Any, field: str, number: Any) -> None:
    limit = LIMITS.get(field, math.inf)
    try:
        finite = math.isfinite(number)
    except OverflowError:  # a whole number that no float can hold
        raise CommandError(f"{title(command)}: {field} must be a number below 1.8e308") from None
    if not finite:
        raise CommandError(f"{title(command)}: {field} must be a finite number, not {number}")
    if abs(number) > limit:
        raise CommandError(f"{title(command)}: {field} of {number:g} is past the limit of {limit:g}")
    if field in _NOT_NEGATIVE and number < 0:
        raise CommandError(f"{title(command)}: {field} must not be negative")
