"""What one parameter of a sweep goes through: a range of numbers, a range of whole numbers, or a list."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from numbers import Integral, Real
from typing import Any, TypeAlias

from sandbox.arguments import shown
from sandbox.errors import ArgumentError
from sandbox.scene.splitmix import SplitMix64

Value: TypeAlias = float | int | str | bool
MOST_LEVELS = 1_000_000
"""Values of one parameter."""
_LEAST, _MOST = -(2**63), 2**63 - 1
"""Whole numbers that a column of a table has room for."""
_WHOLE = re.compile(r"[+-]?\d{1,18}")
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d{1,3})?")


@dataclass(frozen=True)
class Between:
    """Numbers from `low` to `high`, both included: `count` of them in a grid."""

    low: Fraction
    high: Fraction
    count: int | None

    def __len__(self) -> int:
        return self.count or 0

    def at(self, index: int) -> Value:
        """One of the `count` numbers, each the nearest double to its exact place: 0.1:0.9:9 has 0.3 in it."""
        assert self.count is not None
        share = Fraction(index, self.count - 1) if self.count > 1 else Fraction(0)
        return float(self.low + (self.high - self.low) * share)

    def drawn(self, random: SplitMix64) -> Value:
        """A random number, evenly spread."""
        return random.between(float(self.low), float(self.high))


@dataclass(frozen=True)
class Whole:
    """Whole numbers from `low` to `high`, both included."""

    low: int
    high: int

    def __len__(self) -> int:
        return self.high - self.low + 1

    def at(self, index: int) -> Value:
        """One of them, in order."""
        return self.low + index

    def drawn(self, random: SplitMix64) -> Value:
        """One of them at random."""
        return self.low + random.next_bits() % len(self)  # of 2^64: what is left over is 1 in 10^12


@dataclass(frozen=True)
class Listed:
    """Values one by one."""

    values: tuple[Value, ...]

    def __len__(self) -> int:
        return len(self.values)

    def at(self, index: int) -> Value:
        """One of them, in order."""
        return self.values[index]

    def drawn(self, random: SplitMix64) -> Value:
        """One of them at random."""
        return self.values[random.next_bits() % len(self.values)]


Levels: TypeAlias = Between | Whole | Listed


def levels_of(path: str, given: Any, drawn: bool = False) -> Levels:
    """The levels that a text (`LOW:HIGH:COUNT`, `LOW:HIGH`, `a,b,c`) or a sequence of values stands for.

    `drawn`: they are for a random sample, so that numbers need no COUNT. Raises `ArgumentError` that names `path`.
    """
    if isinstance(given, str):
        found = _read(path, given)
    else:
        found = Listed(tuple(_plain(path, value) for value in _several(path, given)))
    if isinstance(found, Between) and found.count is None and not drawn:
        raise ArgumentError(f"{path}={given}: how many numbers? Write LOW:HIGH:COUNT, such as {given}:9")
    if len(found) > MOST_LEVELS:
        raise ArgumentError(f"{path}: {len(found):,} values; at most {MOST_LEVELS:,} are taken")
    return found


def _several(path: str, given: Any) -> Iterable[Any]:
    if isinstance(given, Iterable) and not isinstance(given, (bytes, dict)) and getattr(given, "shape", None) != ():
        values = list(given)
        if values:
            return values
    raise ArgumentError(f"{path}: takes a text such as 0.1:0.9:9 or a list of values, not {shown(given)}")


def _plain(path: str, value: Any) -> Value:
    """A value as Python has it: numpy's numbers become Python's."""
    if isinstance(value, (str, bool)):
        return value
    if isinstance(value, Integral):
        whole = int(value)
        if not _LEAST <= whole <= _MOST:
            raise ArgumentError(f"{path}: a whole number is one of 64 bits, not {shown(value)}")
        return whole
    if isinstance(value, Real) and math.isfinite(value):
        return float(value)
    if type(value).__name__ == "bool_" or type(value).__name__ == "bool":  # numpy's
        return bool(value)
    raise ArgumentError(f"{path}: a value is a finite number, a text, True or False, not {shown(value)}")


def _read(path: str, text: str) -> Levels:
    parts = [part.strip() for part in text.split(":")]
    if len(parts) == 1 or not all(_NUMBER.fullmatch(part) for part in parts):
        return _listed(path, text)
    if len(parts) > 3:
        raise ArgumentError(f"{path}={text}: a range is LOW:HIGH:COUNT, or LOW:HIGH for whole numbers")
    low, high = (Fraction(part) for part in parts[:2])
    if high < low:
        raise ArgumentError(f"{path}={text}: a range begins with its lower end; write {parts[1]}:{parts[0]}")
    if len(parts) == 2 and all(_WHOLE.fullmatch(part) for part in parts):
        return Whole(int(parts[0]), int(parts[1]))
    return Between(low, high, _count(path, text, parts[2:]))


def _count(path: str, text: str, rest: Sequence[str]) -> int | None:
    if not rest:
        return None
    if not _WHOLE.fullmatch(rest[0]) or int(rest[0]) < 1:
        raise ArgumentError(f"{path}={text}: COUNT is how many numbers, a whole number from 1, not {rest[0]}")
    return int(rest[0])


def _listed(path: str, text: str) -> Listed:
    parts = [part.strip() for part in text.split(",")]
    if not all(parts):
        raise ArgumentError(f"{path}={text}: there is nothing between two commas; write values as a,b,c")
    return Listed(tuple(map(_value, parts)))


def _value(text: str) -> Value:
    """A number, true or false as in JSON; anything else is text."""
    if _WHOLE.fullmatch(text):
        return int(text)
    if _NUMBER.fullmatch(text):
        return float(text)
    return json.loads(text) if text in ("true", "false") else text
