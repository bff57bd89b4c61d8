"""The boundary of a rounded convex core, as straight pieces and arcs."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import kernel
from sandbox.tables import Records


class Circle(NamedTuple):
    """The circle that an arc lies on, metres; radius 0 stands for a straight line."""

    x: float
    y: float
    radius: float


LINE = Circle(0.0, 0.0, 0.0)


@kernel
def trace(shape: Records, vertices: Records, cosine: float, sine: float, pieces: Records) -> int:
    """Write the pieces of a shape, counter-clockwise, turned but measured from its body's centre. Returns how many.

    Arcs cover a quarter of a circle at most, so that cross products tell what lies on them.
    """
    first = vertices[shape.vertex_start]
    if shape.vertex_count == 1:
        x = cosine * first.x - sine * first.y
        y = sine * first.x + cosine * first.y
        return disc(pieces, 0, Circle(x, y, shape.radius), 1)
    made = 0
    last = vertices[shape.vertex_start + shape.vertex_count - 1]
    before_x = cosine * last.normal_x - sine * last.normal_y
    before_y = sine * last.normal_x + cosine * last.normal_y
    for k in range(shape.vertex_count):
        here = vertices[shape.vertex_start + k]
        there = vertices[shape.vertex_start + (k + 1 if k + 1 < shape.vertex_count else 0)]
        x = cosine * here.x - sine * here.y
        y = sine * here.x + cosine * here.y
        after_x = cosine * here.normal_x - sine * here.normal_y
        after_y = sine * here.normal_x + cosine * here.normal_y
        r = shape.radius
        if r > 0.0:
            start_x = x + r * before_x
            start_y = y + r * before_y
            made = arc(pieces, made, start_x, start_y, x + r * after_x, y + r * after_y, Circle(x, y, r), 1)
        far_x = cosine * there.x - sine * there.y + r * after_x
        far_y = sine * there.x + cosine * there.y + r * after_y
        made = add(pieces, made, x + r * after_x, y + r * after_y, far_x, far_y, LINE, 1)
        before_x = after_x
        before_y = after_y
    return made


@kernel
def disc(pieces: Records, made: int, circle: Circle, own: int) -> int:
    """Add a whole circle, in quarters."""
    x, y, radius = circle
    made = add(pieces, made, x + radius, y, x, y + radius, circle, own)
    made = add(pieces, made, x, y + radius, x - radius, y, circle, own)
    made = add(pieces, made, x - radius, y, x, y - radius, circle, own)
    return add(pieces, made, x, y - radius, x + radius, y, circle, own)


@kernel
def arc(pieces: Records, made: int, sx: float, sy: float, ex: float, ey: float, circle: Circle, own: int) -> int:
    """Add the arc of a circle from one point counter-clockwise to another, in quarters and a rest."""
    x, y, radius = circle
    ux = sx - x
    uy = sy - y
    vx = ex - x
    vy = ey - y
    gap = (vx - ux) * (vx - ux) + (vy - uy) * (vy - uy)
    if gap <= 1e-24 * radius * radius:
        return made
    for _quarter in range(4):
        if ux * vy - uy * vx >= 0.0 and ux * vx + uy * vy >= 0.0:
            break
        made = add(pieces, made, x + ux, y + uy, x - uy, y + ux, circle, own)
        turned = -uy
        uy = ux
        ux = turned
    return add(pieces, made, x + ux, y + uy, ex, ey, circle, own)


@kernel
def add(pieces: Records, made: int, sx: float, sy: float, ex: float, ey: float, circle: Circle, own: int) -> int:
    """Add one piece, unless there is no room. Returns how many there are."""
    if made >= pieces.shape[0]:
        return made
    piece = pieces[made]
    piece.start_x = sx
    piece.start_y = sy
    piece.end_x = ex
    piece.end_y = ey
    piece.center_x = circle.x
    piece.center_y = circle.y
    piece.radius = circle.radius
    piece.own = own
    return made + 1
