"""Area, centroid and second moment by definition: exactly for polygons, by ever finer polygons for round shapes."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise

Point = tuple[Fraction, Fraction]


def polygon_moments(points: list[Point]) -> tuple[Fraction, Fraction, Fraction, Fraction]:
    """(area, first x, first y, polar second moment about the origin) of a counter-clockwise polygon.

    Cut into triangles from the first point; a triangle's second moment is its area / 6 times the sum of the
    products of its corners' coordinates, each pair once.
    """
    total = [Fraction(0)] * 4
    for q, r in pairwise(points[1:]):
        corners = (points[0], q, r)
        (x0, y0), (x1, y1), (x2, y2) = corners
        area = ((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)) / 2
        xs, ys = [c[0] for c in corners], [c[1] for c in corners]
        second = sum(v[i] * v[j] for v in (xs, ys) for i in range(3) for j in range(i, 3))
        for k, part in enumerate((area, area * sum(xs) / 3, area * sum(ys) / 3, area * second / 6)):
            total[k] += part
    return tuple(total)  # type: ignore[return-value]


def outline(core: list[tuple[float, float]], radius: float, pieces: int) -> list[tuple[float, float]]:
    """Points on the outline of a rounded core, `pieces` to a corner: the hull of discs around the vertices."""
    count, points = len(core), []
    for i, (x, y) in enumerate(core):
        if count == 1:
            start, turn = 0.0, 2 * math.pi
        else:
            before, after = core[i - 1], core[(i + 1) % count]
            start = math.atan2(-(x - before[0]), y - before[1])
            end = math.atan2(-(after[0] - x), after[1] - y)
            turn = (end - start) % (2 * math.pi)
        for k in range(pieces + 1):
            t = start + turn * k / pieces
            points.append((x + radius * math.cos(t), y + radius * math.sin(t)))
    return points


def rounded_moments(core: list[tuple[float, float]], radius: float) -> list[float]:
    """Moments of a rounded core: from two polygons inside, Richardson-extrapolated (the error falls as 1/n^2)."""
    coarse, fine = (
        [float(v) for v in polygon_moments([(Fraction(x), Fraction(y)) for x, y in outline(core, radius, pieces)])]
        for pieces in (40, 80)
    )
    return [f + (f - c) / 3 for c, f in zip(coarse, fine, strict=True)]
