"""What a step notes of its bodies, for those who decide on blows and sleep: bits, few enough for the cache."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC, KINEMATIC

RESTS, KEPT, DRIVES, LIVELY, STRUCK = 1, 2, 4, 8, 16
"""It lies on or against something; it must not fall asleep; it is driven and moves; its island is too lively.

The last: something without restitution strikes it hard."""


@kernel
def is_active(body: Records) -> bool:
    """Whether the solver moves this body."""
    return bool(body.type == DYNAMIC and body.awake == 1)


@kernel
def disturbs(body: Records) -> bool:
    """Whether a body wakes what it touches."""
    if body.type == DYNAMIC:
        return is_active(body)
    return bool(body.velocity_x != 0.0 or body.velocity_y != 0.0 or body.angular_velocity != 0.0 or body.posed == 1)


@kernel
def clear_marks(bodies: Records, movers: Integers, flights: Records, drags: Records, marks: Integers) -> None:
    """Nothing is known to rest yet but what floats. What is dragged is kept awake; `mark_resting` adds the others."""
    for i in movers:
        drives = bodies[i].type == KINEMATIC and disturbs(bodies[i])
        marks[i] = (RESTS if flights[i].buoyed == 1 else 0) | (DRIVES if drives else 0)
    for k in range(drags.shape[0]):
        if drags[k].body >= 0:
            marks[drags[k].body] |= KEPT


@inlined_kernel
def mark_resting(marks: Integers, a: int, b: int, pushes: bool, surface_speed: float) -> None:
    """Mark two bodies in contact that lie on or against each other, or are kept awake.

    A body in free flight may be slow, but it does not rest. On a driven body or a running belt it stays awake.
    """
    kept = surface_speed != 0.0 or (marks[a] | marks[b]) & DRIVES != 0
    bits = (RESTS if pushes else 0) | (KEPT if kept else 0)
    marks[a] |= bits
    marks[b] |= bits
