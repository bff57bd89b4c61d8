"""What the whole is of which a shape is a part: which stretches of its edges show, which directions lead out.

The parts are those of a concave polygon, the links of a chain, or abutting static tiles. At a convex corner the legal
directions are those of its normal cone (the Voronoi region of the vertex).
"""

from __future__ import annotations

import math
from typing import NamedTuple

from sandbox._jit import kernel
from sandbox.geometry.core import core_of
from sandbox.geometry.sat import support_vertex
from sandbox.tables import Records

_SLANT = 1e-3
"""Sine of the angle by which an axis may lie outside of the normals of a corner."""
BEYOND = 1e-6
"""Share of an edge by which a point may lie beyond its end."""


class EdgeTables(NamedTuple):
    """What internal edges are decided by; `cores` are the vertices in world axes, from the centres of the bodies. A
    metre is so many units of length."""

    bodies: Records
    shapes: Records
    cores: Records
    seams: Records
    units_per_meter: float


@kernel
def faces_out(
    tables: EdgeTables, part: Records, x: float, y: float, nx: float, ny: float, near: float, lean: float, m: Records
) -> bool:
    """Whether the direction n leads out of the whole polygon at the farthest vertex, or edge, of a part along it.

    An edge may lie askew by an angle with the sine `lean`: it has yet to lie down.
    """
    k = support_vertex(tables.cores, core_of(part), -nx, -ny)
    if _is_between(tables.bodies[part.body], tables.seams[part.seam_start + k], nx, ny):
        return True
    before = k - 1 if k > 0 else part.vertex_count - 1
    for edge in (before, k):
        row = tables.cores[part.vertex_start + edge]
        flat = abs(row.normal_x * ny - row.normal_y * nx) <= _SLANT + lean
        if flat and row.normal_x * nx + row.normal_y * ny > 0.0 and shows(tables, part, edge, x, y, near, m):
            return True
    return False


@kernel
def _is_between(body: Records, corner: Records, nx: float, ny: float) -> bool:
    """Whether the direction n lies between the normals of the sides that meet in a corner of the whole polygon.

    At a dent there is no way between: only the two normals themselves lead out. At the free end of a line they are
    opposite, and all directions that lead away from it lie between.
    """
    x = body.rotation_cos * nx + body.rotation_sin * ny
    y = body.rotation_cos * ny - body.rotation_sin * nx
    past = corner.before_x * y - corner.before_y * x
    short = x * corner.after_y - y * corner.after_x
    if corner.before_x == -corner.after_x and corner.before_y == -corner.after_y:
        return bool(past >= -_SLANT and corner.before_x * corner.before_x + corner.before_y * corner.before_y > 0.0)
    if corner.before_x * corner.after_y - corner.before_y * corner.after_x > 0.0:
        ahead = x * (corner.before_x + corner.after_x) + y * (corner.before_y + corner.after_y)
        return bool(past >= -_SLANT and short >= -_SLANT and ahead > 0.0)
    on_before = abs(past) <= _SLANT and x * corner.before_x + y * corner.before_y > 0.0
    return bool(on_before or (abs(short) <= _SLANT and x * corner.after_x + y * corner.after_y > 0.0))


@kernel
def shows(tables: EdgeTables, part: Records, edge: int, x: float, y: float, near: float, m: Records) -> bool:
    """Whether a point of the manifold lies where an edge of a part is the surface of the whole polygon.

    (x, y) leads from the centre of the manifold's shape a to that of the part's body. Without points, whether it is the
    surface anywhere. Where an edge ends within the whole, in a nook, it is taken to go on for `near` metres: what lies
    there has sunk in a little.
    """
    seam = tables.seams[part.seam_start + edge]
    if seam.shown_to < seam.shown_from or m.point_count == 0:
        return bool(seam.shown_from <= seam.shown_to)
    share = near / _length(tables.cores, part, edge)
    low = seam.shown_from - (share if seam.shown_from > 0.0 else BEYOND)
    high = seam.shown_to + (share if seam.shown_to < 1.0 else BEYOND)
    first = along_edge(tables.cores, part, edge, m.x1 - x, m.y1 - y)
    if low <= first <= high:
        return True
    if m.point_count < 2:
        return False
    second = along_edge(tables.cores, part, edge, m.x2 - x, m.y2 - y)
    return bool((second if second > first else first) >= low and (second if second < first else first) <= high)


@kernel
def is_past_end(tables: EdgeTables, part: Records, edge: int, x: float, y: float, m: Records) -> bool:
    """Whether point 1 of a manifold lies past the end of an edge where that ends in a corner which juts out.

    There the normal of the edge leads out as well, being the first of the corner's own.
    """
    along = along_edge(tables.cores, part, edge, m.x1 - x, m.y1 - y)
    seam = tables.seams[part.seam_start + edge]
    k = edge
    if along > 1.0:
        k = edge + 1 if edge + 1 < part.vertex_count else 0
        if seam.shown_to < 1.0:
            return False
    elif along >= 0.0 or seam.shown_from > 0.0:
        return False
    corner = tables.seams[part.seam_start + k]
    if corner.before_x * corner.after_y - corner.before_y * corner.after_x < 0.0:
        return False
    row = tables.cores[part.vertex_start + edge]
    return _is_between(tables.bodies[part.body], corner, row.normal_x, row.normal_y)


@kernel
def _length(cores: Records, shape: Records, edge: int) -> float:
    """Length of an edge, m."""
    start = cores[shape.vertex_start + edge]
    end = cores[shape.vertex_start + (edge + 1 if edge + 1 < shape.vertex_count else 0)]
    ex = end.x - start.x
    ey = end.y - start.y
    return math.sqrt(ex * ex + ey * ey)


@kernel
def along_edge(cores: Records, shape: Records, edge: int, x: float, y: float) -> float:
    """Where a point lies along an edge: 0 at its first vertex, 1 at its second."""
    start = cores[shape.vertex_start + edge]
    end = cores[shape.vertex_start + (edge + 1 if edge + 1 < shape.vertex_count else 0)]
    ex = end.x - start.x
    ey = end.y - start.y
    return float((ex * (x - start.x) + ey * (y - start.y)) / (ex * ex + ey * ey))
