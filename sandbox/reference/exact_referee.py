"""The third referee: two rounded convex cores in exact rational arithmetic.

Two cores overlap where their Minkowski difference holds the origin, and the least way that parts them is the way from
the origin to its boundary. Nothing is rounded before the last line, and no axis of the separating-axis test is used.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from sandbox.reference.pair import Core, Pair, Point

Exact = tuple[Fraction, Fraction]
_BITS = 400


@dataclass(frozen=True)
class Truth:
    """`separation` in m, rounded once: the distance of two shapes, or minus the least way that parts them.

    `overlap` is exact: shapes that touch in a point or along a line do not overlap.
    """

    overlap: bool
    separation: float

    @property
    def depth(self) -> float:
        """Metres; 0 where the shapes do not overlap."""
        return max(0.0, -self.separation)


def judge(pair: Pair) -> Truth:
    """The truth about two shapes at exactly the places that their floats name."""
    hull = convex_hull(_difference(pair))
    radii = Fraction(pair.a.radius) + Fraction(pair.b.radius)
    inside, square = _from_origin(hull)
    separation = (-_root(square) if inside else _root(square)) - radii
    if inside:
        return Truth(True, float(separation))
    return Truth(square < radii * radii, float(separation))


def overlap_along(pair: Pair, direction: Point) -> float:
    """Metres that b has to go along `direction` (any length but 0) until that axis separates it from a."""
    x, y = Fraction(direction[0]), Fraction(direction[1])
    least = min(x * px + y * py for px, py in _difference(pair))
    length = _root(x * x + y * y)
    return float(Fraction(pair.a.radius) + Fraction(pair.b.radius) - least / length)


def nearest_line(pair: Pair) -> float:
    """Distance (m) of the origin from the nearest line through an edge of the Minkowski difference.

    0 where some feature of one shape lies exactly in line with an edge of the other, however far away.
    """
    hull = convex_hull(_difference(pair))
    squares = [_cross(p, q) ** 2 / _square(_minus(q, p)) for p, q in _edges(hull)]
    return float(_root(min(squares))) if squares else math.inf


def _difference(pair: Pair) -> list[Exact]:
    """All points of b minus all points of a."""
    a, b = _placed(pair.a, pair.center_a), _placed(pair.b, pair.center_b)
    return [_minus(q, p) for q in b for p in a]


def _placed(core: Core, center: Point) -> list[Exact]:
    x, y = Fraction(center[0]), Fraction(center[1])
    return [(x + Fraction(px), y + Fraction(py)) for px, py in core.points]


def convex_hull(points: list[Exact]) -> list[Exact]:
    """Corners of the hull, counter-clockwise, none of them in line (A. M. Andrew, 1979); one or two if it is flat."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered
    halves = []
    for way in (ordered, ordered[::-1]):
        half: list[Exact] = []
        for point in way:
            while len(half) > 1 and _cross(_minus(half[-1], half[-2]), _minus(point, half[-1])) <= 0:
                half.pop()
            half.append(point)
        halves.append(half[:-1])
    return halves[0] + halves[1]


def _from_origin(hull: list[Exact]) -> tuple[bool, Fraction]:
    """(whether the origin lies strictly inside, square of its distance from the boundary)."""
    edges = _edges(hull)
    if not edges:
        return False, _square(hull[0])
    inside = len(hull) > 2 and all(_cross(p, q) > 0 for p, q in edges)
    return inside, min(_square_to(p, q) for p, q in edges)


def _edges(hull: list[Exact]) -> list[tuple[Exact, Exact]]:
    return [(hull[i - 1], hull[i]) for i in range(len(hull))] if len(hull) > 1 else []


def _square_to(p: Exact, q: Exact) -> Fraction:
    """Square of the distance of the origin from the segment p q."""
    way = _minus(q, p)
    t = -(p[0] * way[0] + p[1] * way[1]) / _square(way)
    t = max(Fraction(0), min(Fraction(1), t))
    return _square((p[0] + t * way[0], p[1] + t * way[1]))


def _minus(p: Exact, q: Exact) -> Exact:
    return p[0] - q[0], p[1] - q[1]


def _cross(p: Exact, q: Exact) -> Fraction:
    return p[0] * q[1] - p[1] * q[0]


def _square(p: Exact) -> Fraction:
    return p[0] * p[0] + p[1] * p[1]


def _root(square: Fraction) -> Fraction:
    """Square root to 400 binary digits."""
    shift = _BITS - (square.numerator.bit_length() - square.denominator.bit_length()) // 2
    scaled = square * Fraction(4) ** shift
    return Fraction(math.isqrt(scaled.numerator // scaled.denominator)) / Fraction(2) ** shift
