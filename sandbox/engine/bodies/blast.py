"""What an explosion does to shapes, and to the velocities of their bodies: one after the other, in machine code."""

from __future__ import annotations

import math

from sandbox._jit import entry_point, kernel
from sandbox.tables import Field, Floats, Records, Table

UNKNOWN = -1
_CLEAR = 1e-12
"""Share of how far a shape reaches from the point by which floats may be wrong about what holds the point, many times
over."""

BLAST = Table(
    "blast",
    (
        Field("x", "m", "the point"),
        Field("y", "m", ""),
        Field("radius", "m", "how far it reaches"),
        Field("impulse", "N s/m", "at the point, for each metre of width"),
        Field("fastest", "m/s or rad/s", "that a body may be afterwards"),
    ),
)
"""One row: the explosion."""

BLASTED = Table(
    "blasted",
    (
        Field("body", "-", "row of its body", "i8"),
        Field("start", "-", "first corner of its core", "i8"),
        Field("count", "-", "corners of its core", "i8"),
        Field("holds", "-", "whether it holds the point; -1 as long as that is not known", "i8"),
        Field("pushed", "-", "1 once its body has taken its push", "i8"),
        Field("at_center", "-", "1: the push acts on the centre of mass", "i8"),
        Field("radius", "m", "around its core"),
        Field("x", "m", "its place that is nearest to the point"),
        Field("y", "m", ""),
        Field("impulse_x", "N s", "its push"),
        Field("impulse_y", "N s", ""),
    ),
)
"""One row a shape in reach, body after body."""


@entry_point
def push_away(bodies: Records, shapes: Records, xs: Floats, ys: Floats, blasts: Records, first: int) -> int:
    """Push the bodies of the shapes from row `first` on, whose corners in the world (m) are `xs` and `ys`.

    Returns how many shapes there are, or the row of one that it could not go past: floats cannot tell whether that
    holds the point, which is then to be written into its row, or its body cannot take the push that is noted there.
    """
    blast = blasts[0]
    for k in range(first, shapes.shape[0]):
        shape = shapes[k]
        gap = _nearest(shape, xs, ys, blast)
        if shape.holds == UNKNOWN:
            return k
        body = bodies[shape.body]
        if gap < blast.radius and _push(shape, body, xs, ys, blast, gap) and not _take(body, shape, blast.fastest):
            return k
    return int(shapes.shape[0])


@kernel
def _nearest(shape: Records, xs: Floats, ys: Floats, blast: Records) -> float:
    """Note a shape's place that is nearest to the point, and whether it holds the point; returns how far away it is,
    0 if it does."""
    away = math.inf
    inner = math.inf
    reach = 0.0
    x = 0.0
    y = 0.0
    for i in range(shape.start, shape.start + shape.count):
        j = i + 1 if i + 1 < shape.start + shape.count else shape.start
        along_x = xs[j] - xs[i]
        along_y = ys[j] - ys[i]
        square = along_x * along_x + along_y * along_y
        from_x = blast.x - xs[i]
        from_y = blast.y - ys[i]
        along = (from_x * along_x + from_y * along_y) / square if square > 0.0 else 0.0
        along = 0.0 if along < 0.0 else along
        along = 1.0 if along > 1.0 else along
        near_x = xs[i] + along * along_x
        near_y = ys[i] + along * along_y
        dx = blast.x - near_x
        dy = blast.y - near_y
        distance = math.sqrt(dx * dx + dy * dy)
        if distance < away:
            away = distance
            x = near_x
            y = near_y
        side = (along_x * from_y - along_y * from_x) / math.sqrt(square) if square > 0.0 else 0.0
        inner = side if side < inner else inner
        far = abs(from_x) + abs(from_y)
        reach = far if far > reach else reach
    if shape.holds == UNKNOWN:
        _decide(shape, away, inner, _CLEAR * (reach + shape.radius))
    if shape.holds == 1 or away == 0.0:  # or so near that it cannot be told from the edge
        shape.x = blast.x
        shape.y = blast.y
        return 0.0
    share = shape.radius / away
    shape.x = x + (blast.x - x) * share
    shape.y = y + (blast.y - y) * share
    return float(away - shape.radius)


@kernel
def _decide(shape: Records, away: float, inner: float, error: float) -> None:
    """Note whether a shape holds the point, `away` from the edges of its core and by `inner` on the inner side of each,
    unless an `error` of these could be wrong about it (all in m)."""
    has_area = shape.count > 2
    if has_area and inner > error:
        shape.holds = 1
    elif (not has_area or inner < -error) and abs(away - shape.radius) > error:
        shape.holds = 1 if away < shape.radius else 0


@kernel
def _push(shape: Records, body: Records, xs: Floats, ys: Floats, blast: Records, gap: float) -> bool:
    """Note the push on a shape that is so far from the point (m); False if it has no direction."""
    shape.at_center = 0 if gap > 0.0 else 1
    x = (shape.x if gap > 0.0 else body.center_x) - blast.x
    y = (shape.y if gap > 0.0 else body.center_y) - blast.y
    length = math.sqrt(x * x + y * y)
    if length == 0.0:
        return False
    x = x / length
    y = y / length
    least = math.inf
    most = -math.inf
    for i in range(shape.start, shape.start + shape.count):
        across = x * ys[i] - y * xs[i]
        least = across if across < least else least
        most = across if across > most else most
    width = most - least + 2.0 * shape.radius
    size = blast.impulse * width * (1.0 - (gap if gap > 0.0 else 0.0) / blast.radius)
    shape.impulse_x = size * x
    shape.impulse_y = size * y
    return True


@kernel
def _take(body: Records, shape: Records, fastest: float) -> bool:
    """Change a body's velocity as `ApplyImpulse` does; False, and nothing, if it would be too fast."""
    moment = 0.0
    if shape.at_center == 0:
        moment = (shape.x - body.center_x) * shape.impulse_y - (shape.y - body.center_y) * shape.impulse_x
    velocity_x = body.velocity_x + shape.impulse_x * body.inverse_mass
    velocity_y = body.velocity_y + shape.impulse_y * body.inverse_mass
    turning = body.angular_velocity + (0.0 + moment) * body.inverse_inertia
    if not (abs(velocity_x) <= fastest and abs(velocity_y) <= fastest and abs(turning) <= fastest):
        return False
    body.velocity_x = velocity_x
    body.velocity_y = velocity_y
    body.angular_velocity = turning
    shape.pushed = 1
    return True
