"""Whether two cores that are apart are closest at two vertices: the axis that rounded corners add to the test.

Such vertices are ends of the best face of the separating-axis test and of the edge that faces it most: in the Minkowski
difference, the edge farthest from the origin ends in the vertex nearest to it. Rounding (of slivers) and a bias may
choose another face. So two vertices count if each is nearer to the other than the rest of both edges that it ends: they
are in each other's Voronoi regions (M. Lin and J. Canny, "A fast algorithm for incremental distance calculation",
1991). Else brute force finds what is closest.
"""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel, kernel
from sandbox.geometry.closest import closest_points, nearest_on_edge
from sandbox.geometry.core import CoreRows
from sandbox.geometry.sat import FAR, facing_edge
from sandbox.tables import Records


@kernel
def closest_vertices(
    cores: Records, a: CoreRows, b: CoreRows, dx: float, dy: float, flip: bool, face: int, least: float
) -> tuple[bool, int, int, float, float, float]:
    """Whether two disjoint cores are closest at two vertices that are farther apart than `least` metres:
    (yes, vertex of a, vertex of b, axis x, y, distance).

    `face` is the best one of the separating-axis test, of b if `flip`; another one only takes longer. The unit axis
    points from a to b. When a vertex faces the inside of an edge instead, that edge's normal already is the right axis
    and the answer is no.
    """
    square, both, i, j = _closest_of_edges(cores, a, b, dx, dy, flip, face)
    lines = a.vertex_count <= 2 and b.vertex_count <= 2  # they have no other edges
    if square > least * least and not (lines or (both and _nearest_of_all(cores, a, b, dx, dy, i, j))):
        square, _ax, _ay, _bx, _by, both, i, j = closest_points(cores, a, b, dx, dy)
    if not both or square <= least * least:
        return False, 0, 0, 0.0, 0.0, 0.0
    gx = cores[b.start + j].x + dx - cores[a.start + i].x
    gy = cores[b.start + j].y + dy - cores[a.start + i].y
    distance = math.sqrt(gx * gx + gy * gy)
    if distance <= least:
        return False, 0, 0, 0.0, 0.0, 0.0
    return True, i, j, gx / distance, gy / distance, distance


@inlined_kernel
def _closest_of_edges(
    cores: Records, a: CoreRows, b: CoreRows, dx: float, dy: float, flip: bool, face: int
) -> tuple[float, bool, int, int]:
    """Of a face, of b if `flip`, and the other core's edge that faces it: (distance squared, both vertices?, of a, b).

    Of a vertex and the inside of an edge, only one number means something.
    """
    row = cores[b.start + face if flip else a.start + face]
    facing = facing_edge(cores, a if flip else b, row.normal_x, row.normal_y)
    edge_a = facing if flip else face
    edge_b = face if flip else facing
    best = FAR
    both = False
    vertex_a = vertex_b = 0
    for end in range(2):
        j = _end_of(b, edge_b, end)
        vertex = cores[b.start + j]
        square, _x, _y, i, is_vertex = nearest_on_edge(cores, a, edge_a, vertex.x + dx, vertex.y + dy)
        if square < best:
            best, both, vertex_a, vertex_b = square, is_vertex, i, j
    for end in range(2):
        i = _end_of(a, edge_a, end)
        vertex = cores[a.start + i]
        square, _x, _y, j, is_vertex = nearest_on_edge(cores, b, edge_b, vertex.x - dx, vertex.y - dy)
        if square < best:
            best, both, vertex_a, vertex_b = square, is_vertex, i, j
    return best, both, vertex_a, vertex_b


@inlined_kernel
def _nearest_of_all(cores: Records, a: CoreRows, b: CoreRows, dx: float, dy: float, i: int, j: int) -> bool:
    """Whether vertex i of a and vertex j of b are the closest points of the cores."""
    p = cores[a.start + i]
    q = cores[b.start + j]
    return bool(_faces_vertex(cores, a, i, q.x + dx, q.y + dy) and _faces_vertex(cores, b, j, p.x - dx, p.y - dy))


@inlined_kernel
def _faces_vertex(cores: Records, core: CoreRows, i: int, px: float, py: float) -> bool:
    """Whether of both edges that end in vertex i, this is the nearest point to (px, py)."""
    before = cores[core.start + (i - 1 if i > 0 else core.vertex_count - 1)]
    vertex = cores[core.start + i]
    after = cores[core.start + _end_of(core, i, 1)]
    ex = vertex.x - before.x
    ey = vertex.y - before.y
    past = (px - before.x) * ex + (py - before.y) * ey >= ex * ex + ey * ey
    return bool(past & ((px - vertex.x) * (after.x - vertex.x) + (py - vertex.y) * (after.y - vertex.y) <= 0.0))


@inlined_kernel
def _end_of(core: CoreRows, edge: int, end: int) -> int:
    """The vertex that an edge begins with (`end` 0) or ends in (1)."""
    vertex = edge + end
    return vertex if vertex < core.vertex_count else 0
