"""The outline of a shape as points: its core grown by its radius, corners as arcs."""

from __future__ import annotations

import math

from sandbox.geometry.mass import edge_normals
from sandbox.geometry.sat_rows import Vec
from sandbox.geometry.shapes import Shape

FULL_CIRCLE = 64
"""Points of a full circle."""


def outline_of(shape: Shape) -> list[Vec]:
    """Points (m) counter-clockwise: of a sharp shape its corners, of a round one corners as arcs."""
    core, radius = shape.vertices, shape.radius
    if radius == 0.0:
        return list(core)
    if len(core) == 1:
        return _arc(core[0], radius, 0.0, 2.0 * math.pi)[:-1]
    normals = edge_normals(core)
    points: list[Vec] = []
    for k, vertex in enumerate(core):
        (px, py), (qx, qy) = normals[k - 1], normals[k]
        start = math.atan2(py, px)
        turn = math.atan2(px * qy - py * qx, px * qx + py * qy)
        # Both ends of a line turn by half a circle, which rounding could take the wrong way round.
        points += _arc(vertex, radius, start, abs(turn))
    return points


def _arc(center: Vec, radius: float, start: float, turn: float) -> list[Vec]:
    count = max(math.ceil(FULL_CIRCLE * turn / (2.0 * math.pi)), 1)
    angles = [start + turn * k / count for k in range(count + 1)]
    return [(center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle)) for angle in angles]
