"""Internal edges: where shapes are parts of a whole (a concave polygon, a chain, tiles), only its outline may push.

The separating-axis test sees one part at a time and takes the way out across a seam for as good as any. Here the axis
is held against the whole polygon: a face must show somewhere at a point of the contact, and at a corner the axis must
lie between the normals of the two sides of the whole that meet there. Where it does not, the best axis that does takes
its place; where none is left, another part has the contact.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import kernel
from sandbox.engine.broad_phase.margins import pair_margin
from sandbox.engine.narrow_phase.outline import BEYOND, EdgeTables, along_edge, faces_out, is_past_end, shows
from sandbox.geometry.core import core_of
from sandbox.geometry.manifold import face_manifold
from sandbox.geometry.sat import FAR, support_vertex
from sandbox.tables import Records
from sandbox.world.records import SEAMED

_DEEPER = 4.0
"""How many times deeper than across the seam the way out of the whole may be."""
_GRAZE = 0.05
"""Share of what a pair looks ahead by which it may overlap and still count as sliding past: 1 mm for large bodies."""
_LEAN = 0.25
"""Sine of the angle by which an edge may lie askew that a blow at its near end lays down within the step: both of its
points are within the margin, so that only what is short lies as steep."""


class PlacedPair(NamedTuple):
    """Two shapes by their rows; (dx, dy) leads from the centre of shape i's body to that of j's, in metres."""

    i: int
    j: int
    dx: float
    dy: float


@kernel
def fix_internal_edge(
    tables: EdgeTables,
    pair: PlacedPair,
    travel_x: float,
    travel_y: float,
    margin: float,
    face_bias: float,
    now: bool,
    manifold: Records,
) -> bool:
    """Whether two shapes, of which one at least is a part, touch on an axis of the whole; `manifold[0]` is put right.

    (travel_x, travel_y) is the displacement (m) of j against i in the step, `margin` as for `collide_cores`. Bodies
    that overlap by more than their margin are pushed out by any axis, if they do so `now` and not only where they
    would get unhindered. Where no axis is left, an edge that shows and that may lie down flat within the step touches:
    no other part has its far corner. `manifold[1]` is scratch.
    """
    m = manifold[0]
    one = tables.bodies[tables.shapes[pair.i].body]
    other = tables.bodies[tables.shapes[pair.j].body]
    near = pair_margin(one, other, tables.units_per_meter)
    graze = _GRAZE * near
    radii = tables.shapes[pair.i].radius + tables.shapes[pair.j].radius
    across = m.separation
    whole = _is_whole(tables, pair, near, 0.0, m)
    if whole and travel_x * m.normal_x + travel_y * m.normal_y >= -graze:
        return True
    for attempt in range(1 if whole else 2):
        # What slides over a corner has sunk in a little: an axis along which they do not close in has the say.
        share = 1.0 - attempt
        manifold[1].point_count = 0
        flip, face, separation = _best_face(
            tables, pair, share * travel_x, share * travel_y, graze, face_bias, manifold[1]
        )
        depth = graze if attempt == 0 else (near - _DEEPER * across if across < 0.0 else near)
        if face < 0 or separation - radii < -depth:
            continue
        manifold[1].separation = separation - radii
        if _touch_face(tables, pair, near, margin, flip, face, manifold[1]):
            manifold[0] = manifold[1]
            return True
        if attempt == 0:
            return False
    if whole or (now and across < -near):
        return True
    return bool(m.point_count == 2 and _is_whole(tables, pair, near, _LEAN, m))


@kernel
def _is_whole(tables: EdgeTables, pair: PlacedPair, near: float, lean: float, m: Records) -> bool:
    """Whether the axis of a manifold is one of both whole polygons; edges may lie askew as for `faces_out`."""
    for side in range(2):
        part = tables.shapes[pair.j if side == 1 else pair.i]
        if part.traits & SEAMED == 0:
            continue
        x = pair.dx if side == 1 else 0.0
        y = pair.dy if side == 1 else 0.0
        sign = 1.0 - 2.0 * side
        if m.axis_owner == side:
            on_face = shows(tables, part, m.axis_edge, x, y, near, m)
            if not (on_face or is_past_end(tables, part, m.axis_edge, x, y, m)):
                return False
        elif not faces_out(tables, part, x, y, sign * m.normal_x, sign * m.normal_y, near, lean, m):
            return False
    return True


@kernel
def _best_face(
    tables: EdgeTables,
    pair: PlacedPair,
    travel_x: float,
    travel_y: float,
    graze: float,
    face_bias: float,
    nowhere: Records,
) -> tuple[bool, int, float]:
    """(whether it is a face of j, face, separation of the cores): the axis of least overlap that both wholes have.

    Axes along which they close in by more than `graze` metres do not count. The face is -1 if there is none.
    """
    best = -FAR
    best_face = -1
    flip = False
    for side in range(2):
        sign = 1.0 - 2.0 * side
        a = tables.shapes[pair.j if side == 1 else pair.i]
        b = tables.shapes[pair.i if side == 1 else pair.j]
        least = best + face_bias if best_face >= 0 else -FAR
        for k in range(a.vertex_count if a.vertex_count > 1 else 0):
            row = tables.cores[a.vertex_start + k]
            nx = row.normal_x
            ny = row.normal_y
            hidden = (
                a.traits & SEAMED > 0
                and tables.seams[a.seam_start + k].shown_to < tables.seams[a.seam_start + k].shown_from
            )
            if hidden or sign * (nx * travel_x + ny * travel_y) < -graze:
                continue
            near = tables.cores[b.vertex_start + support_vertex(tables.cores, core_of(b), nx, ny)]
            separation = nx * (near.x + sign * pair.dx - row.x) + ny * (near.y + sign * pair.dy - row.y)
            if separation > least and (
                b.traits & SEAMED == 0 or faces_out(tables, b, 0.0, 0.0, -nx, -ny, 0.0, 0.0, nowhere)
            ):
                least = separation
                best = separation
                best_face = k
                flip = side == 1
    return flip, best_face, best


@kernel
def _touch_face(
    tables: EdgeTables, pair: PlacedPair, near: float, margin: float, flip: bool, face: int, m: Records
) -> bool:
    """Fill in the manifold on a face, of shape j if `flip`; whether its points lie on that face, where it shows."""
    a = tables.shapes[pair.i]
    b = tables.shapes[pair.j]
    count = face_manifold(tables.cores, core_of(a), core_of(b), pair.dx, pair.dy, margin, flip, face, m)
    owner = tables.shapes[pair.j] if flip else tables.shapes[pair.i]
    x = pair.dx if flip else 0.0
    y = pair.dy if flip else 0.0
    for k in range(count):
        along = along_edge(tables.cores, owner, face, (m.x2 if k == 1 else m.x1) - x, (m.y2 if k == 1 else m.y1) - y)
        if along < -BEYOND or along > 1.0 + BEYOND:
            return False
    return count > 0 and _is_whole(tables, pair, near, 0.0, m)
