"""Cut what a boundary encloses with a half-plane or a disc, exactly: straight pieces and arcs stay what they are.

Sutherland and Hodgman's clipping (1974), for convex boundaries that have arcs too. An arc leaves a disc where it
crosses the radical line of the two circles, so that one routine cuts arcs for both.
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.fields.boundary import LINE, Circle, add, arc, disc
from sandbox.tables import Records


@kernel
def cut_line(pieces: Records, count: int, nx: float, ny: float, offset: float, out: Records) -> int:
    """Write into `out` what of the enclosed lies where n . p <= offset. Returns the number of pieces."""
    made = 0
    for k in range(count):
        piece = pieces[k]
        if piece.radius > 0.0:
            made = _cut_arc(piece, nx, ny, offset, LINE, out, made)
            continue
        a = nx * piece.start_x + ny * piece.start_y - offset
        b = nx * piece.end_x + ny * piece.end_y - offset
        first = a / (a - b) if a > 0.0 and b <= 0.0 else 0.0
        last = a / (a - b) if a <= 0.0 and b > 0.0 else 1.0
        if a <= 0.0 or b <= 0.0:
            made = _straight(piece, first, last, LINE, out, made)
    return _close(out, made, LINE)


@kernel
def cut_disc(pieces: Records, count: int, circle: Circle, out: Records) -> int:
    """Write into `out` what of the enclosed lies in a disc. Returns the number of pieces."""
    made = 0
    for k in range(count):
        piece = pieces[k]
        if piece.radius > 0.0:
            made = _cut_arc_by_disc(piece, circle, out, made)
        else:
            made = _cut_straight_by_disc(piece, circle, out, made)
    if made == 0 and _encloses(pieces, count, circle.x, circle.y):
        return disc(out, 0, circle, 0)
    return _close(out, made, circle)


@kernel
def _cut_straight_by_disc(piece: Records, circle: Circle, out: Records, made: int) -> int:
    dx = piece.end_x - piece.start_x
    dy = piece.end_y - piece.start_y
    fx = piece.start_x - circle.x
    fy = piece.start_y - circle.y
    a = dx * dx + dy * dy
    b = dx * fx + dy * fy
    root = b * b - a * (fx * fx + fy * fy - circle.radius * circle.radius)
    if a == 0.0 or root <= 0.0:
        return made
    root = math.sqrt(root)
    first = (-b - root) / a
    last = (-b + root) / a
    first = first if first > 0.0 else 0.0
    last = last if last < 1.0 else 1.0
    if first >= last:
        return made
    return _straight(piece, first, last, circle, out, made)


@kernel
def _cut_arc_by_disc(piece: Records, circle: Circle, out: Records, made: int) -> int:
    dx = piece.center_x - circle.x
    dy = piece.center_y - circle.y
    away = math.sqrt(dx * dx + dy * dy)
    radius = circle.radius
    r = piece.radius
    if away + r <= radius:
        return _part(piece, piece.start_x, piece.start_y, piece.end_x, piece.end_y, circle, out, made)
    if away >= radius + r or away + radius <= r or away == 0.0:
        return made
    height = (radius * radius - r * r - away * away) / (2.0 * away)
    nx = dx / away
    ny = dy / away
    offset = nx * piece.center_x + ny * piece.center_y + height
    return _cut_arc(piece, nx, ny, offset, circle, out, made)


@kernel
def _cut_arc(piece: Records, nx: float, ny: float, offset: float, circle: Circle, out: Records, made: int) -> int:
    """The parts of an arc where n . p <= offset; `circle` is that of the disc that cuts, or `LINE`."""
    cx = piece.center_x
    cy = piece.center_y
    r = piece.radius
    h = offset - (nx * cx + ny * cy)
    if h >= r:
        return _part(piece, piece.start_x, piece.start_y, piece.end_x, piece.end_y, circle, out, made)
    if h <= -r:
        return made
    half = math.sqrt(r * r - h * h)
    exit_x = cx + h * nx + half * ny
    exit_y = cy + h * ny - half * nx
    entry_x = cx + h * nx - half * ny
    entry_y = cy + h * ny + half * nx
    leaves = _on_arc(piece, exit_x, exit_y)
    enters = _on_arc(piece, entry_x, entry_y)
    if leaves and enters:
        if (exit_x - cx) * (entry_y - cy) - (exit_y - cy) * (entry_x - cx) < 0.0:
            return _part(piece, entry_x, entry_y, exit_x, exit_y, circle, out, made)
        made = _part(piece, piece.start_x, piece.start_y, exit_x, exit_y, circle, out, made)
        return _part(piece, entry_x, entry_y, piece.end_x, piece.end_y, circle, out, made)
    if leaves:
        return _part(piece, piece.start_x, piece.start_y, exit_x, exit_y, circle, out, made)
    if enters:
        return _part(piece, entry_x, entry_y, piece.end_x, piece.end_y, circle, out, made)
    # No crossing within: its middle tells, as its ends may lie on the cut itself.
    mx = piece.start_x + piece.end_x - 2.0 * cx
    my = piece.start_y + piece.end_y - 2.0 * cy
    if (nx * mx + ny * my) * r <= h * math.sqrt(mx * mx + my * my):
        return _part(piece, piece.start_x, piece.start_y, piece.end_x, piece.end_y, circle, out, made)
    return made


@kernel
def _on_arc(piece: Records, px: float, py: float) -> bool:
    ux = px - piece.center_x
    uy = py - piece.center_y
    after = (piece.start_x - piece.center_x) * uy - (piece.start_y - piece.center_y) * ux > 0.0
    return bool(after and ux * (piece.end_y - piece.center_y) - uy * (piece.end_x - piece.center_x) > 0.0)


@kernel
def _part(piece: Records, sx: float, sy: float, ex: float, ey: float, circle: Circle, out: Records, made: int) -> int:
    """Add a part of a piece, and before it the way along the cut from where the boundary left."""
    if made > 0 and (out[made - 1].end_x != sx or out[made - 1].end_y != sy):
        made = _bridge(out, made, out[made - 1].end_x, out[made - 1].end_y, sx, sy, circle)
    own = Circle(piece.center_x, piece.center_y, piece.radius)
    return add(out, made, sx, sy, ex, ey, own, piece.own)


@kernel
def _straight(piece: Records, first: float, last: float, circle: Circle, out: Records, made: int) -> int:
    """The stretch of a straight piece from one share of its length to another."""
    dx = piece.end_x - piece.start_x
    dy = piece.end_y - piece.start_y
    sx = piece.start_x + first * dx
    sy = piece.start_y + first * dy
    ex = piece.start_x + last * dx if last < 1.0 else piece.end_x
    ey = piece.start_y + last * dy if last < 1.0 else piece.end_y
    return _part(piece, sx, sy, ex, ey, circle, out, made)


@kernel
def _close(out: Records, made: int, circle: Circle) -> int:
    """The way along the cut from the last piece to the first."""
    if made == 0:
        return 0
    last = out[made - 1]
    if last.end_x == out[0].start_x and last.end_y == out[0].start_y:
        return made
    return _bridge(out, made, last.end_x, last.end_y, out[0].start_x, out[0].start_y, circle)


@kernel
def _bridge(out: Records, made: int, sx: float, sy: float, ex: float, ey: float, circle: Circle) -> int:
    """Along the cut: straight, or along the disc."""
    if circle.radius == 0.0:
        return add(out, made, sx, sy, ex, ey, LINE, 0)
    return arc(out, made, sx, sy, ex, ey, circle, 0)


@kernel
def _encloses(pieces: Records, count: int, x: float, y: float) -> bool:
    """Whether a boundary has a point inside: left of every piece, or between an arc and its chord."""
    for k in range(count):
        piece = pieces[k]
        dx = piece.end_x - piece.start_x
        dy = piece.end_y - piece.start_y
        if dx * (y - piece.start_y) - dy * (x - piece.start_x) >= 0.0:
            continue
        from_x = x - piece.center_x
        from_y = y - piece.center_y
        if from_x * from_x + from_y * from_y > piece.radius * piece.radius:
            return False
    return count > 0
