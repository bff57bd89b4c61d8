"""Bezier curves and elliptical arcs as lines that leave them by a tolerance at most."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from sandbox.geometry.rotation import cos_sin_degrees

Vec = tuple[float, float]
_MOST = 4096
"""Lines that one curve becomes at most."""
_QUARTER_SAGITTA = math.pi**2 / 32
"""How far a quarter of a unit circle is from its chord, at most."""
_TINY = 1e-9
"""Rounding errors of unit vectors are smaller."""


@dataclass(frozen=True)
class Arc:
    """From `start` to `end` along an ellipse with two `radii`, turned by `degrees`: the `large` arc or the other one,
    in the direction of growing angles (`sweep`) or against it."""

    start: Vec
    radii: Vec
    degrees: float
    large: bool
    sweep: bool
    end: Vec


def along_curve(points: Sequence[Vec], tolerance: float) -> Iterator[Vec]:
    """Points after the first one of a line (2 points), a quadratic (3) or a cubic curve (4).

    The chords of n equal parts leave a curve by |B''| / (8 n^2) at most.
    """
    order = len(points) - 1
    bends = [_bend(*points[k : k + 3]) for k in range(order - 1)]
    bend = order * (order - 1) * max(bends, default=0.0)
    parts = 1
    if bend > 8.0 * tolerance:
        squared = bend / (8.0 * tolerance or bend)
        parts = _MOST if squared > _MOST * _MOST else math.ceil(math.sqrt(squared))
    for k in range(1, parts):
        yield _blended(points, k / parts)
    yield points[-1]


def _bend(a: Vec, b: Vec, c: Vec) -> float:
    x, y = a[0] - 2.0 * b[0] + c[0], a[1] - 2.0 * b[1] + c[1]
    return math.sqrt(x * x + y * y)


def _blended(points: Sequence[Vec], t: float) -> Vec:
    """The point of a Bezier curve at t, by de Casteljau's algorithm."""
    level = list(points)
    while len(level) > 1:
        level = [(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])) for a, b in pairwise(level)]
    return level[0]


def along_arc(arc: Arc, tolerance: float) -> Iterator[Vec]:
    """Points after the first one of an arc: quarters of the unit circle are halved until they are flat enough.

    Center and radii are found as appendix B.2 of SVG 2 says; radii too small to reach are enlarged.
    """
    rx, ry = abs(arc.radii[0]), abs(arc.radii[1])
    if arc.start != arc.end and rx > 0.0 and ry > 0.0:
        cos, sin = cos_sin_degrees(arc.degrees)
        dx, dy = (arc.start[0] - arc.end[0]) / 2.0, (arc.start[1] - arc.end[1]) / 2.0
        # Half the way from the end to the start, where the ellipse is the unit circle.
        hx, hy = (cos * dx + sin * dy) / rx, (cos * dy - sin * dx) / ry
        reach = hx * hx + hy * hy
        grown = math.sqrt(reach) if reach > 1.0 else 1.0
        rx, ry, hx, hy = rx * grown, ry * grown, hx / grown, hy / grown
        reach = hx * hx + hy * hy
        away = math.sqrt(max(0.0, 1.0 - reach) / reach) * (1.0 if arc.large == arc.sweep else -1.0)
        cx, cy = -away * hy, away * hx
        first, last = (hx - cx, hy - cy), (-hx - cx, -hy - cy)
        middle = (arc.start[0] + arc.end[0]) / 2.0, (arc.start[1] + arc.end[1]) / 2.0
        halvings = _halvings(max(rx, ry), tolerance)
        for x, y in list(_around(first, last, 1.0 if arc.sweep else -1.0, halvings))[:-1]:
            u, v = rx * (x + cx), ry * (y + cy)
            yield middle[0] + cos * u - sin * v, middle[1] + sin * u + cos * v
    yield arc.end


def _halvings(radius: float, tolerance: float) -> int:
    count, sagitta = 0, radius * _QUARTER_SAGITTA
    while sagitta > tolerance and count < 10:
        count, sagitta = count + 1, sagitta / 4.0
    return count


def _around(first: Vec, last: Vec, turn: float, halvings: int) -> Iterator[Vec]:
    """Unit vectors after `first`, up to `last`, counter-clockwise for `turn` 1."""
    at = first
    for _ in range(4):
        cross, dot = turn * (at[0] * last[1] - at[1] * last[0]), at[0] * last[0] + at[1] * last[1]
        if cross >= -_TINY and dot >= -_TINY:
            break
        following = (-turn * at[1], turn * at[0])
        yield from _halved(at, following, halvings)
        at = following
    apart = abs(at[0] * last[1] - at[1] * last[0])
    yield from _halved(at, last, halvings) if apart > _TINY else (last,)


def _halved(a: Vec, b: Vec, halvings: int) -> Iterator[Vec]:
    """Unit vectors after `a`, up to `b`, at most a quarter of a circle away."""
    if halvings == 0:
        yield b
        return
    x, y = a[0] + b[0], a[1] + b[1]
    length = math.sqrt(x * x + y * y)
    middle = (x / length, y / length)
    yield from _halved(a, middle, halvings - 1)
    yield from _halved(middle, b, halvings - 1)
