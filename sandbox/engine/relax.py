"""How often a substep relaxes: the passes that take back the speed which pushing apart has added."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.pace import contact_pace
from sandbox.tables import Records

DEEP = 0.1
"""Overlap, as a share of a body's extent, past which one pass leaves too much of that speed."""
MANY = 8
"""Passes where bodies overlap deeply: 40 boxes thrown into one place part at 3 m/s instead of 12."""


@kernel
def relax_passes(bodies: Records, flights: Records, contacts: Records, count: int, pace: int) -> int:
    """Relax passes for the islands of a pace: 1, or `MANY` where two of their bodies overlap deeply."""
    for i in range(count):
        contact = contacts[i]
        separation = contact.separation1
        if contact.point_count == 2 and contact.separation2 < separation:
            separation = contact.separation2
        if separation >= 0.0 or contact_pace(bodies, flights, contact) != pace:
            continue
        a = bodies[contact.body_a].extent
        b = bodies[contact.body_b].extent
        if separation < -DEEP * (a if a < b else b):
            return MANY
    return 1
