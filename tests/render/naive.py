"""The slow and obvious twin: distances to shapes straight from the records of a state."""

from __future__ import annotations

import math

from sandbox.world.records import DYNAMIC
from sandbox.world.state import State


def distance(state: State, shape: int, x: float, y: float) -> float:
    """Signed distance in metres of a world point from a shape; negative inside."""
    row = state.shapes[shape]
    body = state.bodies[row.body]
    dx, dy = x - body.center_x, y - body.center_y
    u = body.rotation_cos * dx + body.rotation_sin * dy
    v = body.rotation_cos * dy - body.rotation_sin * dx
    corners = [(p.x, p.y) for p in state.vertices[row.vertex_start : row.vertex_start + row.vertex_count]]
    return _core_distance(corners, u, v) - float(row.radius)


def _core_distance(corners: list[tuple[float, float]], u: float, v: float) -> float:
    nearest, inside = math.inf, len(corners) >= 3
    for i, (bx, by) in enumerate(corners):
        ax, ay = corners[i - 1]
        ex, ey = bx - ax, by - ay
        length = ex * ex + ey * ey
        t = min(max(((u - ax) * ex + (v - ay) * ey) / length, 0.0), 1.0) if length else 0.0
        nearest = min(nearest, math.hypot(u - ax - t * ex, v - ay - t * ey))
        inside = inside and ex * (v - ay) - ey * (u - ax) >= 0.0
    return -nearest if inside else nearest


def topmost(state: State, x: float, y: float) -> int | None:
    """The body of the last dynamic shape that holds the point."""
    found = None
    for shape in range(len(state.shapes)):
        body = int(state.shapes[shape].body)
        if state.bodies[body].type == DYNAMIC and distance(state, shape, x, y) <= 0.0:
            found = body
    return found
