"""The slow and obvious twin: distances to shapes straight from the records of a state."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.world.records import DYNAMIC
from sandbox.world.state import State


def distance(state: State, shape: int, x: Any, y: Any) -> Any:
    """Signed distance in metres of a world point, or of many at once, from a shape; negative inside."""
    row = state.shapes[shape]
    body = state.bodies[row.body]
    dx, dy = x - body.center_x, y - body.center_y
    u = body.rotation_cos * dx + body.rotation_sin * dy
    v = body.rotation_cos * dy - body.rotation_sin * dx
    corners = [(p.x, p.y) for p in state.vertices[row.vertex_start : row.vertex_start + row.vertex_count]]
    return _core_distance(corners, u, v) - float(row.radius)


def _core_distance(corners: list[tuple[float, float]], u: Any, v: Any) -> Any:
    nearest, inside = np.inf, len(corners) >= 3
    for i, (bx, by) in enumerate(corners):
        ax, ay = corners[i - 1]
        ex, ey = bx - ax, by - ay
        length = ex * ex + ey * ey
        t = np.clip(((u - ax) * ex + (v - ay) * ey) / length, 0.0, 1.0) if length else 0.0
        nearest = np.minimum(nearest, np.hypot(u - ax - t * ex, v - ay - t * ey))
        inside = inside & (ex * (v - ay) - ey * (u - ax) >= 0.0)
    return np.where(inside, -nearest, nearest)


def topmost(state: State, x: float, y: float) -> int | None:
    """The body of the last dynamic shape that holds the point."""
    found = None
    for shape in range(len(state.shapes)):
        body = int(state.shapes[shape].body)
        if state.bodies[body].type == DYNAMIC and distance(state, shape, x, y) <= 0.0:
            found = body
    return found
