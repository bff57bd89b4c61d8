"""When two convex cores that move along a straight line first touch."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.geometry.closest_features import Features, closest_features
from sandbox.geometry.core import CoreRows
from sandbox.tables import Records

_FAR = 1e200
_STRIDES = 24


@kernel
def features_apart(cores: Records, a: CoreRows, b: CoreRows, dx: float, dy: float) -> Features:
    """The closest features of two cores, however far apart they are."""
    return closest_features(cores, a, b, dx, dy, _FAR, 0.0)


@kernel
def linear_cast(
    cores: Records,
    a: CoreRows,
    b: CoreRows,
    start: Features,
    offset: tuple[float, float],
    velocity: tuple[float, float],
    seconds: float,
    slop: float,
) -> float:
    """Time (s) at which two cores come within `slop` metres while b moves against a by a velocity (m/s); -1 if they do
    not. `start` are their closest features (`features_apart`) where b begins, at an offset (m) from a.

    The distance of convex shapes along a straight line is convex in time: Newton from the start never oversteps the
    first touch, and a gap that does not shrink now never will (conservative advancement, B. Mirtich 1996).
    """
    dx, dy = offset
    vx, vy = velocity
    found = start
    t = 0.0
    for _stride in range(_STRIDES):
        if found.separation <= slop:
            return t
        closing = -(vx * found.normal_x + vy * found.normal_y)
        if closing <= 0.0:
            return -1.0
        t = t + (found.separation - 0.5 * slop) / closing
        if t > seconds:
            return -1.0
        found = features_apart(cores, a, b, dx + vx * t, dy + vy * t)
    return t
