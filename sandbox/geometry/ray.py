"""Where a ray enters a rounded convex core.

The surface is every edge moved out by the radius, and an arc around every vertex. A ray that only grazes it, or ends on
it, hits: whatever the rounding of the floats could hide counts as touched (`slack`), so that nothing is missed.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from sandbox._jit import kernel
from sandbox.geometry.core import CoreRows
from sandbox.tables import Records

MISS = -1.0
_RAY_ROUNDING = 1.8e-15
"""Share of the lengths involved by which the arithmetic of a ray may be off: eight units in the last place."""

_NOWHERE = 1e-200
"""Square of the length, in m^2, of a ray that leads nowhere: it is shorter than any slack, and might underflow."""


class _Ray(NamedTuple):
    """From (x, y) along (dx, dy), metres; `slack` is what rounding may hide, `end` the fraction at which it is over."""

    x: float
    y: float
    dx: float
    dy: float
    length: float
    slack: float
    end: float


@kernel
def ray_slack(ox: float, oy: float, dx: float, dy: float, extent: float) -> float:
    """What rounding may hide, in metres, of a ray from (ox, oy) along (dx, dy) against a core of that extent."""
    return _RAY_ROUNDING * (abs(ox) + abs(oy) + abs(dx) + abs(dy) + extent)


@kernel
def ray_enters(
    cores: Records, core: CoreRows, ox: float, oy: float, dx: float, dy: float, slack: float
) -> tuple[float, float, float]:
    """(fraction of the translation (dx, dy) from (ox, oy) at which a ray enters a core, outward normal x, y there).

    The fraction is `MISS` when it does not. The origin is farther than `slack` metres from the shape: see
    `signed_distance`. All in the frame of the core.
    """
    square = dx * dx + dy * dy
    length = math.sqrt(square)
    if square < _NOWHERE or _passes_by(cores, core, ox, oy, dx, dy, (core.radius + slack) * length):
        return MISS, 0.0, 0.0
    ray = _Ray(ox, oy, dx, dy, length, slack, 1.0 + slack / length)
    t, nx, ny = _enters_edge(cores, core, ray)
    if t == MISS:
        t, nx, ny = _enters_corner(cores, core, ray)
    return t if t < 1.0 else 1.0, nx, ny


@kernel
def _passes_by(cores: Records, core: CoreRows, ox: float, oy: float, dx: float, dy: float, reach: float) -> bool:
    """The separating axis across the ray: whether all vertices lie on one side of its line, `reach` / length away."""
    left = True
    right = True
    for i in range(core.start, core.start + core.vertex_count):
        side = dx * (cores[i].y - oy) - dy * (cores[i].x - ox)
        left = left and side > reach
        right = right and side < -reach
    return left or right


@kernel
def _enters_edge(cores: Records, core: CoreRows, ray: _Ray) -> tuple[float, float, float]:
    """Entry through one of the moved edges: a convex shape has but one."""
    for i in range(core.vertex_count if core.vertex_count > 1 else 0):
        p = cores[core.start + i]
        speed = p.normal_x * ray.dx + p.normal_y * ray.dy
        if speed >= 0.0:
            continue
        gap = p.normal_x * (ray.x - p.x) + p.normal_y * (ray.y - p.y) - core.radius
        if gap < -ray.slack or gap > -speed * ray.end:
            continue
        t = gap / -speed if gap > 0.0 else 0.0
        q = cores[core.start + i + 1 if i + 1 < core.vertex_count else core.start]
        ex = q.x - p.x
        ey = q.y - p.y
        along = (ray.x + t * ray.dx - p.x) * ex + (ray.y + t * ray.dy - p.y) * ey
        room = ray.slack * (abs(ex) + abs(ey))
        if -room <= along <= ex * ex + ey * ey + room:
            return t, p.normal_x, p.normal_y
    return MISS, 0.0, 0.0


@kernel
def _enters_corner(cores: Records, core: CoreRows, ray: _Ray) -> tuple[float, float, float]:
    """Entry through the first of the arcs around the vertices; those of sharp corners are as small as rounding."""
    radius = core.radius
    best = ray.end
    corner = -1
    square = ray.length * ray.length
    for i in range(core.vertex_count):
        x = ray.x - cores[core.start + i].x
        y = ray.y - cores[core.start + i].y
        side = (ray.dx * y - ray.dy * x) / ray.length
        if abs(side) > radius + ray.slack:
            continue
        across = radius * radius - side * side
        half = math.sqrt(across) / ray.length if across > 0.0 else 0.0
        t = -(x * ray.dx + y * ray.dy) / square - half
        if t >= 0.0 and (t < best or (corner < 0 and t == best)):
            best = t
            corner = i
    if corner < 0:
        return MISS, 0.0, 0.0
    nx, ny = _corner_normal(cores, core, corner, ray, best)
    return best, nx, ny


@kernel
def _corner_normal(cores: Records, core: CoreRows, corner: int, ray: _Ray, t: float) -> tuple[float, float]:
    """Normal where a ray meets the arc around a vertex, at fraction t; at a sharp corner that of the side it faces."""
    v = cores[core.start + corner]
    nx = -ray.dx / ray.length
    ny = -ray.dy / ray.length
    if core.radius > ray.slack:
        rx = ray.x + t * ray.dx - v.x
        ry = ray.y + t * ray.dy - v.y
        distance = math.sqrt(rx * rx + ry * ry)
        if distance > 0.0:
            return rx / distance, ry / distance
        return nx, ny
    before = cores[core.start + corner - 1 if corner > 0 else core.start + core.vertex_count - 1]
    own = v.normal_x * ray.dx + v.normal_y * ray.dy
    other = before.normal_x * ray.dx + before.normal_y * ray.dy
    side = before if other < own else v
    if (other if other < own else own) < -_RAY_ROUNDING * ray.length:
        nx = side.normal_x
        ny = side.normal_y
    return nx, ny
