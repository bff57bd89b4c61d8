"""Where two runs part, as values that any report can show."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Literal

_TITLES = {"scene": "the scene was edited", "command": "the commands were edited", "engine": "the engine is another"}


@dataclass(frozen=True)
class Difference:
    """One number that differs: `field` (in `unit`) of record `name` in `table`, and the `body` it is about.

    `name` is a body's or joint's id, of a contact both bodies' ids. `expected` or `got` is None where that run has no
    such record. `ulps` counts the floats between the two, or how far whole numbers are apart; None without a number.
    """

    table: str
    name: str
    body: str
    field: str
    unit: str
    expected: float | int | None
    got: float | int | None
    ulps: int | None

    def __str__(self) -> str:
        field = f"{self.field} " if self.field else ""
        return f"{self.table} {self.name}: {field}expected {_shown(self)[0]}, got {_shown(self)[1]}{_far(self)}"


@dataclass(frozen=True)
class Growth:
    """After `step` steps no body is farther from where it should be than `body`, by `distance` (m)."""

    step: int
    body: str
    distance: float


@dataclass(frozen=True)
class Cause:
    """Why two runs part: `kind` is "scene", "command", "engine" or "unknown", and `said` tells it in lines of text.

    `origin` says in words where the recorded run was found again; "" if it was not.
    """

    kind: Literal["scene", "command", "engine", "unknown"]
    said: tuple[str, ...]
    origin: str = ""

    def lines(self) -> list[str]:
        """In words."""
        head = "cause not known" if self.kind == "unknown" else f"cause: {_TITLES[self.kind]}"
        first, *more = self.said
        return [f"{head}: {first}", *(f"  {line}" for line in more)]


@dataclass(frozen=True)
class Divergence:
    """The first step after which two runs differ.

    `group` is one of `fingerprint.GROUPS`, "command" if a command was refused, "rest" if only the full digest at the
    end differs, "state" if `--heavy` found that a restored snapshot goes another way, or the figure that left its
    tolerance. `expected` and `got` are fingerprints, figures or words. `detail` and `growth` are known if two runs
    were laid side by side, `cause` if it was looked for.
    """

    step: int
    time: float
    group: str
    expected: str
    got: str
    detail: Difference | None = None
    others: int = 0
    growth: tuple[Growth, ...] = ()
    cause: Cause | None = None

    def lines(self) -> list[str]:
        """In words, the most important first."""
        told = [f"step {self.step} ({self.time:.3f} s): {self.group}: expected {self.expected}, got {self.got}"]
        if self.detail is not None:
            more = f" (and {self.others} more numbers)" if self.others else ""
            told.append(f"first: {self.detail}{more}")
        rows = [one for one in self.growth if one.distance > 0.0]
        if rows:
            shown = [*rows[: -1 : max(1, len(rows) // 3)], rows[-1]]
            steps = ", ".join(f"{one.distance:.3g} m at step {one.step} ({one.body})" for one in shown)
            told.append(f"farthest off: {steps}")
        return [*told, *(self.cause.lines() if self.cause is not None else ())]


@dataclass(frozen=True)
class Drift:
    """How far a `body` is at the end from where it was recorded: `distance` (m) and `turn` (rad).

    `expected` and `got` are (x, y, angle); None if the body is not there.
    """

    body: str
    expected: tuple[float, float, float] | None
    got: tuple[float, float, float] | None
    distance: float
    turn: float


def ulps_between(a: float, b: float) -> int:
    """How many steps from one float to the next lead from `a` to `b`. Zeroes of either sign are one apart."""
    return abs(_ordered(a) - _ordered(b))


def _ordered(value: float) -> int:
    """Whole numbers in the order of floats; NaNs lie beyond infinity."""
    bits = int(struct.unpack("<q", struct.pack("<d", value))[0])
    return bits if bits >= 0 else -1 - (bits & 0x7FFF_FFFF_FFFF_FFFF)


def _shown(one: Difference) -> tuple[str, str]:
    unit = "" if one.unit in ("-", "1", "") else f" {one.unit}"
    return tuple("none" if v is None else f"{v!r}{unit}" for v in (one.expected, one.got))  # type: ignore[return-value]


def _far(one: Difference) -> str:
    if one.ulps is None or not isinstance(one.expected, float):
        return ""
    return f" ({one.ulps:,} ulp{'' if one.ulps == 1 else 's'} off)"
