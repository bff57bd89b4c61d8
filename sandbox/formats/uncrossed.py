"""Rings that cross, touch or overlap, themselves or each other, as the outlines and holes of what they enclose.

Sides are cut where they meet, on a grid of whole numbers so that nothing is left to rounding. Of each piece it is
known how often the rings go round what lies to its left and right; those with filling on one side only are the border,
and are followed with the filling on the left. Where borders meet in a point, what is filled is kept apart.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Sequence
from fractions import Fraction

import numpy as np

from sandbox.formats.numbers import Vec
from sandbox.geometry.polygon import MIN_EDGE

_CELLS = 2**28
"""Of the grid, across all rings: products of two of them fit into 64 bits."""
MOST_SIDES = 4000
"""That can be cut apart."""
_AT_ONCE = 256
_ROUNDS = 8
"""Of cutting: a cut moves to the grid, which may make a side meet another one."""
_APART = 4.0 * MIN_EDGE
"""How far a corner is moved inwards at which a border meets itself, m."""

Ring = Sequence[Vec]
Point = tuple[int, int]
Piece = tuple[Point, Point]


def crossing(rings: Sequence[Ring]) -> bool:
    """Whether any sides meet, other than one and the next at the corner between them; there are some."""
    corners, _, _ = _on_grid(rings)
    sides = [side for ring in corners for side in _sides(ring)]
    following = set(_following([len(list(_sides(ring))) for ring in corners]))
    return any(_cuts(*sides[i], *sides[j], shared=(i, j) in following) for i, j in _near(sides))


def uncrossed(rings: Sequence[Ring], even_odd: bool) -> list[tuple[list[Vec], list[list[Vec]]]]:
    """Each outline (m, counter-clockwise) with its holes; nothing, if it would be too many sides."""
    corners, origin, unit = _on_grid(rings)
    pieces = _pieces([side for ring in corners for side in _sides(ring)])
    borders = _followed(_border(pieces, even_odd)) if pieces else []
    found = [[(origin[0] + x * unit, origin[1] + y * unit) for x, y in ring] for ring in borders]
    outlines = sorted((ring for ring in found if _area(ring) > 0.0), key=_area)
    holes: list[list[list[Vec]]] = [[] for _ in outlines]
    for ring in found:
        if _area(ring) < 0.0:
            around = next((k for k, one in enumerate(outlines) if _encloses(one, ring[0])), None)
            if around is not None:
                holes[around].append(_kept_apart(ring))
    return [(_kept_apart(ring), own) for ring, own in zip(outlines, holes, strict=True)]


def _on_grid(rings: Sequence[Ring]) -> tuple[list[list[Point]], Vec, float]:
    xs, ys = ([point[axis] for ring in rings for point in ring] for axis in (0, 1))
    origin = (min(xs), min(ys))
    unit = max(max(xs) - origin[0], max(ys) - origin[1], 1e-9) / _CELLS
    return [[(round((x - origin[0]) / unit), round((y - origin[1]) / unit)) for x, y in ring] for ring in rings], \
        origin, unit  # fmt: skip


def _sides(ring: Sequence[Point]) -> Iterator[Piece]:
    return ((a, b) for a, b in zip(ring, [*ring[1:], ring[0]], strict=True) if a != b)


def _following(counts: list[int]) -> Iterator[tuple[int, int]]:
    start = 0
    for count in counts:
        for k in range(count):
            yield tuple(sorted((start + k, start + (k + 1) % count)))  # type: ignore[misc]
        start += count


def _near(sides: list[Piece]) -> list[tuple[int, int]]:
    """Pairs i < j of sides whose boxes meet."""
    ends = np.array(sides, np.int64).reshape(-1, 2, 2)
    low, high = ends.min(axis=1), ends.max(axis=1)
    found: list[tuple[int, int]] = []
    for start in range(0, len(sides), _AT_ONCE):
        block = slice(start, start + _AT_ONCE)
        meets = ((low[None] <= high[block, None]) & (high[None] >= low[block, None])).all(axis=2)
        rows, columns = np.nonzero(np.triu(meets, start + 1))
        found += zip((rows + start).tolist(), columns.tolist(), strict=True)
    return found


def _cuts(a: Point, b: Point, c: Point, d: Point, shared: bool = False) -> list[Point]:
    """Points at which two sides meet that are no corners of both; of sides that share one as neighbours, no others."""
    one, two = _turn(a, b, c), _turn(a, b, d)
    three, four = _turn(c, d, a), _turn(c, d, b)
    on = [p for p, turn, (s, t) in ((c, one, (a, b)), (d, two, (a, b)), (a, three, (c, d)), (b, four, (c, d)))
          if turn == 0 and _within(p, s, t)]  # fmt: skip
    if on:
        return [p for p in on if not (p in (a, b) and p in (c, d))] if shared else on
    if (one > 0) == (two > 0) or (three > 0) == (four > 0) or 0 in (one, two, three, four):
        return []
    share = Fraction(three, three - four)
    return [(round(a[0] + share * (b[0] - a[0])), round(a[1] + share * (b[1] - a[1])))]


def _pieces(sides: list[Piece]) -> list[Piece]:
    """Sides cut where they meet, so that pieces meet at their ends, or are the same; nothing if they are too many."""
    for _ in range(_ROUNDS):
        if len(sides) > MOST_SIDES:
            return []
        cuts: dict[int, set[Point]] = defaultdict(set)
        for i, j in _near(sides):
            for point in _cuts(*sides[i], *sides[j]):
                for k in (i, j):
                    if point not in sides[k]:
                        cuts[k].add(point)
        if not cuts:
            return sides
        sides = [piece for k, side in enumerate(sides) for piece in _cut(side, cuts.get(k, set()))]
    return []


def _cut(side: Piece, points: set[Point]) -> Iterator[Piece]:
    (x, y), end = side
    ordered = sorted(points, key=lambda point: (point[0] - x) ** 2 + (point[1] - y) ** 2)
    return ((a, b) for a, b in zip([side[0], *ordered], [*ordered, end], strict=True) if a != b)


def _border(pieces: list[Piece], even_odd: bool) -> list[Piece]:
    """Pieces with filling on one side only, turned so that it lies to the left."""
    times: dict[Piece, list[int]] = defaultdict(lambda: [0, 0])
    for a, b in pieces:
        upward = (a[1], a[0]) < (b[1], b[0])
        entry = times[(a, b) if upward else (b, a)]
        entry[0] += 1 if upward else -1
        entry[1] += 1
    ends = np.array(list(times), np.int64)
    weights = np.array([count if even_odd else net for net, count in times.values()], np.int64)
    found: list[Piece] = []
    for k, ((a, b), weight) in enumerate(zip(times, weights.tolist(), strict=True)):
        right = _around(ends, weights, k)
        filled = [(value % 2 == 1) if even_odd else value != 0 for value in (right + weight, right)]
        if filled == [True, False]:
            found.append((a, b))
        elif filled == [False, True]:
            found.append((b, a))
    return found


def _around(ends: np.ndarray, weights: np.ndarray, k: int) -> int:
    """How often the pieces, all of which lead upwards, go round what lies just to the right of piece k.

    Counted along a ray from its middle, to the right; of a level piece, whose right is below it, downwards.
    """
    doubled = 2 * ends - (ends[k, 0] + ends[k, 1])
    across = int(ends[k, 0, 1] == ends[k, 1, 1])  # level: what crosses the ray leads to the right, as others lead up
    a, b = doubled[:, 0], doubled[:, 1]
    start, end = a[:, 1 - across], b[:, 1 - across]
    turn = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    forth, back = (start <= 0) & (end > 0) & (turn > 0), (start > 0) & (end <= 0) & (turn < 0)
    return int(weights[forth].sum() - weights[back].sum())


def _followed(border: list[Piece]) -> list[list[Point]]:
    """The border as rings: at each corner on to the piece that shuts the narrowest part of what is filled."""
    leaving: dict[Point, list[Point]] = defaultdict(list)
    for a, b in border:
        leaving[a].append(b)
    rings: list[list[Point]] = []
    for start in list(leaving):
        while leaving[start]:
            ring = [start, leaving[start][0]]
            while onward := leaving[ring[-1]]:
                turns = [_clockwise(ring[-2], ring[-1], point) for point in onward]
                ring.append(onward.pop(turns.index(min(turns))))
                if ring[-2:] == ring[:2]:
                    break
            rings.append(ring[:-2])
    return [ring for ring in rings if len(ring) > 2]


def _clockwise(before: Point, at: Point, after: Point) -> float:
    """The angle from the way back to the way on, clockwise."""
    back = math.atan2(before[1] - at[1], before[0] - at[0])
    return (back - math.atan2(after[1] - at[1], after[0] - at[0])) % math.tau or math.tau


def _kept_apart(ring: list[Vec]) -> list[Vec]:
    """Corners at which a ring meets itself a little to the left, into what is filled."""
    counts: dict[Vec, int] = defaultdict(int)
    for point in ring:
        counts[point] += 1
    found = []
    for k, point in enumerate(ring):
        if counts[point] > 1:
            back, on = (_angle(point, ring[k - 1]), _angle(point, ring[(k + 1) % len(ring)]))
            middle = back - ((back - on) % math.tau) / 2.0
            point = (point[0] + _APART * math.cos(middle), point[1] + _APART * math.sin(middle))
        found.append(point)
    return found


def _angle(a: Vec, b: Vec) -> float:
    return math.atan2(b[1] - a[1], b[0] - a[0])


def _turn(a: Point, b: Point, c: Point) -> int:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _within(p: Point, a: Point, b: Point) -> bool:
    return min(a[0], b[0]) <= p[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= p[1] <= max(a[1], b[1])


def _area(ring: Ring) -> float:
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, [*ring[1:], ring[0]], strict=True))


def _encloses(ring: Ring, point: Vec) -> bool:
    x, y = point
    inside = False
    for (ax, ay), (bx, by) in zip(ring, [*ring[1:], ring[0]], strict=True):
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
            inside = not inside
    return inside
