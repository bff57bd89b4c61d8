"""Paths in the syntax of SVG (https://www.w3.org/TR/SVG2/paths.html#PathData), as outlines of points.

Coordinates are taken as they stand: in a scene y points up, so that a path from a picture stands on its head. Curves
become lines that leave each by a five-hundredth of its own extent at most; nothing asks the C library for a sine, so
that every machine gets the same points.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

from sandbox._printable import printable
from sandbox.scene.limits import MAX_OUTLINE, MAX_PATH
from sandbox.scene.svg_curves import Arc, Vec, along_arc, along_curve

_TOLERANCE = 2e-3
"""Of the larger side of the box around the points of a curve; a circle becomes 64 lines."""
_COUNTS = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}
_FLAGS = (3, 4)
_BETWEEN = re.compile(r"[ \t\r\n]*,?[ \t\r\n]*")
_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?")
_FLAG = re.compile(r"[01]")

Piece = tuple[Vec, ...] | Arc
"""What a path goes along: a line (its end), a curve (control points and end), or an arc."""


class PathError(Exception):
    """A path cannot be read; `span` are the characters that show it."""

    def __init__(self, message: str, span: tuple[int, int]) -> None:
        super().__init__(message)
        self.message, self.span = message, span


@dataclass
class Subpath:
    """Where one stroke begins, the pieces that it goes along, and whether it leads back to where it began."""

    start: Vec
    pieces: list[Piece] = field(default_factory=list)
    closed: bool = False


def outlines(text: str) -> list[tuple[list[Vec], bool]]:
    """The points of each subpath, and whether it is closed. Raises `PathError`."""
    if len(text) > MAX_PATH:
        raise PathError(f"a path has at most {MAX_PATH:,} characters", (0, 1))
    return [(_points(one, text), one.closed) for one in subpaths(text)]


def subpaths(text: str) -> Iterator[Subpath]:
    """The strokes of a path, with absolute coordinates. Raises `PathError`, after what stands before the mistake."""
    pen, mistake = _Pen(), None
    try:
        for letter, values, span in _commands(text):
            done = pen.stroke
            pen.draw(letter, values, span)
            if done is not None and done is not pen.stroke and done.pieces:
                yield done
    except PathError as error:
        mistake = error
    if pen.stroke is not None and pen.stroke.pieces:
        yield pen.stroke
    if mistake is not None:
        raise mistake


class _Pen:
    """Follows commands; keeps what relative and smooth ones go on from."""

    def __init__(self) -> None:
        self.stroke: Subpath | None = None
        self._at: Vec = (0.0, 0.0)
        self._handle: tuple[str, Vec] | None = None

    def draw(self, letter: str, values: list[float], span: tuple[int, int]) -> None:
        """Carry out one command with the numbers of one repetition."""
        kind, relative = letter.upper(), letter.islower()
        if kind == "M":
            self._at = self._point(values, relative)
            self.stroke, self._handle = Subpath(self._at), None
            return
        if self.stroke is None:
            raise PathError("a stroke begins with M", span)
        if kind == "Z":
            self.stroke.closed, self._at, self._handle = True, self.stroke.start, None
            return
        if self.stroke.closed:  # the next one begins where that did
            self.stroke = Subpath(self._at)
        piece = self._piece(kind, values, relative)
        self.stroke.pieces.append(piece)
        self._handle = (kind, piece[-2]) if kind in "CSQT" and isinstance(piece, tuple) else None
        self._at = piece.end if isinstance(piece, Arc) else piece[-1]

    def _piece(self, kind: str, values: list[float], relative: bool) -> Piece:
        if kind == "A":
            end = self._point(values[5:], relative)
            return Arc(self._at, (values[0], values[1]), values[2], values[3] != 0.0, values[4] != 0.0, end)
        if kind in "HV":
            x, y = self._at
            if kind == "H":
                return ((x * relative + values[0], y),)
            return ((x, y * relative + values[0]),)
        points = [self._point(values[k : k + 2], relative) for k in range(0, len(values), 2)]
        if kind == "S":
            points.insert(0, self._mirrored("CS"))
        if kind == "T":
            points.insert(0, self._mirrored("QT"))
        return tuple(points)

    def _point(self, values: list[float], relative: bool) -> Vec:
        x, y = self._at if relative else (0.0, 0.0)
        return x + values[0], y + values[1]

    def _mirrored(self, kinds: str) -> Vec:
        """The control point with which a curve goes on smoothly after one of `kinds`."""
        x, y = self._at
        if self._handle is None or self._handle[0] not in kinds:
            return self._at
        return 2.0 * x - self._handle[1][0], 2.0 * y - self._handle[1][1]


def _commands(text: str) -> Iterator[tuple[str, list[float], tuple[int, int]]]:
    """Letter, numbers and characters of every command, once for each repetition of it."""
    position = _skip(text, 0)
    while position < len(text):
        start, letter = position, text[position]
        count = _COUNTS.get(letter.upper())
        if count is None:
            raise PathError(f'"{printable(letter)}" is no command of a path', (start, start + 1))
        position = _skip(text, position + 1)
        first = True
        while first or (count and position < len(text) and not text[position].isalpha()):
            values = []
            for k in range(count):
                value, position = _number(text, position, k if letter in "Aa" else -1)
                values.append(value)
            # What follows a move without a letter of its own are lines.
            again = {"M": "L", "m": "l"}.get(letter, letter)
            yield letter if first else again, values, (start, max(start + 1, position))
            first = False


def _number(text: str, position: int, place: int) -> tuple[float, int]:
    match = (_FLAG if place in _FLAGS else _NUMBER).match(text, position)
    if match is None:
        what = "0 or 1" if place in _FLAGS else "a number"
        shown = min(position, max(len(text) - 1, 0))
        raise PathError(f"{what} is due here", (shown, shown + 1))
    value = float(match.group())
    if not abs(value) <= 1e12:
        raise PathError("the number is too large", match.span())
    return value, _skip(text, match.end())


def _skip(text: str, position: int) -> int:
    match = _BETWEEN.match(text, position)
    assert match is not None
    return match.end()


def _tolerance(at: Vec, piece: Piece) -> float:
    """How far lines may leave a piece that begins at `at`, m."""
    points = (at, piece.end) if isinstance(piece, Arc) else (at, *piece)
    xs, ys = zip(*points, strict=True)
    extent = max(max(xs) - min(xs), max(ys) - min(ys))
    if isinstance(piece, Arc) and piece.large:
        extent = max(extent, *(2.0 * abs(radius) for radius in piece.radii))
    return float(_TOLERANCE * extent)


def _points(stroke: Subpath, text: str) -> list[Vec]:
    """The points of a stroke; none is that before it, nor the last of a closed one its first."""
    found = [stroke.start]
    for piece in stroke.pieces:
        at = found[-1]
        tolerance = _tolerance(at, piece)
        steps = along_arc(piece, tolerance) if isinstance(piece, Arc) else along_curve((at, *piece), tolerance)
        for point in steps:
            if point != found[-1]:
                found.append(point)
            if len(found) > MAX_OUTLINE + 1:
                raise PathError(f"the path has more than {MAX_OUTLINE} points", (0, len(text)))
    if stroke.closed and len(found) > 1 and found[-1] == found[0]:
        found.pop()
    return found
