"""Closest points of two convex cores that are apart, by brute force."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.geometry.core import CoreRows
from sandbox.geometry.sat import FAR
from sandbox.tables import Records


@inlined_kernel
def nearest_on_edge(
    cores: Records, core: CoreRows, i: int, px: float, py: float
) -> tuple[float, float, float, int, bool]:
    """As `nearest_on_edges`, on edge i alone."""
    after = i + 1 if i + 1 < core.vertex_count else 0
    p = cores[core.start + i]
    q = cores[core.start + after]
    ex = q.x - p.x
    ey = q.y - p.y
    along = (px - p.x) * ex + (py - p.y) * ey
    length = ex * ex + ey * ey
    feature = i
    is_vertex = True
    x = p.x
    y = p.y
    if along >= length and length > 0.0:
        feature = after
        x = q.x
        y = q.y
    elif along > 0.0:
        t = along / length
        is_vertex = False
        x = p.x + t * ex
        y = p.y + t * ey
    return (px - x) * (px - x) + (py - y) * (py - y), x, y, feature, is_vertex


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
        square, x, y, index, at_vertex = nearest_on_edge(cores, core, i, px, py)
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

    Points are measured from the centre of a. Each vertex is held against each edge: exact. `closest_vertices` does
    with fewer nearly always.
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
