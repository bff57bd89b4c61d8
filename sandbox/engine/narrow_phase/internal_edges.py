"""Contacts at the seams of concave polygons, which collide by convex parts: only what the whole has may push.

The separating-axis test sees one part at a time and takes the way out across a seam for as good as any. Here the axis
is held against the whole polygon: a face must show somewhere at a point of the contact, and at a corner the axis must
lie between the normals of the two sides of the whole that meet there. Where it does not, the best axis that does takes
its place; where none is left, another part has the contact.
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.broad_phase.proxies import pair_margin
from sandbox.geometry.manifold import face_manifold
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
    """Whether two shapes, of which one at least is a part, touch on an axis of the whole; `manifold[0]` is put right.

    (dx, dy) leads from the centre of shape i's body to that of j's, the way (m) is that of j against i in the step,
    `margin` as for `collide_cores`. Bodies that overlap by more than they look ahead are pushed out by any axis,
    if they do so `now` and not only on the way that they would go unhindered. `manifold[1]` is scratch.
    """
    m = manifold[0]
    near = pair_margin(bodies[shapes[i].body], bodies[shapes[j].body])
    graze = _GRAZE * near
    radii = shapes[i].radius + shapes[j].radius
    across = m.separation
    whole = _is_whole(bodies, shapes, turned, seams, i, j, dx, dy, near, m)
    if whole and way_x * m.normal_x + way_y * m.normal_y >= -graze:
        return True
    for turn in range(1 if whole else 2):
        # What slides over a corner has sunk in a little: an axis along which they do not close in has the say.
        share = 1.0 - turn
        manifold[1].point_count = 0
        flip, face, separation = _best_face(
            bodies,
            shapes,
            turned,
            seams,
            i,
            j,
            dx,
            dy,
            share * way_x,
            share * way_y,
            graze,
            face_bias,
            manifold[1],
        )
        depth = graze if turn == 0 else (near - _DEEPER * across if across < 0.0 else near)
        if face < 0 or separation - radii < -depth:
            continue
        manifold[1].separation = separation - radii
        if _touch_face(bodies, shapes, turned, seams, i, j, dx, dy, near, margin, flip, face, manifold[1]):
            manifold[0] = manifold[1]
            return True
        if turn == 0:
            return False
    return bool(whole or (now and across < -near))


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
    near: float,
    m: Records,
) -> bool:
    """Whether the axis of a manifold is one of both whole polygons."""
    for side in range(2):
        part = shapes[j if side == 1 else i]
        if part.traits & SEAMED == 0:
            continue
        x = dx if side == 1 else 0.0
        y = dy if side == 1 else 0.0
        sign = 1.0 - 2.0 * side
        if m.axis_owner == side:
            if not _shows(turned, seams, part, m.axis_edge, x, y, near, m):
                return False
        elif not _faces_out(bodies, turned, seams, part, x, y, sign * m.normal_x, sign * m.normal_y, near, m):
            return False
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
    near: float,
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
        if flat and row.normal_x * nx + row.normal_y * ny > 0.0 and _shows(turned, seams, part, edge, x, y, near, m):
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
def _shows(
    turned: Records, seams: Records, part: Records, edge: int, x: float, y: float, near: float, m: Records
) -> bool:
    """Whether a point of the manifold lies where an edge of a part is the surface of the whole polygon.

    (x, y) leads from the centre of the manifold's shape a to that of the part's body. Without points, whether it is the
    surface anywhere. Where an edge ends within the whole, in a nook, it is taken to go on for `near` metres: what lies
    there has sunk in a little.
    """
    seam = seams[part.seam_start + edge]
    if seam.shown_to < seam.shown_from or m.point_count == 0:
        return bool(seam.shown_from <= seam.shown_to)
    share = near / _length(turned, part, edge)
    low = seam.shown_from - (share if seam.shown_from > 0.0 else _BEYOND)
    high = seam.shown_to + (share if seam.shown_to < 1.0 else _BEYOND)
    first = _along(turned, part, edge, m.x1 - x, m.y1 - y)
    if low <= first <= high:
        return True
    if m.point_count < 2:
        return False
    second = _along(turned, part, edge, m.x2 - x, m.y2 - y)
    return bool((second if second > first else first) >= low and (second if second < first else first) <= high)


@kernel
def _length(turned: Records, shape: Records, edge: int) -> float:
    """Length of an edge, m."""
    start = turned[shape.vertex_start + edge]
    end = turned[shape.vertex_start + (edge + 1 if edge + 1 < shape.vertex_count else 0)]
    ex = end.x - start.x
    ey = end.y - start.y
    return math.sqrt(ex * ex + ey * ey)


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
    nowhere: Records,
) -> tuple[bool, int, float]:
    """(whether it is a face of j, face, separation of the cores): the axis of least overlap that both wholes have.

    Axes along which the way closes in by more than `graze` metres do not count. The face is -1 if there is none.
    """
    best = -FAR
    best_face = -1
    flip = False
    for side in range(2):
        sign = 1.0 - 2.0 * side
        a = shapes[j if side == 1 else i]
        b = shapes[i if side == 1 else j]
        least = best + face_bias if best_face >= 0 else -FAR
        for k in range(a.vertex_count if a.vertex_count > 1 else 0):
            row = turned[a.vertex_start + k]
            nx = row.normal_x
            ny = row.normal_y
            hidden = a.traits & SEAMED > 0 and seams[a.seam_start + k].shown_to < seams[a.seam_start + k].shown_from
            if hidden or sign * (nx * way_x + ny * way_y) < -graze:
                continue
            near = turned[b.vertex_start + support_vertex(turned, b.vertex_start, b.vertex_count, nx, ny)]
            separation = nx * (near.x + sign * dx - row.x) + ny * (near.y + sign * dy - row.y)
            if separation > least and (
                b.traits & SEAMED == 0 or _faces_out(bodies, turned, seams, b, 0.0, 0.0, -nx, -ny, 0.0, nowhere)
            ):
                least = separation
                best = separation
                best_face = k
                flip = side == 1
    return flip, best_face, best


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
    near: float,
    margin: float,
    flip: bool,
    face: int,
    m: Records,
) -> bool:
    """Fill in the manifold on a face, of shape j if `flip`; whether its points lie on that face, where it shows."""
    a = shapes[i]
    b = shapes[j]
    count = face_manifold(
        turned, a.vertex_start, a.vertex_count, a.radius, b.vertex_start, b.vertex_count, b.radius, dx, dy, margin,
        flip, face, m,
    )  # fmt: skip
    owner = shapes[j] if flip else shapes[i]
    x = dx if flip else 0.0
    y = dy if flip else 0.0
    for k in range(count):
        along = _along(turned, owner, face, (m.x2 if k == 1 else m.x1) - x, (m.y2 if k == 1 else m.y1) - y)
        if along < -_BEYOND or along > 1.0 + _BEYOND:
            return False
    return count > 0 and _is_whole(bodies, shapes, turned, seams, i, j, dx, dy, near, m)
