"""Area, centroid and second moment of a convex core with a rounding radius, in closed form.

The shape is the core, one rectangle along every edge and one disc sector at every vertex. Circle and capsule are
the cores of one and two vertices, so one function serves all kinds.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from sandbox._jit import interpreted
from sandbox.geometry.trig import PI, arctan2

_arctan2 = interpreted(arctan2)
Vec = tuple[float, float]


class Moments(NamedTuple):
    """Area (m^2), first moments (m^3) and polar second moment (m^4), all about the frame's origin."""

    area: float
    first_x: float
    first_y: float
    second: float

    def plus(self, other: Moments) -> Moments:
        """Sum of two parts."""
        return Moments(*(a + b for a, b in zip(self, other, strict=True)))


def edge_normals(vertices: Sequence[Vec]) -> list[Vec]:
    """Outward unit normal of each edge of a counter-clockwise core; (0, 0) for a single vertex."""
    if len(vertices) == 1:
        return [(0.0, 0.0)]
    normals = []
    for (x0, y0), (x1, y1) in zip(vertices, [*vertices[1:], vertices[0]], strict=True):
        length = math.sqrt((x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0))
        normals.append(((y1 - y0) / length, (x0 - x1) / length))
    return normals


def moments(vertices: Sequence[Vec], radius: float) -> Moments:
    """Moments of the core `vertices` ((x, y) in metres, counter-clockwise) rounded by `radius` metres."""
    normals = edge_normals(vertices)
    total = Moments(0.0, 0.0, 0.0, 0.0)
    for i, vertex in enumerate(vertices):
        after = vertices[(i + 1) % len(vertices)]
        if len(vertices) > 2:
            total = total.plus(_triangle(vertex, after))
        if len(vertices) > 1:
            total = total.plus(_strip(vertex, after, normals[i], radius))
        total = total.plus(_sector(vertex, normals[i - 1], normals[i], radius))
    return total


def _triangle(p: Vec, q: Vec) -> Moments:
    """Triangle of the origin, p and q; signed."""
    twice = p[0] * q[1] - p[1] * q[0]
    square = p[0] * p[0] + p[0] * q[0] + q[0] * q[0] + p[1] * p[1] + p[1] * q[1] + q[1] * q[1]
    return Moments(twice / 2.0, twice * (p[0] + q[0]) / 6.0, twice * (p[1] + q[1]) / 6.0, twice * square / 12.0)


def _strip(p: Vec, q: Vec, normal: Vec, radius: float) -> Moments:
    """Rectangle of width `radius` outside the edge from p to q."""
    length_squared = (q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1])
    area = math.sqrt(length_squared) * radius
    x = (p[0] + q[0]) / 2.0 + normal[0] * radius / 2.0
    y = (p[1] + q[1]) / 2.0 + normal[1] * radius / 2.0
    second = area * (length_squared + radius * radius) / 12.0 + area * (x * x + y * y)
    return Moments(area, area * x, area * y, second)


def _sector(vertex: Vec, before: Vec, after: Vec, radius: float) -> Moments:
    """Disc sector at a vertex, between the normals of the edges before and after it."""
    if before == (0.0, 0.0):
        turn = 2.0 * PI
    else:
        turn = _arctan2(before[0] * after[1] - before[1] * after[0], before[0] * after[0] + before[1] * after[1])
        turn = turn if turn >= 0.0 else turn + 2.0 * PI
    area = radius * radius * turn / 2.0
    cubed = radius * radius * radius / 3.0
    own_x, own_y = cubed * (after[1] - before[1]), cubed * (before[0] - after[0])
    x, y = vertex
    second = radius * radius * radius * radius * turn / 4.0
    second = second + 2.0 * (x * own_x + y * own_y) + area * (x * x + y * y)
    return Moments(area, own_x + area * x, own_y + area * y, second)
