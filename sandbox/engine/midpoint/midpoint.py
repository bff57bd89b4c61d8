"""Stage: bodies whose contacts last and wander are put to where they are in the middle of the step.

Normals and anchors stay as they are during a step. Those of its beginning are half a step old on the average: what
rolls or rocks on a contact that wanders was pushed along where it had been, and swung itself up, by half a step times
the square of its frequency a second. Those of the middle err by the square of the step.

Only contacts of what turns wander notably. They follow as they are prepared (`contact_solver/four_contacts.py`).
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.bodies.flags import AHEAD, MOBILE, TURNING, is_active
from sandbox.engine.midpoint.poses import put_ahead
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.ccd import NEW, OVERLAPS
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.state import StateTables
from sandbox.tables import Integers, Records
from sandbox.world.records import KINEMATIC

NOTABLE = 1e-4
"""Angle (rad) by which a body turns notably in half a step: piles that sway turn by a tenth of it."""


@kernel
def move_to_midpoint(state: StateTables, active: ActiveSet, solver: SolverBodies, contacts: Contacts) -> None:
    """Put those bodies ahead. What they move is measured from there, so that the substeps need not know."""
    bodies = state.bodies
    rows = active.bodies[1 : 1 + active.bodies[0]]
    slots: Any = contacts.active[1 : 1 + contacts.active[0].contact]
    seconds = 0.5 * state.settings[0].step_seconds
    if active.info[0].turning == 1 and _flag_ahead(solver.flags, slots, contacts.now):
        put_ahead(bodies, rows, solver, seconds)


@inlined_kernel
def turning_flags(body: Records, ccd_body: Records, seconds: float) -> int:
    """`MOBILE` if a body may move, `TURNING` if it turns notably in so many seconds."""
    if not (body.type == KINEMATIC or (is_active(body) and ccd_body.unsettled & (OVERLAPS | NEW) == 0)):
        return 0
    return MOBILE | TURNING if seconds * abs(body.angular_velocity) > NOTABLE else MOBILE


@kernel
def _flag_ahead(flags: Integers, slots: Records, contacts: Records) -> bool:
    """Flag who is to be put ahead, both of two bodies that touch and of which one turns; whether there are any."""
    found = False
    for slot in slots:
        if (flags[slot.body_a] | flags[slot.body_b]) & TURNING and contacts[slot.contact].touching == 1:
            for i in (slot.body_a, slot.body_b):
                if flags[i] & MOBILE:
                    flags[i] |= AHEAD
                    found = True
    return found
