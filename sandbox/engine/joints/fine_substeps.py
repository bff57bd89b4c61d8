"""Which jointed bodies are worth finer substeps: small parts that swing freely, such as pendulums.

The method is of second order: the period of a swing of angular frequency w errs by (w h)^2 / 24, which four times as
many substeps make a sixteenth. That is cheap for a few bodies that touch nothing, and pointless where soft contacts
decide what happens.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Records

FINE = 2
"""Substep level of such a part: four times the scene's substeps."""
SMALL = 2
"""Most bodies of such a part."""
FEW = 256
"""Most bodies of a world with such parts: every substep goes through all bodies."""


@kernel
def refine_small_parts(work: JointWork, bodies: Records, free_motions: Records) -> int:
    """Give every small part of which no body has a contact the substep level `FINE`; return the levels given, as bits.

    As it has no contact, such a part is an island by itself.
    """
    if bodies.shape[0] > FEW:
        return 0
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        part.fine = part.direct * part.free if part.member_end - part.first_member <= SMALL else 0
    used = 0
    for i in range(1, work.members.shape[0]):
        member = work.members[i]
        if member.part >= 0 and work.parts[member.part].fine == 1 and is_active(bodies[member.body]):
            free_motions[member.body].substep_level = FINE
            used = 1 << FINE
    return used
