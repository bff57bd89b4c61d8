"""Contacts at the seams of concave polygons, which collide by convex parts: only what the whole has may push.

The separating-axis test sees one part at a time and takes the way out across a seam for as good as any. Here the axis
is held against the whole polygon: a face must show somewhere at a point of the contact, and at a corner the axis must
lie between the normals of the two sides of the whole that meet there. Where it does not, the best axis that does takes
its place; where none is left, another part has the contact.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bounds import shape_margin
from sandbox.geometry.manifold import collide_cores, face_manifold
from sandbox.geometry.sat import FAR, support_vertex
from sandbox.tables import Records
from sandbox.world.records import SEAMED

_SLANT = 1e-3
"""Sine of the angle by which an axis may lie outside of the normals of a corner."""
_BEYOND = 1e-6
"""Share of an edge by which a point may lie beyond its end."""
_DEEPER = 4.0
"""How many times deeper than across the seam the way out of the whole may be."""
_GRAZE = 0.05
"""Share of what a pair looks ahead by which it may overlap and still count as sliding past: 1 mm for large bodies."""


@kernel
def mend_contact(
    bodies: Records,
    shapes: Records,
    turned: Records,
    seams: Records,
    i: int,
    j: int,
    dx: float,
    dy: float,
    way_x: float,
    way_y: float,
    margin: float,
    face_bias: float,
    now: bool,
    manifold: Records,
) -> bool:
    """Whether two shapes, of which one at least is a part, touch on an axis of the whole; `manifold` is put right.

    (dx, dy) leads from the centre of shape i's body to that of j's, the way (m) is that of j against i in the step,
    `margin` as for `collide_cores`. Bodies that overlap by more than they look ahead are pushed out by any axis,
    if they do so `now` and not only on the way that they would go unhindered.
    """
    m = manifold[0]
    near = _reach(bodies[shapes[i].body], bodies[shapes[j].body])
    graze = _GRAZE * near
    radii = shapes[i].radius + shapes[j].radius
    across = m.separation
    whole = _is_whole(bodies, shapes, turned, seams, i, j, dx, dy, m)
    if not whole or way_x * m.normal_x + way_y * m.normal_y < -graze:
        # What slides over a corner has sunk in a little: an axis along which they do not close in has the say.
        flip, face, separation = _best_face(bodies, shapes, turned, seams, i, j, dx, dy, way_x, way_y, graze, face_bias)
        if face >= 0 and separation - radii >= -graze:
            m.separation = separation - radii
            return _touch_face(bodies, shapes, turned, seams, i, j, dx, dy, margin, flip, face, manifold)
    if whole:
        return True
    flip, face, separation = _best_face(bodies, shapes, turned, seams, i, j, dx, dy, 0.0, 0.0, graze, face_bias)
    if face >= 0 and separation - radii >= (_DEEPER * across if across < 0.0 else 0.0) - near:
        m.separation = separation - radii
        if _touch_face(bodies, shapes, turned, seams, i, j, dx, dy, margin, flip, face, manifold):
            return True
    if across >= -near or not now:
        return False
    return (
        collide_cores(
            turned, shapes[i].vertex_start, shapes[i].vertex_count, shapes[i].radius,
            shapes[j].vertex_start, shapes[j].vertex_count, shapes[j].radius, dx, dy, margin, face_bias, manifold,
        )
        > 0
    )  # fmt: skip


@kernel
def _reach(a: Records, b: Records) -> float:
    """How far a pair of slow bodies looks ahead, in metres."""
    margin_a = shape_margin(a.extent)
    margin_b = shape_margin(b.extent)
    return 2.0 * (margin_a if margin_a < margin_b else margin_b)


@kernel
def _is_whole(
    bodies: Records,
    shapes: Records,
    turned: Records,
    seams: Records,
    i: int,
    j: int,
    dx: float,
    dy: float,
    m: Records,
) -> bool:
    """Whether the axis of a manifold is one of both whole polygons."""
    a = shapes[i]
    b = shapes[j]
    if a.traits & SEAMED:
        if m.axis_owner == 0:
            if not _shows(turned, seams, a, m.axis_edge, 0.0, 0.0, m):
                return False
        elif not _faces_out(bodies, turned, seams, a, 0.0, 0.0, m.normal_x, m.normal_y, m):
            return False
    if b.traits & SEAMED:
        if m.axis_owner == 1:
            return _shows(turned, seams, b, m.axis_edge, dx, dy, m)
        return _faces_out(bodies, turned, seams, b, dx, dy, -m.normal_x, -m.normal_y, m)
    return True


@kernel
def _faces_out(
    bodies: Records,
    turned: Records,
    seams: Records,
    part: Records,
    x: float,
    y: float,
    nx: float,
    ny: float,
    m: Records,
) -> bool:
    """Whether the direction n leads out of the whole polygon at the farthest vertex, or edge, of a part along it."""
    k = support_vertex(turned, part.vertex_start, part.vertex_count, -nx, -ny)
    if _is_between(bodies[part.body], seams[part.seam_start + k], nx, ny):
        return True
    before = k - 1 if k > 0 else part.vertex_count - 1
    for edge in (before, k):
        row = turned[part.vertex_start + edge]
        flat = abs(row.normal_x * ny - row.normal_y * nx) <= _SLANT
        if flat and row.normal_x * nx + row.normal_y * ny > 0.0 and _shows(turned, seams, part, edge, x, y, m):
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
def _shows(turned: Records, seams: Records, part: Records, edge: int, x: float, y: float, m: Records) -> bool:
    """Whether a point of the manifold lies where an edge of a part is the surface of the whole polygon.

    (x, y) leads from the centre of the manifold's shape a to that of the part's body.
    """
    seam = seams[part.seam_start + edge]
    if seam.shown_to < seam.shown_from:
        return False
    low = seam.shown_from - _BEYOND
    high = seam.shown_to + _BEYOND
    first = _along(turned, part, edge, m.x1 - x, m.y1 - y)
    if low <= first <= high:
        return True
    if m.point_count < 2:
        return False
    second = _along(turned, part, edge, m.x2 - x, m.y2 - y)
    return bool((second if second > first else first) >= low and (second if second < first else first) <= high)


@kernel
def _along(turned: Records, shape: Records, edge: int, x: float, y: float) -> float:
    """Where a point lies along an edge: 0 at its first vertex, 1 at its second."""
    start = turned[shape.vertex_start + edge]
    end = turned[shape.vertex_start + (edge + 1 if edge + 1 < shape.vertex_count else 0)]
    ex = end.x - start.x
    ey = end.y - start.y
    return float((ex * (x - start.x) + ey * (y - start.y)) / (ex * ex + ey * ey))


@kernel
def _best_face(
    bodies: Records,
    shapes: Records,
    turned: Records,
    seams: Records,
    i: int,
    j: int,
    dx: float,
    dy: float,
    way_x: float,
    way_y: float,
    graze: float,
    face_bias: float,
) -> tuple[bool, int, float]:
    """(whether it is a face of j, face, separation of the cores): the axis of least overlap that both wholes have.

    Axes along which the way closes in by more than `graze` metres do not count. The face is -1 if there is none.
    """
    face_a, separation_a = _best_face_of(bodies, shapes, turned, seams, i, j, dx, dy, way_x, way_y, graze)
    face_b, separation_b = _best_face_of(bodies, shapes, turned, seams, j, i, -dx, -dy, -way_x, -way_y, graze)
    if face_a < 0 or (face_b >= 0 and separation_b > separation_a + face_bias):
        return True, face_b, separation_b
    return False, face_a, separation_a


@kernel
def _best_face_of(
    bodies: Records,
    shapes: Records,
    turned: Records,
    seams: Records,
    i: int,
    j: int,
    dx: float,
    dy: float,
    way_x: float,
    way_y: float,
    graze: float,
) -> tuple[int, float]:
    """(face of shape i, separation) of least overlap with shape j, among the axes that both wholes have."""
    a = shapes[i]
    b = shapes[j]
    best = -FAR
    face = -1
    for k in range(a.vertex_count if a.vertex_count > 1 else 0):
        row = turned[a.vertex_start + k]
        hidden = a.traits & SEAMED > 0 and seams[a.seam_start + k].shown_to < seams[a.seam_start + k].shown_from
        if hidden or row.normal_x * way_x + row.normal_y * way_y < -graze:
            continue
        v = support_vertex(turned, b.vertex_start, b.vertex_count, row.normal_x, row.normal_y)
        near = turned[b.vertex_start + v]
        separation = row.normal_x * (near.x + dx - row.x) + row.normal_y * (near.y + dy - row.y)
        if separation > best and (
            b.traits & SEAMED == 0 or _may_meet(bodies, turned, seams, b, v, row.normal_x, row.normal_y)
        ):
            best = separation
            face = k
    return face, best


@kernel
def _may_meet(bodies: Records, turned: Records, seams: Records, part: Records, k: int, nx: float, ny: float) -> bool:
    """Whether a face with normal n may push against vertex k of a part, or against an edge there that shows."""
    if _is_between(bodies[part.body], seams[part.seam_start + k], -nx, -ny):
        return True
    before = k - 1 if k > 0 else part.vertex_count - 1
    for edge in (before, k):
        row = turned[part.vertex_start + edge]
        seam = seams[part.seam_start + edge]
        flat = abs(row.normal_x * ny - row.normal_y * nx) <= _SLANT and row.normal_x * nx + row.normal_y * ny < 0.0
        if flat and seam.shown_from <= seam.shown_to:
            return True
    return False


@kernel
def _touch_face(
    bodies: Records,
    shapes: Records,
    turned: Records,
    seams: Records,
    i: int,
    j: int,
    dx: float,
    dy: float,
    margin: float,
    flip: bool,
    face: int,
    manifold: Records,
) -> bool:
    """Fill in the manifold on a face, of shape j if `flip`; whether its points lie on that face, where it shows."""
    a = shapes[i]
    b = shapes[j]
    m = manifold[0]
    count = face_manifold(
        turned, a.vertex_start, a.vertex_count, a.radius, b.vertex_start, b.vertex_count, b.radius, dx, dy, margin,
        flip, face, m,
    )  # fmt: skip
    owner = shapes[j] if flip else shapes[i]
    x = dx if flip else 0.0
    y = dy if flip else 0.0
    if count == 0 or not _is_on(_along(turned, owner, face, m.x1 - x, m.y1 - y)):
        return False
    if count == 2 and not _is_on(_along(turned, owner, face, m.x2 - x, m.y2 - y)):
        return False
    return _is_whole(bodies, shapes, turned, seams, i, j, dx, dy, m)


@kernel
def _is_on(along: float) -> bool:
    return -_BEYOND <= along <= 1.0 + _BEYOND
