"""How heavy what lies on a body may be: one solver pass a substep cannot carry a heavy body through a light one, and
soft contacts let it sink in. Both get better with the square of the substep rate."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC

RATIO = 60.0
"""Largest ratio of what weighs on a body to its mass at level 0; four times as much at each level more."""
SINK = 0.02
"""Largest depth, as a share of the lower body's extent, to which a body may sink into that."""
SLOP = 0.005
"""Depth (m) to which it may sink in any case but where that is more than `MOST_SLOP`: Box2D's linear slop."""
MOST_SLOP = 0.05
"""Largest `SLOP`, as a share of the lower body's extent."""
NONE = 1e300
"""The smallest mass, or length, of none."""
WITH_GONE = 2
"""`weighed` while the masses may be of bodies that have gone since."""


@kernel
def masses_differ(bodies: Records, info: Records, gravity: float, omega: float, unit: float) -> bool:
    """Whether some dynamic body would be too heavy for some other one at level 0. All are weighed if need be: those
    that have gone may have been the heaviest or the lightest, but where masses did not differ with them, they do not
    without."""
    if info.weighed == WITH_GONE and not _would_differ(info, gravity, omega, unit):
        return False
    if info.weighed != 1:
        info.heaviest = 0.0
        info.lightest = info.slight = NONE
        for body in bodies:
            if body.type == DYNAMIC:
                weigh(info, body)
        info.weighed = 1
    return _would_differ(info, gravity, omega, unit)


@kernel
def _would_differ(info: Records, gravity: float, omega: float, unit: float) -> bool:
    return bool(info.heaviest > info.lightest * bearable(info.slight, gravity, omega, unit))


@inlined_kernel
def weigh(info: Records, body: Records) -> None:
    """Another dynamic body is there."""
    info.heaviest = body.mass if body.mass > info.heaviest else info.heaviest
    info.lightest = body.mass if body.mass < info.lightest else info.lightest
    info.slight = body.extent if body.extent < info.slight else info.slight


@kernel
def bearable(slight: float, gravity: float, omega: float, unit: float) -> float:
    """Largest ratio of a body's mass to that of one of that extent below it, at level 0, where a metre is so many units
    of length."""
    slop = SLOP * unit
    slop = slop if MOST_SLOP * slight > slop else MOST_SLOP * slight
    deep = SINK * slight if SINK * slight > slop else slop
    if deep * omega * omega < RATIO * gravity:
        return deep * omega * omega / gravity
    return RATIO
