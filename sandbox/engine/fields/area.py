"""Where a region is: points in it, and what of a shape lies in it."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.fields.boundary import Circle, trace
from sandbox.engine.fields.clip import cut_disc, cut_line
from sandbox.engine.fields.records import Fields
from sandbox.tables import Records

OUTSIDE, ACROSS, INSIDE = 0, 1, 2


@kernel
def acts(region: Records, step: int) -> bool:
    """Whether a region or a thruster acts in a step."""
    return bool(region.start_step <= step and step < region.end_step)


@kernel
def contains(region: Records, edges: Records, x: float, y: float) -> bool:
    """Whether a point lies in a region."""
    return bool(place(region, edges, x, y, 0.0) != OUTSIDE)


@kernel
def place(region: Records, edges: Records, x: float, y: float, reach: float) -> int:
    """Whether a circle is `OUTSIDE`, `ACROSS` the boundary or `INSIDE`; what is outside may be called across."""
    found = INSIDE
    for k in range(region.first_edge, region.first_edge + region.edge_count):
        away = edges[k].normal_x * x + edges[k].normal_y * y - edges[k].offset
        if away > reach:
            return OUTSIDE
        if away > -reach:
            found = ACROSS
    if region.disc_radius > 0.0:
        dx = x - region.disc_x
        dy = y - region.disc_y
        square = dx * dx + dy * dy
        most = region.disc_radius + reach
        least = region.disc_radius - reach
        if square > most * most:
            return OUTSIDE
        if least <= 0.0 or square > least * least:
            found = ACROSS
    return found


@kernel
def boundary_within(
    region: Records, fields: Fields, bodies: Records, shape: Records, vertices: Records
) -> tuple[Records, int]:
    """The boundary of what of a shape lies in a region in mid-step: the pieces and how many, measured from its body.

    None where the shape lies outside or is a sensor.
    """
    push = fields.pushes[shape.body]
    if shape.sensor == 1:
        return fields.pieces, 0
    where = place(region, fields.edges, push.x, push.y, bodies[shape.body].extent)
    if where == OUTSIDE:
        return fields.pieces, 0
    count = trace(shape, vertices, push.cos, push.sin, fields.pieces)
    if where == ACROSS:
        return cut(region, fields.edges, push.x, push.y, fields.pieces, fields.spare, count)
    return fields.pieces, count


@kernel
def cut(
    region: Records, edges: Records, x: float, y: float, pieces: Records, spare: Records, count: int
) -> tuple[Records, int]:
    """What of a boundary, measured from (x, y), encloses within a region: the pieces and how many. Uses both arrays."""
    now = pieces
    other = spare
    for k in range(region.first_edge, region.first_edge + region.edge_count):
        edge = edges[k]
        offset = edge.offset - (edge.normal_x * x + edge.normal_y * y)
        if _beyond(now, count, edge.normal_x, edge.normal_y, offset):
            count = cut_line(now, count, edge.normal_x, edge.normal_y, offset, other)
            now, other = other, now
    if region.disc_radius > 0.0 and count > 0:
        count = cut_disc(now, count, Circle(region.disc_x - x, region.disc_y - y, region.disc_radius), other)
        now, other = other, now
    return now, count


@kernel
def _beyond(pieces: Records, count: int, nx: float, ny: float, offset: float) -> bool:
    """Whether some piece reaches beyond a half-plane."""
    for k in range(count):
        p = pieces[k]
        if p.radius > 0.0 and nx * p.center_x + ny * p.center_y + p.radius > offset:
            return True
        if nx * p.start_x + ny * p.start_y > offset or nx * p.end_x + ny * p.end_y > offset:
            return True
    return False
