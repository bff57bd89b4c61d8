"""The least number of convex parts of a small simple polygon, by going through all ways to part it."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

Point = tuple[Fraction, Fraction]
MANY = 10**6


def least_parts(outline: list[tuple[float, float]]) -> int:
    """Fewest convex parts without new vertices of a counter-clockwise outline; corners may lie on straight sides.

    `best(i, j)` is the least for the chain of vertices i..j closed by the diagonal from j to i: the part at that
    diagonal is a convex chain i = v0 < v1 < ... < vk = j, and beyond each of its sides lies a smaller such problem.
    """
    ring = [(Fraction(x), Fraction(y)) for x, y in outline]
    count = len(ring)

    def turn(i: int, j: int, k: int) -> Fraction:
        return _cross(ring[i], ring[j], ring[k])

    @cache
    def sees(i: int, j: int) -> bool:
        return _is_diagonal(ring, i, j)

    @cache
    def best(i: int, j: int) -> int:
        if j == i + 1:
            return 0
        if not ((i == 0 and j == count - 1) or sees(i, j)):
            return MANY
        firsts = (k for k in range(i + 1, j) if _joined(k, i) and turn(j, i, k) >= 0)
        return 1 + min((_chain(i, k, j) for k in firsts), default=MANY)

    def _joined(k: int, i: int) -> bool:
        return k == i + 1 or sees(i, k)

    def _chain(i: int, first: int, j: int) -> int:
        """Least sum over convex chains from i by way of `first` to j."""
        cost = {(i, first): best(i, first)}
        for b in range(first, j):
            for a in range(i, b):
                if (a, b) not in cost:
                    continue
                for c in range(b + 1, j + 1):
                    if _joined(c, b) and turn(a, b, c) >= 0:
                        cost[b, c] = min(cost.get((b, c), MANY), cost[a, b] + best(b, c))
        return min((v for (a, b), v in cost.items() if b == j and turn(a, j, i) >= 0), default=MANY)

    return best(0, count - 1)


def _cross(a: Point, b: Point, c: Point) -> Fraction:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _is_diagonal(ring: list[Point], i: int, j: int) -> bool:
    """Whether the line from vertex i to j runs within the polygon and meets nothing but its ends."""
    count = len(ring)
    before, here, after = ring[i - 1], ring[i], ring[(i + 1) % count]
    left, right = _cross(here, ring[j], before), _cross(here, ring[j], after)
    wide = _cross(before, here, after) <= 0
    if not ((left > 0 or right < 0) if wide else (left > 0 and right < 0)):
        return False
    for k in range(count):
        m = (k + 1) % count
        if i not in (k, m) and j not in (k, m) and _meet(ring[i], ring[j], ring[k], ring[m]):
            return False
    return not any(k not in (i, j) and _on(ring[i], ring[j], ring[k]) for k in range(count))


def _meet(a: Point, b: Point, c: Point, d: Point) -> bool:
    apart = _cross(a, b, c) * _cross(a, b, d) > 0 or _cross(c, d, a) * _cross(c, d, b) > 0
    in_line = _cross(a, b, c) == _cross(a, b, d) == 0
    return _on(a, b, c) or _on(a, b, d) if in_line else not apart


def _on(a: Point, b: Point, p: Point) -> bool:
    return _cross(a, b, p) == 0 and min(a, b) <= p <= max(a, b)
