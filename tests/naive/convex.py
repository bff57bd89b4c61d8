"""Rounded convex cores by definition and in exact rational arithmetic.

A core is a list of (x, y) points, counter-clockwise; one point and two points are cores as well. The separation of
two cores is their distance while they are apart, and minus the least way that parts them when they overlap.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import NamedTuple

Point = tuple[Fraction, Fraction]


class Axis(NamedTuple):
    """A signed length along a direction that is not normalised: `value / sqrt(square)`."""

    value: Fraction
    square: Fraction

    def length(self) -> float:
        """The signed length as the nearest float, or nearly so."""
        return math.copysign(root(self.value * self.value / self.square), self.value)

    def __gt__(self, other: tuple) -> bool:
        return self.signed_square() > other.signed_square()  # type: ignore[attr-defined]

    def signed_square(self) -> Fraction:
        """Sign times length squared: orders axes exactly."""
        return self.value * abs(self.value) / self.square


def root(square: Fraction) -> float:
    """Square root of a rational without under- or overflow on the way."""
    if square == 0:
        return 0.0
    shift = (square.numerator.bit_length() - square.denominator.bit_length()) // 2
    return math.ldexp(math.sqrt(square / Fraction(4) ** shift), shift)


def exact(core, dx: float = 0.0, dy: float = 0.0) -> list[Point]:
    """A core's floats as rationals, moved by (dx, dy)."""
    return [(Fraction(x) + Fraction(dx), Fraction(y) + Fraction(dy)) for x, y in core]


def edges(core: list[Point]) -> list[tuple[Point, Point]]:
    """Edges of a core; a core of two points has two, there and back."""
    return [(core[i], core[(i + 1) % len(core)]) for i in range(len(core))] if len(core) > 1 else []


def normal(edge: tuple[Point, Point]) -> Point:
    """Outward normal of an edge, as long as the edge."""
    (x0, y0), (x1, y1) = edge
    return y1 - y0, x0 - x1


def dot(a: Point, b: Point) -> Fraction:
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1]


def face_axes(a: list[Point], b: list[Point]) -> list[Axis]:
    """For every face normal of a: how far b lies beyond all of a along it."""
    found = []
    for edge in edges(a):
        n = normal(edge)
        gap = min(dot(n, p) for p in b) - max(dot(n, p) for p in a)
        found.append(Axis(gap, dot(n, n)))
    return found


def best_axis(axes: list[Axis]) -> Axis:
    """The axis of largest separation."""
    best = axes[0]
    for axis in axes[1:]:
        best = axis if axis > best else best
    return best


def nearest_on_segment(p: Point, edge: tuple[Point, Point]) -> Point:
    """The point of a segment nearest to p."""
    start, end = edge
    way = end[0] - start[0], end[1] - start[1]
    length = dot(way, way)
    t = dot((p[0] - start[0], p[1] - start[1]), way) / length if length else Fraction(0)
    t = max(Fraction(0), min(Fraction(1), t))
    return start[0] + t * way[0], start[1] + t * way[1]


def square_between(p: Point, q: Point) -> Fraction:
    """Distance squared."""
    return (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2


def square_to_boundary(p: Point, core: list[Point]) -> Fraction:
    """Distance squared from a point to the boundary of a core."""
    if len(core) == 1:
        return square_between(p, core[0])
    return min(square_between(p, nearest_on_segment(p, edge)) for edge in edges(core))


def inside(p: Point, core: list[Point]) -> bool:
    """Whether a point lies in a polygon or on its boundary; lines and points have no inside."""
    return len(core) > 2 and all(dot(normal((q, r)), (p[0] - q[0], p[1] - q[1])) <= 0 for q, r in edges(core))


def cross_each_other(e: tuple[Point, Point], f: tuple[Point, Point]) -> bool:
    """Whether two segments cross in their insides."""

    def side(p: Point, edge: tuple[Point, Point]) -> Fraction:
        return dot(normal(edge), (p[0] - edge[0][0], p[1] - edge[0][1]))

    return side(f[0], e) * side(f[1], e) < 0 and side(e[0], f) * side(e[1], f) < 0


def square_distance(a: list[Point], b: list[Point]) -> Fraction:
    """Distance squared of two cores; 0 when they share a point. By brute force over points and edges."""
    if any(inside(p, b) for p in a) or any(inside(p, a) for p in b):
        return Fraction(0)
    if any(cross_each_other(e, f) for e in edges(a) for f in edges(b)):
        return Fraction(0)
    return min(min(square_to_boundary(p, b) for p in a), min(square_to_boundary(p, a) for p in b))


def separation(a: list[Point], b: list[Point]) -> float:
    """Signed separation of two cores: distance, or minus the depth along the best of all axes."""
    square = square_distance(a, b)
    if square > 0:
        return root(square)
    axes = face_axes(a, b) + face_axes(b, a)
    return min(0.0, best_axis(axes).length()) if axes else 0.0


def signed_distance(p: Point, core: list[Point]) -> float:
    """Distance of a point from a core, negative inside."""
    distance = root(square_to_boundary(p, core))
    return -distance if inside(p, core) else distance
