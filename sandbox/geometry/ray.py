"""Where a ray enters a rounded convex core.

The surface is every edge moved out by the radius, and an arc around every vertex. A ray that only grazes it, or ends on
it, hits: whatever the rounding of the floats could hide counts as touched (`slack`), so that nothing is missed.
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.tables import Records

MISS = -1.0
_RAY_ROUNDING = 1.8e-15
"""Share of the lengths involved by which the arithmetic of a ray may be off: eight units in the last place."""

_NO_WAY = 1e-200
"""Square of the length, in m^2, of a ray that leads nowhere: it is shorter than any slack, and might underflow."""


@kernel
def ray_slack(ox: float, oy: float, dx: float, dy: float, extent: float) -> float:
    """What rounding may hide, in metres, of a ray from (ox, oy) along (dx, dy) against a core of that extent."""
    return _RAY_ROUNDING * (abs(ox) + abs(oy) + abs(dx) + abs(dy) + extent)


@kernel
def ray_enters(
    cores: Records,
    start: int,
    count: int,
    radius: float,
    ox: float,
    oy: float,
    dx: float,
    dy: float,
    slack: float,
) -> tuple[float, float, float]:
    """(fraction of the way (dx, dy) from (ox, oy) at which a ray enters a core, outward normal x, y there).

    The fraction is `MISS` when it does not. The origin is farther than `slack` metres from the shape: see
    `signed_distance`. All in the frame of the core.
    """
    square = dx * dx + dy * dy
    length = math.sqrt(square)
    if square < _NO_WAY or _passes_by(cores, start, count, ox, oy, dx, dy, (radius + slack) * length):
        return MISS, 0.0, 0.0
    end = 1.0 + slack / length
    t, nx, ny = _enters_edge(cores, start, count, radius, ox, oy, dx, dy, slack, end)
    if t == MISS:
        t, nx, ny = _enters_corner(cores, start, count, radius, ox, oy, dx, dy, length, slack, end)
    return t if t < 1.0 else 1.0, nx, ny


@kernel
def _passes_by(
    cores: Records, start: int, count: int, ox: float, oy: float, dx: float, dy: float, reach: float
) -> bool:
    """The separating axis across the ray: whether all vertices lie on one side of its line, `reach` / length away."""
    left = True
    right = True
    for i in range(start, start + count):
        side = dx * (cores[i].y - oy) - dy * (cores[i].x - ox)
        left = left and side > reach
        right = right and side < -reach
    return left or right


@kernel
def _enters_edge(
    cores: Records,
    start: int,
    count: int,
    radius: float,
    ox: float,
    oy: float,
    dx: float,
    dy: float,
    slack: float,
    end: float,
) -> tuple[float, float, float]:
    """Entry through one of the moved edges: a convex shape has but one."""
    for i in range(count if count > 1 else 0):
        p = cores[start + i]
        speed = p.normal_x * dx + p.normal_y * dy
        if speed >= 0.0:
            continue
        gap = p.normal_x * (ox - p.x) + p.normal_y * (oy - p.y) - radius
        if gap < -slack or gap > -speed * end:
            continue
        t = gap / -speed if gap > 0.0 else 0.0
        q = cores[start + i + 1 if i + 1 < count else start]
        ex = q.x - p.x
        ey = q.y - p.y
        along = (ox + t * dx - p.x) * ex + (oy + t * dy - p.y) * ey
        room = slack * (abs(ex) + abs(ey))
        if -room <= along <= ex * ex + ey * ey + room:
            return t, p.normal_x, p.normal_y
    return MISS, 0.0, 0.0


@kernel
def _enters_corner(
    cores: Records,
    start: int,
    count: int,
    radius: float,
    ox: float,
    oy: float,
    dx: float,
    dy: float,
    length: float,
    slack: float,
    end: float,
) -> tuple[float, float, float]:
    """Entry through the first of the arcs around the vertices; those of sharp corners are as small as rounding."""
    best = end
    corner = -1
    square = length * length
    for i in range(count):
        x = ox - cores[start + i].x
        y = oy - cores[start + i].y
        side = (dx * y - dy * x) / length
        if abs(side) > radius + slack:
            continue
        across = radius * radius - side * side
        half = math.sqrt(across) / length if across > 0.0 else 0.0
        t = -(x * dx + y * dy) / square - half
        if t >= 0.0 and (t < best or (corner < 0 and t == best)):
            best = t
            corner = i
    if corner < 0:
        return MISS, 0.0, 0.0
    nx, ny = _corner_normal(cores, start, count, corner, radius, ox + best * dx, oy + best * dy, dx, dy, length, slack)
    return best, nx, ny


@kernel
def _corner_normal(
    cores: Records,
    start: int,
    count: int,
    corner: int,
    radius: float,
    x: float,
    y: float,
    dx: float,
    dy: float,
    length: float,
    slack: float,
) -> tuple[float, float]:
    """Normal where (x, y) on a ray meets the arc around a vertex. At a sharp corner: of the side that faces the ray."""
    v = cores[start + corner]
    nx = -dx / length
    ny = -dy / length
    if radius > slack:
        rx = x - v.x
        ry = y - v.y
        distance = math.sqrt(rx * rx + ry * ry)
        if distance > 0.0:
            return rx / distance, ry / distance
        return nx, ny
    before = cores[start + corner - 1 if corner > 0 else start + count - 1]
    own = v.normal_x * dx + v.normal_y * dy
    other = before.normal_x * dx + before.normal_y * dy
    side = before if other < own else v
    if (other if other < own else own) < -_RAY_ROUNDING * length:
        nx = side.normal_x
        ny = side.normal_y
    return nx, ny
