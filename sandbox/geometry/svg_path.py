"""Path data of SVG as points: curves become straight sides that lie within a tolerance of them.

Source: SVG 2, chapter 9 "Paths".
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

from sandbox.geometry.svg_arc import MOST_SIDES, arc_points

Vec = tuple[float, float]

_SPACE = re.compile(r"[\s,]*")
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?")
_FLAG = re.compile(r"[01]")
_COUNTS = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}


@dataclass
class Subpath:
    """Points from a move to the next one, in the units of the path; `closed` if the last leads back to the first."""

    points: list[Vec] = field(default_factory=list)
    closed: bool = False


@dataclass
class FlatPath:
    """The subpaths of a path. `fault` says what is wrong with its text at the character `at`; the path ends there."""

    subpaths: list[Subpath] = field(default_factory=list)
    fault: str = ""
    at: int = 0


def flat_path(text: str, tolerance: float) -> FlatPath:
    """The path as points. `tolerance` is in its own units. As SVG says, a path with a mistake is good up to there."""
    pen = _Pen(tolerance)
    try:
        for command, numbers in _segments(text):
            pen.draw(command, numbers)
    except _FaultError as error:
        return FlatPath(pen.finished(), str(error), error.at)
    return FlatPath(pen.finished())


class _FaultError(Exception):
    def __init__(self, message: str, at: int) -> None:
        super().__init__(message)
        self.at = at


def _segments(text: str) -> Iterator[tuple[str, list[float]]]:
    """Commands with their numbers, one segment each."""
    at, command = _skip(text, 0), ""
    while at < len(text):
        if text[at].isalpha():
            command, at = text[at], at + 1
            if command.upper() not in _COUNTS:
                raise _FaultError(f'"{command}" is no command of a path', at - 1)
        elif not command or command in "Zz":
            raise _FaultError("a command is due here", at)
        numbers, at = _numbers(text, _skip(text, at), command.upper())
        yield command, numbers
        command = {"M": "L", "m": "l"}.get(command, command)
        at = _skip(text, at)


def _numbers(text: str, at: int, kind: str) -> tuple[list[float], int]:
    found: list[float] = []
    for index in range(_COUNTS[kind]):
        match = (_FLAG if kind == "A" and index in (3, 4) else _NUMBER).match(text, at)
        if match is None:
            raise _FaultError("a number is due here", at)
        found.append(float(match.group()))
        at = _skip(text, match.end())
    if not all(map(math.isfinite, found)):
        raise _FaultError("a number is too large", at)
    return found, at


def _skip(text: str, at: int) -> int:
    match = _SPACE.match(text, at)
    return match.end() if match else at


class _Pen:
    def __init__(self, tolerance: float) -> None:
        self._tolerance = max(tolerance, 1e-12)
        self._done: list[Subpath] = []
        self._open = Subpath()
        self._here: Vec = (0.0, 0.0)
        self._start: Vec = (0.0, 0.0)
        self._control: tuple[str, Vec] = ("", (0.0, 0.0))
        self._draws: dict[str, Callable[[list[float]], None]] = {
            "M": self._move, "L": self._line, "C": self._cubic, "S": self._smooth, "Q": self._quadratic,
            "T": self._smooth_quadratic, "A": self._arc,
        }  # fmt: skip

    def finished(self) -> list[Subpath]:
        self._close(False)
        return self._done

    def draw(self, command: str, numbers: list[float]) -> None:
        kind = command.upper()
        if kind == "Z":
            self._close(True)
            return
        if kind in "HV":
            numbers = self._across(kind, command, numbers[0])
        elif command.islower():
            pairs = numbers[-2:] if kind == "A" else numbers
            moved = [value + self._here[k % 2] for k, value in enumerate(pairs)]
            numbers = numbers[:-2] + moved if kind == "A" else moved
        if kind != "M" and not self._open.points:
            self._open.points.append(self._here)
        self._draws["L" if kind in "HV" else kind](numbers)
        if kind not in "CSQT":
            self._control = ("", self._here)

    def _across(self, kind: str, command: str, value: float) -> list[float]:
        x, y = self._here
        shift = (x if kind == "H" else y) if command.islower() else 0.0
        return [value + shift, y] if kind == "H" else [x, value + shift]

    def _close(self, closed: bool) -> None:
        if len(self._open.points) > 1:
            self._open.closed = closed
            self._done.append(self._open)
        self._open = Subpath()
        self._here, self._control = self._start, ("", self._start)

    def _go(self, point: Vec) -> None:
        self._open.points.append(point)
        self._here = point

    def _move(self, numbers: list[float]) -> None:
        self._close(False)
        self._here = self._start = (numbers[0], numbers[1])

    def _line(self, numbers: list[float]) -> None:
        self._go((numbers[0], numbers[1]))

    def _cubic(self, numbers: list[float]) -> None:
        a, (bx, by, cx, cy, dx, dy) = self._here, numbers
        b, c, d = (bx, by), (cx, cy), (dx, dy)
        bend = max(_bend(a, b, c), _bend(b, c, d))
        count = min(MOST_SIDES, max(1, math.ceil(math.sqrt(0.75 * bend / self._tolerance))))
        for k in range(1, count):
            self._go(_on_cubic((a, b, c, d), k / count))
        self._go(d)
        self._control = ("C", c)

    def _quadratic(self, numbers: list[float]) -> None:
        (ax, ay), (bx, by, cx, cy) = self._here, numbers
        first, second = ((ax + 2 * bx) / 3, (ay + 2 * by) / 3), ((cx + 2 * bx) / 3, (cy + 2 * by) / 3)
        self._cubic([*first, *second, cx, cy])
        self._control = ("Q", (bx, by))

    def _smooth(self, numbers: list[float]) -> None:
        self._cubic([*self._reflected("C"), *numbers])

    def _smooth_quadratic(self, numbers: list[float]) -> None:
        self._quadratic([*self._reflected("Q"), *numbers])

    def _reflected(self, kind: str) -> Vec:
        if self._control[0] != kind:
            return self._here
        return 2 * self._here[0] - self._control[1][0], 2 * self._here[1] - self._control[1][1]

    def _arc(self, numbers: list[float]) -> None:
        end = (numbers[5], numbers[6])
        radii = (abs(numbers[0]), abs(numbers[1]))
        if end != self._here and min(radii) > 0.0:
            for point in arc_points(self._here, end, radii, numbers[2:5], self._tolerance):
                self._go(point)
        self._go(end)


def _bend(a: Vec, b: Vec, c: Vec) -> float:
    return math.hypot(a[0] - 2 * b[0] + c[0], a[1] - 2 * b[1] + c[1])


def _on_cubic(points: tuple[Vec, Vec, Vec, Vec], t: float) -> Vec:
    s = 1.0 - t
    weights = (s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t)
    x, y = (sum(w * point[axis] for w, point in zip(weights, points, strict=True)) for axis in (0, 1))
    return x, y
