"""When two convex cores that move along a straight line first touch."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.geometry.manifold import collide_cores
from sandbox.tables import Records

_FAR = 1e200
_TURNS = 24


@kernel
def time_of_touch(
    cores: Records,
    a: int,
    a_count: int,
    a_radius: float,
    b: int,
    b_count: int,
    b_radius: float,
    dx: float,
    dy: float,
    vx: float,
    vy: float,
    seconds: float,
    slop: float,
    out: Records,
) -> float:
    """Time (s) at which two cores come within `slop` metres while b moves against a by (vx, vy) m/s; -1 if they do not.

    The distance of convex shapes along a straight line is convex in time: Newton from the start never oversteps the
    first touch, and a gap that does not shrink now never will (conservative advancement, B. Mirtich 1996). `out` is
    scratch, a `MANIFOLD` row.
    """
    t = 0.0
    for _turn in range(_TURNS):
        x = dx + vx * t
        y = dy + vy * t
        collide_cores(cores, a, a_count, a_radius, b, b_count, b_radius, x, y, _FAR, 0.0, out)
        m = out[0]
        if m.separation <= slop:
            return t
        closing = -(vx * m.normal_x + vy * m.normal_y)
        if closing <= 0.0:
            return -1.0
        t = t + (m.separation - 0.5 * slop) / closing
        if t > seconds:
            return -1.0
    return t
