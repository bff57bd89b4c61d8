"""The contact manifold of two rounded convex cores: minimum translation axis and one or two points.

Two vertices that are closest give one point. A face that is becomes the reference face: the incident edge is clipped
against its sides (E. Catto, "Contact Manifolds", GDC 2007).
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.geometry.closest_features import APART, FACE_OF_B, VERTICES, closest_features
from sandbox.geometry.core import CoreRows
from sandbox.geometry.sat import facing_edge, support_vertex
from sandbox.tables import Field, Records, Table

MANIFOLD = Table(
    "manifold",
    (
        Field("normal_x", "1", "unit axis of least overlap, from a to b"),
        Field("normal_y", "1", "unit axis of least overlap, from a to b"),
        Field("separation", "m", "along the axis, radii included; negative is the depth"),
        Field("axis_owner", "-", "0 a face of a, 1 a face of b, 2 between two vertices", "i8"),
        Field("axis_edge", "-", "the face that gave the axis; for two vertices the vertex of a", "i8"),
        Field("point_count", "-", "0, 1 or 2", "i8"),
        Field("x1", "m", "point 1, half way between the surfaces, from the centre of a"),
        Field("y1", "m", "point 1, half way between the surfaces, from the centre of a"),
        Field("separation1", "m", "gap at point 1"),
        Field("feature1", "-", "64 * vertex of a + vertex of b", "i8"),
        Field("x2", "m", "point 2"),
        Field("y2", "m", "point 2"),
        Field("separation2", "m", "gap at point 2"),
        Field("feature2", "-", "64 * vertex of a + vertex of b", "i8"),
    ),
)


@inlined_kernel
def collide_cores(
    cores: Records, a: CoreRows, b: CoreRows, dx: float, dy: float, margin: float, face_bias: float, out: Records
) -> int:
    """Write the manifold of two cores to `out[0]` (a `MANIFOLD` row); return its number of points.

    `margin` (m): surfaces farther apart than this give no points. `face_bias` (m): by how much a face of b has to
    beat the best face of a; 0 gives the exact minimum, a little keeps resting contacts from changing faces.
    """
    m = out[0]
    m.point_count = 0
    found = closest_features(cores, a, b, dx, dy, margin, face_bias)
    if found.owner == APART:
        return 0
    if found.owner == VERTICES:
        return corner_manifold(cores, a, b, found.a, found.b, found.normal_x, found.normal_y, found.distance, m)
    flip = found.owner == FACE_OF_B
    m.separation = found.separation
    return face_manifold(cores, a, b, dx, dy, margin, flip, found.b if flip else found.a, m)


@inlined_kernel
def face_manifold(
    cores: Records, a: CoreRows, b: CoreRows, dx: float, dy: float, margin: float, flip: bool, face: int, m: Records
) -> int:
    """Fill in the manifold on a face, of b if `flip`; return its number of points. `m.separation` is there already."""
    m.point_count = 0
    m.axis_owner = 1 if flip else 0
    m.axis_edge = face
    _clip(cores, b if flip else a, a if flip else b, face, -dx if flip else dx, -dy if flip else dy, margin, flip, m)
    count: int = m.point_count
    return count


@kernel
def corner_manifold(
    cores: Records, a: CoreRows, b: CoreRows, i: int, j: int, nx: float, ny: float, distance: float, m: Records
) -> int:
    """One point between vertex i of a and vertex j of b, half way between the rounded surfaces."""
    middle = 0.5 * (distance + a.radius - b.radius)
    m.normal_x = nx
    m.normal_y = ny
    m.separation = distance - a.radius - b.radius
    m.axis_owner = 2
    m.axis_edge = i
    m.x1 = cores[a.start + i].x + nx * middle
    m.y1 = cores[a.start + i].y + ny * middle
    m.separation1 = m.separation
    m.feature1 = 64 * i + j
    m.point_count = 1
    return 1


class _Clipping(NamedTuple):
    """What both points of a clipping have in common: the reference face's normal, and how they are written down."""

    normal_x: float
    normal_y: float
    incident_radius: float
    dx: float
    dy: float
    flip: bool


@inlined_kernel
def _clip(
    cores: Records,
    reference: CoreRows,
    incident: CoreRows,
    face: int,
    dx: float,
    dy: float,
    margin: float,
    flip: bool,
    m: Records,
) -> None:
    """Clip the incident edge against the sides of the reference face; keep what is nearer than `margin`.

    A point's id names the corners of both shapes at its end of the face, whichever of them clipped it, so that it
    survives a change of the reference face.
    """
    after = face + 1 if face + 1 < reference.vertex_count else 0
    v1 = cores[reference.start + face]
    v2 = cores[reference.start + after]
    nx = v1.normal_x
    ny = v1.normal_y
    tx = -ny
    ty = nx
    m.normal_x = -nx if flip else nx
    m.normal_y = -ny if flip else ny
    low_limit = tx * v1.x + ty * v1.y
    high_limit = tx * v2.x + ty * v2.y
    high_end = facing_edge(cores, incident, nx, ny)
    low_end = high_end + 1 if high_end + 1 < incident.vertex_count else 0
    lx = cores[incident.start + low_end].x + dx
    ly = cores[incident.start + low_end].y + dy
    hx = cores[incident.start + high_end].x + dx
    hy = cores[incident.start + high_end].y + dy
    low = tx * lx + ty * ly
    high = tx * hx + ty * hy
    offset = nx * v1.x + ny * v1.y
    radii = reference.radius + incident.radius
    clipping = _Clipping(nx, ny, incident.radius, dx, dy, flip)
    if incident.vertex_count > 1 and high >= low_limit and low <= high_limit:
        span = high - low
        ax = lx
        ay = ly
        bx = hx
        by = hy
        if low < low_limit and span > 0.0:
            t = (low_limit - low) / span
            ax = lx + t * (hx - lx)
            ay = ly + t * (hy - ly)
        if high > high_limit and span > 0.0:
            t = (high_limit - low) / span
            bx = lx + t * (hx - lx)
            by = ly + t * (hy - ly)
        first = nx * ax + ny * ay - offset - radii
        if first <= margin:
            _add_point(m, clipping, ax, ay, first, face, low_end)
        second = nx * bx + ny * by - offset - radii
        if second <= margin:
            _add_point(m, clipping, bx, by, second, after, high_end)
    if m.point_count == 0 and (incident.vertex_count == 1 or m.separation < 0.0):
        deepest = support_vertex(cores, incident, nx, ny)
        x = cores[incident.start + deepest].x + dx
        y = cores[incident.start + deepest].y + dy
        gap = nx * x + ny * y - offset - radii
        _add_point(m, clipping, x, y, gap, after if low > high_limit else face, deepest)


@inlined_kernel
def _add_point(
    m: Records, clipping: _Clipping, x: float, y: float, gap: float, reference_vertex: int, incident_vertex: int
) -> None:
    """Append the point half way between the surfaces, given a point (x, y) of the incident core."""
    shift = clipping.incident_radius + 0.5 * gap
    px = x - clipping.normal_x * shift
    py = y - clipping.normal_y * shift
    feature = 64 * reference_vertex + incident_vertex
    if clipping.flip:
        px = px - clipping.dx
        py = py - clipping.dy
        feature = 64 * incident_vertex + reference_vertex
    if m.point_count == 0:
        m.x1 = px
        m.y1 = py
        m.separation1 = gap
        m.feature1 = feature
        m.point_count = 1
    else:
        m.x2 = px
        m.y2 = py
        m.separation2 = gap
        m.feature2 = feature
        m.point_count = 2
