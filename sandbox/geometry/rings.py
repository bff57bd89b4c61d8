"""Turns a polygon with holes, as an author wrote it, into clean rings, or says what is wrong with it.

The same rules as for convex polygons hold, and all decisions are exact. Rings keep a distance of `MIN_EDGE` from
themselves and from each other, so that no part of the polygon is thinner than the arithmetic of a step can bear.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise

from sandbox.geometry.exact import Point, cross, crossing, distance_squared, gap_below, scaled, span
from sandbox.geometry.polygon import MIN_EDGE, PolygonError, Vec, corners_of, on_one_line

Side = tuple[int, int, int]
"""Ring, first and second point of one side of a ring."""


@dataclass(frozen=True)
class Rings:
    """A polygon's outline and holes without needless vertices. The interior lies left of every ring.

    `vertices` are all vertices as the author gave them (m), `points` the same as exact integers, `unit` the integer
    of one metre. `rings` are runs of indices into both: the outline counter-clockwise, then the holes clockwise.
    """

    vertices: tuple[Vec, ...]
    points: list[Point]
    unit: int
    rings: tuple[tuple[int, ...], ...]


def clean_rings(outline: Sequence[Vec], holes: Sequence[Sequence[Vec]]) -> Rings:
    """The rings of a polygon; vertices in metres, either winding, finite. Raises `PolygonError`.

    Refused are rings without area, rings that meet themselves or each other, holes outside of the outline or in each
    other, and sides nearer to each other than `MIN_EDGE`.
    """
    given = [outline, *holes]
    vertices = tuple(vertex for ring in given for vertex in ring)
    points, unit = scaled(vertices)
    starts = [0, *accumulate(map(len, given))]
    places = _Places(starts)
    rings = [_ring(points, starts, k, places) for k in range(len(given))]
    _refuse_meetings(points, vertices, rings, unit, places)
    _refuse_strays(points, rings, places)
    turned = tuple(_turned(points, ring, k == 0) for k, ring in enumerate(rings))
    _refuse_slivers(points, turned, unit)
    return Rings(vertices, points, unit, turned)


class _Places:
    """Where a point stands in what the author wrote."""

    def __init__(self, starts: list[int]) -> None:
        self.starts = starts

    def error(self, message: str, ring: int, point: int | None = None) -> PolygonError:
        index = None if point is None else point - self.starts[ring]
        return PolygonError(message, index, ring - 1 if ring else None)


def _name(ring: int) -> str:
    return "hole" if ring else "polygon"


def _ring(points: list[Point], starts: list[int], k: int, places: _Places) -> tuple[int, ...]:
    """Corners of ring k as indices into `points`, in the author's order."""
    own = points[starts[k] : starts[k + 1]]
    kept = corners_of(own)
    if len(kept) < 3 or on_one_line(own):
        raise places.error(f"the {_name(k)} has no area: its vertices lie on one line", k)
    return tuple(starts[k] + i for i in kept)


def _turned(points: list[Point], ring: tuple[int, ...], left: bool) -> tuple[int, ...]:
    """The ring from its first corner on, counter-clockwise or not."""
    return ring if (_double_area(points, ring) > 0) == left else (ring[0], *reversed(ring[1:]))


def _double_area(points: list[Point], ring: Sequence[int]) -> int:
    return sum(cross(points[ring[0]], points[a], points[b]) for a, b in pairwise(ring))


def _refuse_meetings(
    points: list[Point], vertices: Sequence[Vec], rings: Sequence[Sequence[int]], unit: int, at: _Places
) -> None:
    least = unit // round(1 / MIN_EDGE)
    sides = [(k, a, b) for k, ring in enumerate(rings) for a, b in zip(ring, (*ring[1:], ring[0]), strict=True)]
    after = {a: b for _, a, b in sides}
    for k, a, b in sides:
        if distance_squared(points[a], points[b]) < least**2:
            raise at.error(f"two vertices of the {_name(k)} are less than {MIN_EDGE:g} m apart", k, b)
        if cross(points[a], points[b], points[after[b]]) == 0:
            raise at.error(f"the {_name(k)} intersects itself", k, b)
    for i, j in _near(vertices, sides):
        (k, a, b), (m, c, d) = sides[i], sides[j]
        if crossing(points[a], points[b], points[c], points[d]):
            raise at.error(_meeting(k, m), m, c if m > k else a)
        if gap_below(points[a], points[b], points[c], points[d], least):
            raise at.error(f"two sides are less than {MIN_EDGE:g} m apart", m, c if m > k else a)


def _meeting(k: int, m: int) -> str:
    if k == m:
        return f"the {_name(k)} intersects itself"
    return "the hole meets another hole" if min(k, m) else "the hole meets the polygon's outline"


def _near(vertices: Sequence[Vec], sides: list[Side]) -> list[tuple[int, int]]:
    """Pairs i < j of sides that are not neighbours, and whose boxes, widened by more than `MIN_EDGE`, overlap.

    Sorted; found by a sweep over the boxes from left to right.
    """
    found: list[tuple[int, int]] = []
    open_boxes: list[tuple[float, float, float, int]] = []
    for left, right, low, high, j in sorted(_box(vertices, side, j) for j, side in enumerate(sides)):
        open_boxes = [box for box in open_boxes if box[0] >= left]
        for _, other_low, other_high, i in open_boxes:
            if low <= other_high and other_low <= high and sides[i][2] != sides[j][1] and sides[j][2] != sides[i][1]:
                found.append((min(i, j), max(i, j)))
        open_boxes.append((right, low, high, j))
    return sorted(found)


def _box(vertices: Sequence[Vec], side: Side, number: int) -> tuple[float, float, float, float, int]:
    (ax, ay), (bx, by) = vertices[side[1]], vertices[side[2]]
    near = 2 * MIN_EDGE
    return min(ax, bx) - near, max(ax, bx) + near, min(ay, by) - near, max(ay, by) + near, number


def _refuse_strays(points: list[Point], rings: Sequence[Sequence[int]], places: _Places) -> None:
    """Sides do not meet here, so one point tells where a whole ring lies."""
    for k in range(1, len(rings)):
        first = rings[k][0]
        if not _is_inside(points, rings[0], first):
            raise places.error("the hole lies outside of the polygon", k, first)
        for m in range(1, len(rings)):
            if m != k and _is_inside(points, rings[m], first):
                raise places.error("the hole lies in another hole", k, first)


def _is_inside(points: list[Point], ring: Sequence[int], point: int) -> bool:
    """Whether a point that is not on a ring lies in it: how often does a ray to the right cross the ring?"""
    x, y = points[point]
    inside = False
    for a, b in zip(ring, (*ring[1:], ring[0]), strict=True):
        low, high = (points[a], points[b]) if points[a][1] < points[b][1] else (points[b], points[a])
        if low[1] <= y < high[1] and cross(low, high, (x, y)) > 0:
            inside = not inside
    return inside


def _refuse_slivers(points: list[Point], rings: Sequence[Sequence[int]], unit: int) -> None:
    doubled = sum(_double_area(points, ring) for ring in rings)
    if doubled < 2 * (unit // round(1 / MIN_EDGE)) * span(points):
        raise PolygonError(f"the polygon has no area: it is thinner than {MIN_EDGE:g} m")
