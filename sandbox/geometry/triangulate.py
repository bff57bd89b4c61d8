"""Triangles of a polygon with holes, without new vertices: a sweep, then flips to the Delaunay triangulation.

The sweep goes from point to point in the order of their numbers and keeps, for every stretch of the sweep line that
lies in the polygon, the chain of vertices on its left that still see it (S. Hertel, K. Mehlhorn, "Fast triangulation of
simple polygons", FCT 1983). Points are numbered from left to right, and from below among equals. All decisions are
exact and depend on these numbers alone, not on where the author began.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from sandbox.geometry.exact import Point, cross, in_circle

Triangles = dict[tuple[int, int], int]
"""For each side (a, b) of a triangle, counter-clockwise, the third corner."""


@dataclass
class _Stretch:
    """A stretch of the sweep line within the polygon.

    `chain` are the vertices on its left from the lower to the upper boundary, `low` and `high` the points at which the
    boundaries' present sides end, `latest` the chain's rightmost vertex.
    """

    chain: list[int]
    low: int
    high: int
    latest: int


def triangulate(points: Sequence[Point], rings: Sequence[Sequence[int]]) -> Triangles:
    """Delaunay triangles of the area left of `rings`, which do not meet; `points` are sorted, and all in use."""
    sweep = _Sweep(points)
    for here, (before, after) in sorted(_neighbours(rings).items()):
        sweep.meet(before, here, after)
    make_delaunay(points, sweep.triangles)
    return sweep.triangles


def _neighbours(rings: Sequence[Sequence[int]]) -> dict[int, tuple[int, int]]:
    return {
        here: (before, after)
        for ring in rings
        for before, here, after in zip((ring[-1], *ring[:-1]), ring, (*ring[1:], ring[0]), strict=True)
    }


class _Sweep:
    def __init__(self, points: Sequence[Point]) -> None:
        self.points = points
        self.triangles: Triangles = {}
        self.by_low: dict[int, _Stretch] = {}
        self.by_high: dict[int, _Stretch] = {}

    def meet(self, before: int, here: int, after: int) -> None:
        """Take the next vertex; its side from `before` bounds from below if it goes right, else from above."""
        if before < here < after:
            self._lower(here, after)
        elif after < here < before:
            self._upper(here, before)
        elif here < before:
            left = cross(self.points[before], self.points[here], self.points[after]) > 0
            self._open(here, after, before) if left else self._split(here, after, before)
        elif self.by_low[here] is self.by_high[here]:
            self._clip_low(self.by_low.pop(here).chain, here)
            del self.by_high[here]
        else:
            self._merge(here)

    def _lower(self, here: int, after: int) -> None:
        stretch = self.by_low.pop(here)
        self._clip_low(stretch.chain, here)
        stretch.low, stretch.latest = after, here
        self._enter(stretch)

    def _upper(self, here: int, after: int) -> None:
        stretch = self.by_high.pop(here)
        self._clip_high(stretch.chain, here)
        stretch.high, stretch.latest = after, here
        self._enter(stretch)

    def _open(self, here: int, low: int, high: int) -> None:
        self._enter(_Stretch([here], low, high, here))

    def _split(self, here: int, upper_low: int, lower_high: int) -> None:
        """A point within a stretch sees the latest vertex: the stretch parts along this diagonal."""
        stretch = self._around(here)
        cut = stretch.chain.index(stretch.latest)
        upper = _Stretch(stretch.chain[cut:], upper_low, stretch.high, here)
        del stretch.chain[cut + 1 :]
        stretch.high, stretch.latest = lower_high, here
        self._clip_high(stretch.chain, here)
        self._clip_low(upper.chain, here)
        self._enter(stretch)
        self._enter(upper)

    def _merge(self, here: int) -> None:
        upper, lower = self.by_low.pop(here), self.by_high.pop(here)
        self._clip_high(lower.chain, here)
        self._clip_low(upper.chain, here)
        lower.chain += upper.chain[1:]
        lower.high, lower.latest = upper.high, here
        self._enter(lower)

    def _enter(self, stretch: _Stretch) -> None:
        self.by_low[stretch.low] = stretch
        self.by_high[stretch.high] = stretch

    def _around(self, here: int) -> _Stretch:
        """The stretch that holds a point: above its lower side, below its upper one."""
        p, points = self.points[here], self.points
        for stretch in self.by_low.values():
            chain = stretch.chain
            above = cross(points[chain[0]], points[stretch.low], p) > 0
            if above and cross(points[chain[-1]], points[stretch.high], p) < 0:
                return stretch
        raise AssertionError("rings that do not meet have a stretch around every inner point")

    def _clip_low(self, chain: list[int], here: int) -> None:
        """Cut off what `here`, the new lower end of a chain, sees of it."""
        points, gone = self.points, 0
        while gone + 1 < len(chain) and cross(points[chain[gone]], points[here], points[chain[gone + 1]]) > 0:
            self._add(chain[gone], here, chain[gone + 1])
            gone += 1
        chain[:gone] = [here]

    def _clip_high(self, chain: list[int], here: int) -> None:
        points = self.points
        while len(chain) > 1 and cross(points[chain[-2]], points[here], points[chain[-1]]) > 0:
            self._add(chain[-2], here, chain[-1])
            chain.pop()
        chain.append(here)

    def _add(self, a: int, b: int, c: int) -> None:
        self.triangles[a, b], self.triangles[b, c], self.triangles[c, a] = c, a, b


def make_delaunay(points: Sequence[Point], triangles: Triangles) -> None:
    """Flip diagonals until no triangle's circle holds the corner beyond one (C. L. Lawson 1977). Fat triangles merge
    into fewer and fatter parts than slivers do."""
    waiting = sorted(diagonals(triangles), reverse=True)
    while waiting:
        a, b = waiting.pop()
        c, d = triangles.get((a, b)), triangles.get((b, a))
        if c is None or d is None or in_circle(points[a], points[b], points[c], points[d]) <= 0:
            continue
        del triangles[a, b], triangles[b, a]
        for i, j, k in ((a, d, c), (d, b, c)):
            triangles[i, j], triangles[j, k], triangles[k, i] = k, i, j
        waiting += [(min(side), max(side)) for side in ((c, a), (a, d), (d, b), (b, c))]


def diagonals(triangles: Triangles) -> Iterator[tuple[int, int]]:
    """Sides that two triangles share, each once as (a, b) with a < b."""
    return ((a, b) for a, b in triangles if a < b and (b, a) in triangles)
