"""How far a point lies from a rounded convex core, and the way out of it."""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.geometry.closest import nearest_on_edges
from sandbox.geometry.core import CoreRows
from sandbox.geometry.sat import FAR
from sandbox.tables import Records


@kernel
def signed_distance(cores: Records, core: CoreRows, px: float, py: float, slack: float) -> tuple[float, float, float]:
    """(distance of a point from a rounded core in metres, outward unit normal x, y at the nearest surface point).

    Negative inside: minus the least way out. The point is in the frame of the core. In the middle, where all ways are
    as long, a disc answers +y and a line its first side. At a corner, to within `slack` metres, it is one of its sides:
    what rounding could make of the direction from there is no direction.
    """
    radius = core.radius
    if core.vertex_count > 2:
        depth, face = _deepest_face(cores, core, px, py)
        if depth <= 0.0:
            side = cores[core.start + face]
            return depth - radius, side.normal_x, side.normal_y
    square, x, y, feature, is_vertex = nearest_on_edges(cores, core, px, py)
    distance = math.sqrt(square)
    edge = cores[core.start + feature]
    if is_vertex:
        if distance > (slack if core.vertex_count > 1 else 0.0):
            return distance - radius, (px - x) / distance, (py - y) / distance
        return distance - radius, edge.normal_x, edge.normal_y if core.vertex_count > 1 else 1.0
    # The other side of a line, or of a sliver so thin that both its sides are as near.
    if edge.normal_x * (px - x) + edge.normal_y * (py - y) < (0.0 if core.vertex_count == 2 else -slack):
        return distance - radius, -edge.normal_x, -edge.normal_y
    return distance - radius, edge.normal_x, edge.normal_y


@kernel
def _deepest_face(cores: Records, core: CoreRows, px: float, py: float) -> tuple[float, int]:
    """(largest distance of the point over all faces, that face): negative when the point is inside."""
    most = -FAR
    face = 0
    for i in range(core.vertex_count):
        row = cores[core.start + i]
        distance = row.normal_x * (px - row.x) + row.normal_y * (py - row.y)
        if distance > most:
            most = distance
            face = i
    return most, face
