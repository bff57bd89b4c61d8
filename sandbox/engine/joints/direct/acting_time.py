"""For how long forces act before the move of a substep, and how far rigid rows give way to what they give in it."""

from __future__ import annotations

from sandbox._jit import inlined_kernel
from sandbox._vectors import Vector, load, select, spread
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.laws import COMPLIANCE
from sandbox.tables import Floats, Records


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
def compliance(batch: Records) -> float:
    """Impulses are twice as large from middle to middle."""
    return 0.5 * COMPLIANCE if batch.between == 1 else COMPLIANCE
