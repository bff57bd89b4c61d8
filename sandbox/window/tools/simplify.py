"""A freehand stroke with fewer points, near to what was drawn."""

from __future__ import annotations

import math
from collections.abc import Sequence

from sandbox.render.camera import Vec


def simplified(points: Sequence[Vec], tolerance: float, closed: bool) -> list[Vec]:
    """Some of `points` so that the line through them is nowhere farther than `tolerance` (m) from the others.

    The method of Douglas and Peucker (1973), without recursion. Of a `closed` stroke, the last point goes if it lies on
    the first.
    """
    points = list(points)
    if closed and len(points) > 3 and math.dist(points[0], points[-1]) <= 4.0 * tolerance:
        points.pop()
    if closed and len(points) > 3:
        # From the first point to the one farthest from it and back: a closed stroke has no two ends to begin with.
        far = max(range(len(points)), key=lambda i: math.dist(points[0], points[i]))
        return [*_thinned(points[: far + 1], tolerance)[:-1], *_thinned([*points[far:], points[0]], tolerance)[:-1]]
    return _thinned(points, tolerance)


def _thinned(points: list[Vec], tolerance: float) -> list[Vec]:
    kept = {0, len(points) - 1}
    spans = [(0, len(points) - 1)]
    while spans:
        first, last = spans.pop()
        far = max(range(first + 1, last), key=lambda i: _off(points[i], points[first], points[last]), default=None)
        if far is not None and _off(points[far], points[first], points[last]) > tolerance:
            kept.add(far)
            spans += [(first, far), (far, last)]
    return [points[i] for i in sorted(kept)]


def _off(point: Vec, start: Vec, end: Vec) -> float:
    """Distance (m) of a point from the line between two others."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    square = dx * dx + dy * dy
    along = 0.0 if square == 0.0 else ((point[0] - start[0]) * dx + (point[1] - start[1]) * dy) / square
    share = min(max(along, 0.0), 1.0)
    return math.dist(point, (start[0] + share * dx, start[1] + share * dy))
