"""Exact predicates on points with integer coordinates: turns, circles, whether segments meet or come near."""

from __future__ import annotations

from collections.abc import Sequence

Point = tuple[int, int]


def scaled(vertices: Sequence[tuple[float, float]]) -> tuple[list[Point], int]:
    """The vertices times one power of two that makes every coordinate whole, and that power. Exact."""
    ratios = [(x.as_integer_ratio(), y.as_integer_ratio()) for x, y in vertices]
    unit = max((part[1] for ratio in ratios for part in ratio), default=1)
    unit = max(unit, 1 << 40)
    return [(a * (unit // b), c * (unit // d)) for (a, b), (c, d) in ratios], unit


def span(points: Sequence[Point]) -> int:
    """The larger side of the points' bounding box."""
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return max(max(xs) - min(xs), max(ys) - min(ys))


def cross(a: Point, b: Point, c: Point) -> int:
    """Twice the signed area of the triangle a b c: positive where the way a, b, c turns left."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def between(a: Point, b: Point, c: Point) -> bool:
    """Whether b lies in the strip between a and c, seen along the way from a to c (ends excluded)."""
    ahead = (c[0] - a[0]) * (b[0] - a[0]) + (c[1] - a[1]) * (b[1] - a[1])
    return 0 < ahead < (c[0] - a[0]) ** 2 + (c[1] - a[1]) ** 2


def crossing(a: Point, b: Point, c: Point, d: Point) -> bool:
    """Whether the closed segments a b and c d share a point."""
    side_c, side_d = cross(a, b, c), cross(a, b, d)
    side_a, side_b = cross(c, d, a), cross(c, d, b)
    if side_c == side_d == 0:
        return all(_ranges_meet(a[i], b[i], c[i], d[i]) for i in (0, 1))
    return _opposite(side_c, side_d) and _opposite(side_a, side_b)


def gap_below(a: Point, b: Point, c: Point, d: Point, least: int) -> bool:
    """Whether the segments a b and c d, which do not cross, come nearer to each other than `least`."""
    return _is_near(a, c, d, least) or _is_near(b, c, d, least) or _is_near(c, a, b, least) or _is_near(d, a, b, least)


def _is_near(p: Point, a: Point, b: Point, least: int) -> bool:
    if between(a, p, b):
        return cross(a, b, p) ** 2 < least**2 * distance_squared(a, b)
    return min(distance_squared(p, a), distance_squared(p, b)) < least**2


def distance_squared(a: Point, b: Point) -> int:
    """Square of the distance between two points."""
    return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2


def in_circle(a: Point, b: Point, c: Point, d: Point) -> int:
    """Positive where d lies within the circle through a, b and c, which turn left; 0 on it."""
    ax, ay, bx, by, cx, cy = a[0] - d[0], a[1] - d[1], b[0] - d[0], b[1] - d[1], c[0] - d[0], c[1] - d[1]
    first = (ax * ax + ay * ay) * (bx * cy - cx * by)
    second = (bx * bx + by * by) * (ax * cy - cx * ay)
    return first - second + (cx * cx + cy * cy) * (ax * by - bx * ay)


def _opposite(first: int, second: int) -> bool:
    return (first <= 0 <= second) or (second <= 0 <= first)


def _ranges_meet(a: int, b: int, c: int, d: int) -> bool:
    return max(min(a, b), min(c, d)) <= min(max(a, b), max(c, d))
