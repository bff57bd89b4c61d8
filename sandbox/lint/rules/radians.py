"""Angles of scene files are degrees: one that is a part of a turn in radians was hardly meant as it stands."""

from __future__ import annotations

from collections.abc import Iterator
from math import floor, pi

from sandbox.lint.quantity import quantities
from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject
from sandbox.scene.finding import Finding

UNITS = ("degrees", "degrees/s")
TURNS = 10
"""So many turns may an angle have, or a speed in a second."""
PARTS = ((90.0, 2, 1.0), (45.0, 3, TURNS), (7.5, 4, TURNS))
"""Degrees whose multiples are looked for, with so many decimals at least and up to so many turns: each is rare enough
among all numbers of that length."""


def check(subject: Subject) -> Iterator[Finding]:
    """Every angle and speed of turning that is a multiple of 7.5 degrees in radians."""
    for path, value, unit in quantities(subject.scene):
        degrees = _degrees(value) if unit in UNITS else None
        if degrees is not None:
            name = next(part for part in reversed(path) if isinstance(part, str))
            yield Finding(path, f"{name} {value:g} looks like radians", f"angles are in degrees: {degrees:g}")


def _degrees(value: float) -> float | None:
    """What a number comes to in degrees if it is a part of a turn in radians, rounded or cut off."""
    decimals = len(repr(abs(value)).partition(".")[2])
    scale = 10.0 ** min(decimals, 12)
    written = round(abs(value) * scale)
    for part, least, turns in PARTS:
        degrees = part * round(abs(value) * 180.0 / (pi * part))
        exact = degrees * pi / 180.0 * scale
        if 0.0 < degrees <= 360.0 * turns and decimals >= least and written in (round(exact), floor(exact)):
            return degrees if value > 0.0 else -degrees
    return None


RULE = Rule("radians", "angles that are no degrees", check)
