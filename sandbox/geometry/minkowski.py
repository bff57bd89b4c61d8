"""The Minkowski sum of two convex cores, which makes one question of many.

Shape a, moved by (x, y), touches b when the point (x, y) touches the sum of b and a's mirror image. So a shape cast is
a ray against the sum, an overlap a point in it, and a distance that of a point.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.geometry.core import CoreRows
from sandbox.geometry.sat import FAR
from sandbox.tables import Records


@kernel
def add_cores(cores: Records, a: CoreRows, b: CoreRows, target: int) -> int:
    """Write the sum of two cores from row `target` on; return its number of vertices, at most as many as both have.

    The edges of the sum are those of both, in the order of their directions; edges of one direction become one.
    """
    i = _first_edge(cores, a)
    j = _first_edge(cores, b)
    left_a = a.vertex_count if a.vertex_count > 1 else 0
    left_b = b.vertex_count if b.vertex_count > 1 else 0
    count = 0
    while left_a > 0 or left_b > 0 or count == 0:
        p = cores[a.start + i]
        q = cores[b.start + j]
        turn = 1 if left_b == 0 else (-1 if left_a == 0 else _turn(p, q))
        row = cores[target + count]
        row.x = p.x + q.x
        row.y = p.y + q.y
        row.normal_x = p.normal_x if turn >= 0 else q.normal_x
        row.normal_y = p.normal_y if turn >= 0 else q.normal_y
        count += 1
        if turn >= 0 and left_a > 0:
            left_a -= 1
            i = i + 1 if i + 1 < a.vertex_count else 0
        if turn <= 0 and left_b > 0:
            left_b -= 1
            j = j + 1 if j + 1 < b.vertex_count else 0
    return count


@kernel
def _goes_down(row: Records) -> bool:
    """Whether an edge's direction lies in the second half turn, counted from +x; its normal is turned by a quarter."""
    return bool(row.normal_x < 0.0 or (row.normal_x == 0.0 and row.normal_y > 0.0))


@kernel
def _first_edge(cores: Records, core: CoreRows) -> int:
    """The first edge of a core by direction, counted from +x: it begins at the lowest vertex."""
    for i in range(core.vertex_count):
        before = i - 1 if i > 0 else core.vertex_count - 1
        if not _goes_down(cores[core.start + i]) and _goes_down(cores[core.start + before]):
            return i
    return 0


@kernel
def _turn(p: Records, q: Records) -> int:
    """Which of two edges comes first by direction: 1 p, -1 q, 0 both."""
    down_p = _goes_down(p)
    down_q = _goes_down(q)
    if down_p != down_q:
        return -1 if down_p else 1
    cross = p.normal_x * q.normal_y - p.normal_y * q.normal_x
    return 1 if cross > 0.0 else (-1 if cross < 0.0 else 0)


@kernel
def touching_side(cores: Records, core: CoreRows, nx: float, ny: float, slack: float) -> tuple[float, float, float]:
    """Where a core is farthest along a unit direction: (how far, and from where to where along its left-hand tangent).

    Vertices that are farthest to within `slack` metres count.
    """
    far = -FAR
    for i in range(core.start, core.start + core.vertex_count):
        along = nx * cores[i].x + ny * cores[i].y
        far = along if along > far else far
    low = FAR
    high = -FAR
    for i in range(core.start, core.start + core.vertex_count):
        if nx * cores[i].x + ny * cores[i].y >= far - slack:
            across = nx * cores[i].y - ny * cores[i].x
            low = across if across < low else low
            high = across if across > high else high
    return far, low, high
