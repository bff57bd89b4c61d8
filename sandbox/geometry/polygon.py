"""Turns a polygon as an author wrote it into a clean convex one, or says what is wrong with it.

All decisions are exact: coordinates are scaled to integers first, so that no rounding can turn a corner
round. A vertex on the straight line between its neighbours (nearer than the polygon's size / `STRAIGHT`) is
dropped, as is a vertex that repeats the one before it, or the first one at the end of the ring.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise

from sandbox.errors import ShapeError
from sandbox.geometry.exact import Point, between, cross, crossing, scaled, span

Vec = tuple[float, float]

MIN_EDGE = 1e-6
"""Shortest edge and smallest thickness of a polygon in metres."""

MAX_VERTICES = 64
"""Most vertices of a polygon: the feature ids of contacts count by it."""

STRAIGHT = 10**9
"""A corner of a scene's polygon flatter than its size divided by this is no corner, and a dent no dent."""


class PolygonError(ShapeError):
    """A polygon cannot be used. `index` is the vertex to look at, as the author counted, or None.

    `hole` is the hole that the vertex belongs to; None if it is the outline's.
    """

    def __init__(self, message: str, index: int | None = None, hole: int | None = None) -> None:
        super().__init__(message)
        self.index, self.hole = index, hole


class ConcaveError(PolygonError):
    """A polygon is sound, but not convex."""


def convex_polygon(vertices: Sequence[Vec]) -> tuple[Vec, ...]:
    """The polygon's corners counter-clockwise, beginning with the first corner given.

    `vertices` are (x, y) in metres in either winding; finite. Raises `PolygonError` when the polygon is
    degenerate, intersects itself, is concave, or has an edge shorter than `MIN_EDGE`.
    """
    return tuple((float(vertices[i][0]), float(vertices[i][1])) for i in convex_corners(vertices))


def convex_corners(vertices: Sequence[Vec], straight: int = STRAIGHT) -> tuple[int, ...]:
    """Which of `vertices` are the corners of `convex_polygon`, counter-clockwise.

    A corner flatter than the size divided by `straight` is dropped.
    """
    return _convex(tuple((float(x), float(y)) for x, y in vertices), straight)


def is_clockwise(vertices: Sequence[Vec]) -> bool:
    """Whether the author went round a convex polygon clockwise. Raises `PolygonError` as `convex_polygon` does."""
    corners = convex_corners(vertices)
    return sum(before > after for before, after in pairwise([*corners, corners[0]])) > 1


@lru_cache(maxsize=256)
def _convex(vertices: tuple[Vec, ...], straight: int) -> tuple[int, ...]:
    points, unit = scaled(vertices)
    kept = corners_of(points, straight)
    if len(kept) < 3 or on_one_line(points):
        raise PolygonError("the polygon has no area: its vertices lie on one line")
    turns = _turns(points, kept)
    if not _goes_round_once(points, kept, turns):
        raise _why_not_convex(points, kept, turns)
    _check_size(points, kept, unit)
    if turns[0] < 0:
        kept = [kept[0], *reversed(kept[1:])]
    return tuple(kept)


def corners_of(points: list[Point], straight: int = STRAIGHT) -> list[int]:
    """Indices of the vertices left once repeated and straight ones are dropped."""
    kept = [i for i in range(len(points)) if i == 0 or points[i] != points[i - 1]]
    while len(kept) > 1 and points[kept[-1]] == points[kept[0]]:
        kept.pop()
    size = span(points)
    winding = _double_area(points, kept)
    place = 0
    while place < len(kept) >= 3:
        before, here, after = kept[place - 1], kept[place], kept[(place + 1) % len(kept)]
        if is_straight(points[before], points[here], points[after], size, winding, straight):
            del kept[place]
            # Only the neighbours can have become straight by that; the one after the last is the first.
            place = max(place - 1, 0) if place < len(kept) else 0
        else:
            place += 1
    return kept


def is_straight(before: Point, here: Point, after: Point, size: int, winding: int, straight: int = STRAIGHT) -> bool:
    """Whether `here` lies on the way from `before` to `after`; a shallow dent is never a corner."""
    if before == after or not between(before, here, after):
        return False
    turn = cross(before, here, after)
    share = straight if turn * winding > 0 else min(straight, STRAIGHT)
    length_squared = (after[0] - before[0]) ** 2 + (after[1] - before[1]) ** 2
    return (turn * share) ** 2 <= length_squared * size**2


def on_one_line(points: list[Point]) -> bool:
    """Whether all points lie on one line."""
    first = points[0]
    far = max(points, key=lambda p: (p[0] - first[0]) ** 2 + (p[1] - first[1]) ** 2)
    return all(cross(first, far, point) == 0 for point in points)


def _double_area(points: list[Point], kept: list[int]) -> int:
    """Twice the area, positive if the outline runs counter-clockwise."""
    return sum(cross(points[kept[0]], points[a], points[b]) for a, b in pairwise(kept))


def _turns(points: list[Point], kept: list[int]) -> list[int]:
    """Sign of the turn at each kept vertex: 1 left, -1 right, 0 back on itself."""
    count = len(kept)
    triples = ((kept[i - 1], kept[i], kept[(i + 1) % count]) for i in range(count))
    values = (cross(points[a], points[b], points[c]) for a, b, c in triples)
    return [(value > 0) - (value < 0) for value in values]


def _goes_round_once(points: list[Point], kept: list[int], turns: list[int]) -> bool:
    """Whether all turns go one way and the outline closes after one round (a pentagram takes two)."""
    if any(turn != turns[0] or turn == 0 for turn in turns):
        return False
    ring = [points[i] for i in [*kept, kept[0], kept[1]]]
    rising = [after > before for before, after in pairwise(ring)]
    return sum(a != b for a, b in pairwise(rising)) == 2


def _why_not_convex(points: list[Point], kept: list[int], turns: list[int]) -> PolygonError:
    hit = _self_intersection(points, kept)
    if hit is not None:
        return PolygonError("the polygon intersects itself", hit)
    left = _double_area(points, kept) > 0
    dent = next(i for i, turn in zip(kept, turns, strict=True) if (turn > 0) != left)
    return ConcaveError("the polygon is concave; only a shape of a scene can be that", dent)


def _self_intersection(points: list[Point], kept: list[int]) -> int | None:
    """The first vertex whose outgoing edge meets an edge that is not its neighbour or folds back, if any."""
    edges = [(kept[i], kept[(i + 1) % len(kept)]) for i in range(len(kept))]
    for i, (a, b) in enumerate(edges):
        after = edges[(i + 1) % len(edges)][1]
        if cross(points[a], points[b], points[after]) == 0:
            return b
        for j in range(i + 2, len(edges) - (i == 0)):
            c, d = edges[j]
            if crossing(points[a], points[b], points[c], points[d]):
                return a
    return None


def _check_size(points: list[Point], kept: list[int], unit: int) -> None:
    """Refuse edges and slivers too small for the arithmetic of a step. `unit` is the integer of one metre."""
    least = unit // round(1 / MIN_EDGE)
    ring = [*kept, kept[0]]
    for a, b in pairwise(ring):
        if (points[a][0] - points[b][0]) ** 2 + (points[a][1] - points[b][1]) ** 2 < least**2:
            raise PolygonError(f"two vertices of the polygon are less than {MIN_EDGE:g} m apart", b)
    if abs(_double_area(points, kept)) < 2 * least * span(points):
        raise PolygonError(f"the polygon has no area: it is thinner than {MIN_EDGE:g} m")
