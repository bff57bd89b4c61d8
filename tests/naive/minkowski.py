"""The third referee: two rounded convex shapes by their Minkowski difference, in exact rational arithmetic.

The difference of two convex sets, all b - a, is convex and holds the origin exactly when they share a point. The
distance of the origin from its outline is the distance of the sets, or the least way that parts them. Rounding grows
the difference by the sum of the radii. Nothing here is shared with the package: corners are found by a convex hull of
all differences, and no separating axis is ever asked for.
"""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

import mpmath

Point = tuple[Fraction, Fraction]


class Separation(NamedTuple):
    """Signed separation of two rounded shapes: `side` * sqrt(`square`) - `radii`, all exact; side is -1 inside."""

    side: int
    square: Fraction
    radii: Fraction

    @property
    def sign(self) -> int:
        """1 apart, 0 touching, -1 overlapping."""
        difference = self.side * self.square - self.radii * self.radii
        return (difference > 0) - (difference < 0)

    @property
    def value(self) -> mpmath.mpf:
        """In metres, with as many bits as it takes for at least 100 to be right after they cancel."""
        parts = self.square.numerator, self.square.denominator, self.radii.numerator, self.radii.denominator
        with mpmath.workprec(200 + 2 * sum(part.bit_length() for part in parts)):
            return self.side * mpmath.sqrt(_mpf(self.square)) - _mpf(self.radii)


def _mpf(x: Fraction) -> mpmath.mpf:
    return mpmath.mpf(x.numerator) / x.denominator


def separation(a, b, shift=(0.0, 0.0)) -> Separation:
    """Of two shapes (anything with `vertices` and `radius`), with b moved by `shift`; all floats are taken as exact."""
    way = Fraction(shift[0]), Fraction(shift[1])
    differences = {
        (Fraction(bx) + way[0] - Fraction(ax), Fraction(by) + way[1] - Fraction(ay))
        for ax, ay in a.vertices
        for bx, by in b.vertices
    }
    unit = max(max(x.denominator, y.denominator) for x, y in differences)
    outline = hull(sorted((int(x * unit), int(y * unit)) for x, y in differences))
    square = Fraction(square_to_outline(outline)) / (unit * unit)
    side = -1 if holds_origin(outline) else 1
    return Separation(side, square, Fraction(a.radius) + Fraction(b.radius))


def cross(p, q, r) -> int:
    """Twice the signed area of a triangle."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def hull(points: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Convex hull of sorted points, counter-clockwise, corners only (A. Andrew's monotone chain)."""
    if len(points) < 3:
        return points

    def chain(ordered):
        kept: list[tuple[int, int]] = []
        for point in ordered:
            while len(kept) > 1 and cross(kept[-2], kept[-1], point) <= 0:
                kept.pop()
            kept.append(point)
        return kept[:-1]

    return chain(points) + chain(points[::-1])


def holds_origin(outline) -> bool:
    """Whether the origin lies inside, not on, a hull; a hull without area has no inside."""
    ring = zip(outline, outline[1:] + outline[:1], strict=True)
    return len(outline) > 2 and all(cross(p, q, (0, 0)) > 0 for p, q in ring)


def square_to_outline(outline) -> Fraction:
    """Distance squared of the origin from the outline of a hull."""
    if len(outline) == 1:
        return Fraction(outline[0][0] ** 2 + outline[0][1] ** 2)
    return min(square_to_segment(p, q) for p, q in zip(outline, outline[1:] + outline[:1], strict=True))


def square_to_segment(p, q) -> Fraction:
    """Distance squared of the origin from a segment."""
    way = q[0] - p[0], q[1] - p[1]
    length = way[0] ** 2 + way[1] ** 2
    along = -(p[0] * way[0] + p[1] * way[1])
    if along <= 0:
        return Fraction(p[0] ** 2 + p[1] ** 2)
    if along >= length:
        return Fraction(q[0] ** 2 + q[1] ** 2)
    return Fraction((p[0] * q[1] - p[1] * q[0]) ** 2, length)
