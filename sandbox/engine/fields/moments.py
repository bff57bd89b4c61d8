"""Area, first moments and polar second moment of what pieces enclose, in closed form (Green's theorem)."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.geometry.trig import arctan2
from sandbox.tables import Records


@kernel
def enclosed(pieces: Records, count: int) -> tuple[float, float, float, float]:
    """(area, first moment x, first moment y, polar second moment) about the point the pieces are measured from.

    A piece adds the triangle that it spans with that point; an arc adds the circular segment over its chord, whose
    first moment about its centre is chord^3 / 12.
    """
    area = first_x = first_y = second = 0.0
    for k in range(count):
        p = pieces[k]
        cross = p.start_x * p.end_y - p.start_y * p.end_x
        area += 0.5 * cross
        first_x += cross * (p.start_x + p.end_x) / 6.0
        first_y += cross * (p.start_y + p.end_y) / 6.0
        square = p.start_x * p.start_x + p.start_x * p.end_x + p.end_x * p.end_x
        square += p.start_y * p.start_y + p.start_y * p.end_y + p.end_y * p.end_y
        second += cross * square / 12.0
        if p.radius > 0.0:
            cap, cap_x, cap_y, cap_second = _cap(p)
            area += cap
            first_x += cap_x
            first_y += cap_y
            second += cap_second
    return area, first_x, first_y, second


@kernel
def _cap(p: Records) -> tuple[float, float, float, float]:
    """The circular segment between an arc and its chord."""
    ux = p.start_x - p.center_x
    uy = p.start_y - p.center_y
    vx = p.end_x - p.center_x
    vy = p.end_y - p.center_y
    cross = ux * vy - uy * vx
    dot = ux * vx + uy * vy
    angle = arctan2(cross, dot)
    square = p.radius * p.radius
    area = 0.5 * (square * angle - cross)
    dx = p.end_x - p.start_x
    dy = p.end_y - p.start_y
    chord = (dx * dx + dy * dy) / 12.0
    own_x = chord * dy
    own_y = -chord * dx
    second = 0.25 * square * square * angle - cross * (2.0 * square + dot) / 12.0
    second += 2.0 * (p.center_x * own_x + p.center_y * own_y)
    second += area * (p.center_x * p.center_x + p.center_y * p.center_y)
    return area, own_x + area * p.center_x, own_y + area * p.center_y, second
