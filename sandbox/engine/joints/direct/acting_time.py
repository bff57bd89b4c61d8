"""For how long forces act before the move of a substep, and how far rigid rows give way to what they give in it."""

from __future__ import annotations

from sandbox._jit import inlined_kernel
from sandbox._vectors import Vector, load, select, spread
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.laws import COMPLIANCE
from sandbox.geometry.trig import PI
from sandbox.tables import Floats, Records

_SLOW, _FAST = 0.1, 0.4
"""Springs whose oscillation goes on by so much (rad) in the time in which they act look ahead hardly, or all the way:
so 250 of them on one body are stable, however fast they are."""
_LEAST = 1e-5
"""What does not look ahead at all has no softness that could be told."""


@inlined_kernel
def acting_time(v: Floats, batch: Records, seconds: float) -> Vector:
    """Half of the substep where the other half follows after the move; all of it from middle to middle, see
    `stagger`."""
    if batch.between == 1:
        return spread(seconds)
    return spring_time(v, batch, seconds)


@inlined_kernel
def spring_time(v: Floats, batch: Records, seconds: float) -> Vector:
    """The same for springs, which give what they give before the move after it as well."""
    return select(load(v, batch.lanes + at.HALVES) == 1.0, 0.5 * seconds, seconds)


@inlined_kernel
def look_ahead_share(v: Floats, batch: Records, acting: Vector, hertz: Vector) -> Vector:
    """How far a spring looks ahead of the substep in which it acts, as a share of it.

    Where the other half follows after the move, all the way to its middle: the implicit midpoint rule, which takes no
    energy. Where all comes before the move, to look ahead is the implicit Euler method, which damps; the force of now
    (symplectic Euler) takes none either, but fits only springs that are slow for the substep.
    """
    turn = acting * (2.0 * PI * hertz)
    share = (turn - _SLOW) / (_FAST - _SLOW)
    share = select(share > _LEAST, select(share < 1.0, share, 1.0), _LEAST)
    return select(load(v, batch.lanes + at.HALVES) == 1.0, 1.0, share)


@inlined_kernel
def compliance(batch: Records) -> float:
    """Impulses are twice as large from middle to middle."""
    return 0.5 * COMPLIANCE if batch.between == 1 else COMPLIANCE
