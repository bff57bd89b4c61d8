"""What a step notes of its bodies, for those who decide on impacts and sleep: bits, few enough for the cache."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC, KINEMATIC

SUPPORTED = 1
"""It lies on or against something, hangs from it, or floats at rest; a body in free flight never sleeps."""
KEPT_AWAKE = 2
"""It must not fall asleep: it is dragged, lies on something that moves, or a joint is still drawing it."""
MOVING_KINEMATIC = 4
"""It is kinematic and moves, so that whatever touches it stays awake."""
ISLAND_AWAKE = 8
"""At the root of an island: some body of that is too lively for the island to sleep."""
MOBILE = 16
"""It may move: it is awake, or kinematic."""
TURNING = 32
"""It turns notably in a step."""
AHEAD = 64
"""It is put to where its velocity takes it in half a step (`midpoint`)."""
JOINTED = 128
"""It moves, and a joint holds it."""
IMMOVABLE = -1
"""In the place of the colours of a body that the solver does not move. No set of colours is that: there are 62."""


@kernel
def is_active(body: Records) -> bool:
    """Whether the solver moves this body."""
    return bool(body.type == DYNAMIC and body.awake == 1)


@kernel
def disturbs(body: Records) -> bool:
    """Whether a body wakes what it touches."""
    if body.type == DYNAMIC:
        return is_active(body)
    return bool(moves(body) or body.posed == 1)


@kernel
def moves(body: Records) -> bool:
    """Whether a body has a velocity."""
    return bool(body.velocity_x != 0.0 or body.velocity_y != 0.0 or body.angular_velocity != 0.0)


@kernel
def is_driving(body: Records) -> bool:
    """Whether a body is kinematic and moves: it drives what it touches, whatever that weighs."""
    return bool(body.type == KINEMATIC and moves(body))


@inlined_kernel
def first_flags(body: Records, free_motion: Records) -> int:
    """The flags with which a step begins. Nothing is known to rest yet but what floats; `flag_contact` adds what lies
    on something."""
    return (SUPPORTED if free_motion.buoyed == 1 else 0) | (MOVING_KINEMATIC if is_driving(body) else 0)


@kernel
def keep_dragged_awake(flags: Integers, drags: Records) -> None:
    """What is dragged does not fall asleep."""
    for k in range(drags.shape[0]):
        if drags[k].body >= 0:
            flags[drags[k].body] |= KEPT_AWAKE


@inlined_kernel
def flag_contact(flags: Integers, a: int, b: int, pushes: bool, surface_speed: float) -> None:
    """Flag two bodies in contact that lie on or against each other, or are kept awake.

    A body in free flight may be slow, but it does not rest. On a kinematic body that moves or a running belt it stays
    awake.
    """
    kept = surface_speed != 0.0 or (flags[a] | flags[b]) & MOVING_KINEMATIC != 0
    bits = (SUPPORTED if pushes else 0) | (KEPT_AWAKE if kept else 0)
    flags[a] |= bits
    flags[b] |= bits
