"""Which contacts may have an impact in a step, and the lanes that say so."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.closing_speed import fastest_closing, stops_by_several
from sandbox.tables import Floats, Records

LANES = cb.LANES


class ImpactCriteria(NamedTuple):
    """Which contacts may have an impact in this step, if `some` may: those with restitution, and without it those in
    the first `struck_blocks`, of bodies that impacts reach, whose points meet faster than `speed` (m/s)."""

    some: bool
    struck_blocks: int
    speed: float


@inlined_kernel
def may_impact(a: Records, b: Records, contact: Records, speed: float, struck: bool) -> bool:
    """Whether a contact of bodies a and b may have an impact, if one of them is `struck` also without restitution."""
    if contact.restitution > 0.0 or not struck:
        return bool(contact.restitution > 0.0)
    several = stops_by_several(contact.point_count, contact.rolling_resistance)
    return bool(several and fastest_closing(a, b, contact) > speed)


@inlined_kernel
def note_impact(block: Records, v: Floats, k: int) -> None:
    """Note that lane k may have an impact; of the others of its block none has so far."""
    if block.strikes == 0:
        block.strikes = 1
        for lane in range(LANES):
            v[cb.MAY_IMPACT + lane] = 0.0
    v[cb.MAY_IMPACT + k] = 1.0
