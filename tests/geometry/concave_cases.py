"""Random simple polygons of many kinds, some with holes, for hypothesis."""

from __future__ import annotations

import math

from hypothesis import strategies as st

from sandbox.geometry.decompose import decompose
from sandbox.geometry.polygon import PolygonError

Ring = list[tuple[float, float]]


@st.composite
def star(draw: st.DrawFn, most: int = 40) -> Ring:
    """Corners at growing angles around the origin, at any distance."""
    count = draw(st.integers(4, most))
    parts = [0.4 * draw(st.floats(0, 1)) for _ in range(count)]
    radii = [draw(st.floats(0.2, 5)) for _ in range(count)]
    turns = [2 * math.pi * (k + part) / count for k, part in enumerate(parts)]
    return [(r * math.cos(t), r * math.sin(t)) for r, t in zip(radii, turns, strict=True)]


@st.composite
def comb(draw: st.DrawFn) -> Ring:
    """Teeth upwards, each as long as it likes; gaps may go down to the back, and gaps may be level with each other."""
    teeth = draw(st.integers(2, 12))
    heights = [draw(st.sampled_from([1.0, 2.0, 2.5, 3.0])) for _ in range(2 * teeth - 1)]
    levels = [height + (4.0 if k % 2 == 0 else 0.0) for k, height in enumerate(heights)]
    top = [point for k, level in enumerate(levels) for point in ((k, level), (k + 1, level))]
    return [(0.0, 0.0), (2 * teeth - 1.0, 0.0), *((float(x), y) for x, y in reversed(top))]


@st.composite
def spiral(draw: st.DrawFn) -> Ring:
    """A band that winds inwards."""
    steps, width = draw(st.integers(6, 30)), draw(st.floats(0.2, 0.8))
    turns = [(k * 0.7, 8.0 - k * 0.11) for k in range(steps)]
    outer = [(r * math.cos(t), r * math.sin(t)) for t, r in turns]
    inner = [((r - width) * math.cos(t), (r - width) * math.sin(t)) for t, r in turns]
    return [*outer, *reversed(inner)]


@st.composite
def untangled_walk(draw: st.DrawFn) -> Ring:
    """Random points joined at random, with crossings undone one by one: each makes the whole way shorter."""
    points = draw(st.lists(st.tuples(st.integers(0, 30), st.integers(0, 30)), min_size=4, max_size=14, unique=True))
    ring = [(float(x), float(y)) for x, y in points]
    for _ in range(200):
        pair = _crossing_pair(ring)
        if pair is None:
            break
        i, j = pair
        ring[i + 1 : j + 1] = reversed(ring[i + 1 : j + 1])
    return ring


def _crossing_pair(ring: Ring) -> tuple[int, int] | None:
    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    count = len(ring)
    for i in range(count):
        a, b = ring[i], ring[(i + 1) % count]
        for j in range(i + 2, count - (i == 0)):
            c, d = ring[j], ring[(j + 1) % count]
            if side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0:
                return i, j
    return None


def is_sound(outline: Ring, holes: list[Ring] | None = None) -> bool:
    """Whether the polygon is one at all; random walks may touch themselves."""
    try:
        decompose(outline, holes or [])
    except PolygonError:
        return False
    return True


simple = st.one_of(star(), comb(), spiral(), untangled_walk()).filter(is_sound)
"""A polygon without holes, most of them concave."""


@st.composite
def with_holes(draw: st.DrawFn) -> tuple[Ring, list[Ring]]:
    """A polygon with up to four holes, each a small star within one convex part of it."""
    outline = draw(simple)
    parts = decompose(outline).parts
    chosen = draw(st.lists(st.integers(0, len(parts) - 1), max_size=4, unique=True))
    holes = []
    for place in chosen:
        corners = parts[place].vertices
        x, y = (sum(corner[k] for corner in corners) / len(corners) for k in (0, 1))
        shape, size = draw(star(8)), 0.1 * _room((x, y), corners)
        ring = [(x + size * u, y + size * v) for u, v in shape]
        if is_sound(outline, [*holes, ring]):
            holes.append(ring)
    return outline, holes


def _room(p: tuple[float, float], corners) -> float:
    """Distance of a point in a convex ring from its nearest side."""
    sides = zip(corners, (*corners[1:], corners[0]), strict=True)
    return min(
        abs((bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax)) / math.hypot(bx - ax, by - ay)
        for (ax, ay), (bx, by) in sides
    )
