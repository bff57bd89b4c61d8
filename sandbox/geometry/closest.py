"""Closest features of two separated cores: the axis that rounded corners add to the test."""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.geometry.core import CoreRows
from sandbox.geometry.sat import FAR
from sandbox.tables import Records


@kernel
def nearest_on_edges(cores: Records, core: CoreRows, px: float, py: float) -> tuple[float, float, float, int, bool]:
    """Nearest point of a core's boundary to (px, py): (distance squared, x, y, vertex or edge, is it a vertex).

    The point is in the frame of the core.
    """
    best = FAR
    best_x = 0.0
    best_y = 0.0
    feature = 0
    is_vertex = True
    edges = core.vertex_count if core.vertex_count > 2 else 1
    for i in range(edges):
        after = i + 1 if i + 1 < core.vertex_count else 0
        p = cores[core.start + i]
        q = cores[core.start + after]
        ex = q.x - p.x
        ey = q.y - p.y
        wx = px - p.x
        wy = py - p.y
        along = wx * ex + wy * ey
        length = ex * ex + ey * ey
        index = i
        at_vertex = True
        x = p.x
        y = p.y
        if along >= length and length > 0.0:
            index = after
            x = q.x
            y = q.y
        elif along > 0.0:
            t = along / length
            at_vertex = False
            x = p.x + t * ex
            y = p.y + t * ey
        square = (px - x) * (px - x) + (py - y) * (py - y)
        if square < best:
            best = square
            best_x = x
            best_y = y
            feature = index
            is_vertex = at_vertex
    return best, best_x, best_y, feature, is_vertex


@kernel
def closest_points(
    cores: Records, a: CoreRows, b: CoreRows, dx: float, dy: float
) -> tuple[float, float, float, float, float, bool, int, int]:
    """Closest points of two disjoint cores: (distance squared, x, y on a, x, y on b, both vertices?, which of a, of b).

    Points are measured from the centre of a. Brute force over vertex and edge: exact, and only met by rounded shapes
    whose cores do not overlap, and by those who ask for a distance.
    """
    best = FAR
    ax = 0.0
    ay = 0.0
    bx = 0.0
    by = 0.0
    both = False
    vertex_a = 0
    vertex_b = 0
    for j in range(b.vertex_count):
        px = cores[b.start + j].x + dx
        py = cores[b.start + j].y + dy
        square, x, y, feature, is_vertex = nearest_on_edges(cores, a, px, py)
        if square < best:
            best = square
            ax = x
            ay = y
            bx = px
            by = py
            both = is_vertex
            vertex_a = feature
            vertex_b = j
    for i in range(a.vertex_count):
        px = cores[a.start + i].x
        py = cores[a.start + i].y
        square, x, y, feature, is_vertex = nearest_on_edges(cores, b, px - dx, py - dy)
        if square < best:
            best = square
            ax = px
            ay = py
            bx = x + dx
            by = y + dy
            both = is_vertex
            vertex_a = i
            vertex_b = feature
    return best, ax, ay, bx, by, both, vertex_a, vertex_b


@kernel
def closest_vertices(
    cores: Records, a: CoreRows, b: CoreRows, dx: float, dy: float
) -> tuple[bool, int, int, float, float, float]:
    """Whether two disjoint cores are closest at two vertices: (yes, vertex of a, vertex of b, axis x, y, distance).

    The unit axis points from a to b. When a vertex faces the inside of an edge instead, the face normals of the
    separating-axis test already hold the right axis and the answer is no.
    """
    best, _ax, _ay, _bx, _by, both, vertex_a, vertex_b = closest_points(cores, a, b, dx, dy)
    if not both or best <= 0.0:
        return False, 0, 0, 0.0, 0.0, 0.0
    gx = cores[b.start + vertex_b].x + dx - cores[a.start + vertex_a].x
    gy = cores[b.start + vertex_b].y + dy - cores[a.start + vertex_a].y
    distance = math.sqrt(gx * gx + gy * gy)
    if distance <= 0.0:
        return False, 0, 0, 0.0, 0.0, 0.0
    return True, vertex_a, vertex_b, gx / distance, gy / distance, distance
