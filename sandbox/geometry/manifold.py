"""The contact manifold of two rounded convex cores: minimum translation axis and one or two points.

Faces are the axes of the separating-axis test. Where rounded cores do not overlap and are closest at two vertices,
the axis between those vertices decides instead. The incident edge is then clipped against the reference face
(E. Catto, "Contact Manifolds", GDC 2007).
"""

from __future__ import annotations

import math

from sandbox._jit import ZERO, inlined_kernel, kernel
from sandbox.geometry.closest import closest_vertices
from sandbox.geometry.sat import face_separation, facing_edge, pair_size, support_vertex
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

_ROUNDING = 4e-15
"""How far a computed separation may be off, as a share of the pair's size."""


@inlined_kernel
def collide_cores(
    cores: Records,
    a: int,
    a_count: int,
    a_radius: float,
    b: int,
    b_count: int,
    b_radius: float,
    dx: float,
    dy: float,
    margin: float,
    face_bias: float,
    out: Records,
) -> int:
    """Write the manifold of two cores to `out[0]` (a `MANIFOLD` row); return its number of points.

    `margin` (m): surfaces farther apart than this give no points. `face_bias` (m): by how much a face of b has to
    beat the best face of a; 0 gives the exact minimum, a little keeps resting contacts from changing faces.
    """
    m = out[0]
    m.point_count = 0
    radii = a_radius + b_radius
    if a_count == 1 and b_count == 1:
        return _collide_points(cores, a, a_radius, b, b_radius, dx, dy, margin, m)
    reach = radii + margin
    separation_a, face_a = face_separation(cores, a, a_count, b, b_count, dx, dy, reach)
    if separation_a > reach:
        return 0
    separation_b, face_b = face_separation(cores, b, b_count, a, a_count, -dx, -dy, reach)
    if separation_b > reach:
        return 0
    flip = face_a < 0 or (face_b >= 0 and separation_b > separation_a + face_bias)
    core_separation = separation_b if flip else separation_a
    if radii > 0.0 or (a_count <= 2 and b_count <= 2):
        # Points and lines in one line overlap on all their face normals, however far apart they are, and so do slivers
        # to rounding: only a clear overlap of the cores rules their corners out.
        slack = _ROUNDING * pair_size(cores, a, a_count, b, b_count, dx, dy)
        if core_separation > -slack:
            corner, i, j, nx, ny, distance = closest_vertices(cores, a, a_count, b, b_count, dx, dy)
            # Faces flat on each other are as close at their corners: there the face gives the better manifold.
            if corner and distance > core_separation + 3.0 * slack + face_bias:
                if distance > reach:
                    return 0
                return corner_manifold(cores, a, i, a_radius, j, b_radius, nx, ny, distance, m)
    m.separation = core_separation - radii
    face = face_b if flip else face_a
    return face_manifold(cores, a, a_count, a_radius, b, b_count, b_radius, dx, dy, margin, flip, face, m)


@inlined_kernel
def face_manifold(
    cores: Records,
    a: int,
    a_count: int,
    a_radius: float,
    b: int,
    b_count: int,
    b_radius: float,
    dx: float,
    dy: float,
    margin: float,
    flip: bool,
    face: int,
    m: Records,
) -> int:
    """Fill in the manifold on a face, of b if `flip`; return its number of points. `m.separation` is there already."""
    m.point_count = 0
    m.axis_owner = 1 if flip else 0
    m.axis_edge = face
    _clip(
        cores,
        b if flip else a,
        b_count if flip else a_count,
        b_radius if flip else a_radius,
        face,
        a if flip else b,
        a_count if flip else b_count,
        a_radius if flip else b_radius,
        -dx if flip else dx,
        -dy if flip else dy,
        margin,
        flip,
        m,
    )
    count: int = m.point_count
    return count


@kernel
def _collide_points(
    cores: Records,
    a: int,
    a_radius: float,
    b: int,
    b_radius: float,
    dx: float,
    dy: float,
    margin: float,
    m: Records,
) -> int:
    """Two discs. Concentric ones part along +y: some axis has to be chosen, and always the same one."""
    gx = cores[b].x + dx - cores[a].x
    gy = cores[b].y + dy - cores[a].y
    distance = math.sqrt(gx * gx + gy * gy)
    if distance - a_radius - b_radius > margin:
        return 0
    nx = 0.0
    ny = 1.0
    if distance > 0.0:
        nx = gx / distance
        ny = gy / distance
    return corner_manifold(cores, a, ZERO, a_radius, ZERO, b_radius, nx, ny, distance, m)


@kernel
def corner_manifold(
    cores: Records,
    a: int,
    i: int,
    a_radius: float,
    j: int,
    b_radius: float,
    nx: float,
    ny: float,
    distance: float,
    m: Records,
) -> int:
    """One point between vertex i of a and vertex j of b, half way between the rounded surfaces."""
    middle = 0.5 * (distance + a_radius - b_radius)
    m.normal_x = nx
    m.normal_y = ny
    m.separation = distance - a_radius - b_radius
    m.axis_owner = 2
    m.axis_edge = i
    m.x1 = cores[a + i].x + nx * middle
    m.y1 = cores[a + i].y + ny * middle
    m.separation1 = m.separation
    m.feature1 = 64 * i + j
    m.point_count = 1
    return 1


@inlined_kernel
def _clip(
    cores: Records,
    reference: int,
    reference_count: int,
    reference_radius: float,
    face: int,
    incident: int,
    incident_count: int,
    incident_radius: float,
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
    after = face + 1 if face + 1 < reference_count else 0
    v1 = cores[reference + face]
    v2 = cores[reference + after]
    nx = v1.normal_x
    ny = v1.normal_y
    tx = -ny
    ty = nx
    m.normal_x = -nx if flip else nx
    m.normal_y = -ny if flip else ny
    low_limit = tx * v1.x + ty * v1.y
    high_limit = tx * v2.x + ty * v2.y
    high_end = facing_edge(cores, incident, incident_count, nx, ny)
    low_end = high_end + 1 if high_end + 1 < incident_count else 0
    lx = cores[incident + low_end].x + dx
    ly = cores[incident + low_end].y + dy
    hx = cores[incident + high_end].x + dx
    hy = cores[incident + high_end].y + dy
    low = tx * lx + ty * ly
    high = tx * hx + ty * hy
    offset = nx * v1.x + ny * v1.y
    radii = reference_radius + incident_radius
    if incident_count > 1 and high >= low_limit and low <= high_limit:
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
            _add_point(m, ax, ay, nx, ny, first, incident_radius, dx, dy, face, low_end, flip)
        second = nx * bx + ny * by - offset - radii
        if second <= margin:
            _add_point(m, bx, by, nx, ny, second, incident_radius, dx, dy, after, high_end, flip)
    if m.point_count == 0 and (incident_count == 1 or m.separation < 0.0):
        deepest = support_vertex(cores, incident, incident_count, nx, ny)
        x = cores[incident + deepest].x + dx
        y = cores[incident + deepest].y + dy
        gap = nx * x + ny * y - offset - radii
        _add_point(m, x, y, nx, ny, gap, incident_radius, dx, dy, face, deepest, flip)


@inlined_kernel
def _add_point(
    m: Records,
    x: float,
    y: float,
    nx: float,
    ny: float,
    gap: float,
    incident_radius: float,
    dx: float,
    dy: float,
    reference_vertex: int,
    incident_vertex: int,
    flip: bool,
) -> None:
    """Append the point half way between the surfaces, given a point (x, y) of the incident core."""
    shift = incident_radius + 0.5 * gap
    px = x - nx * shift
    py = y - ny * shift
    feature = 64 * reference_vertex + incident_vertex
    if flip:
        px = px - dx
        py = py - dy
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
