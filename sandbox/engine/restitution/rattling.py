"""Groups of impacts that rattle: one by one they would not come to an end, as in a stack that lands as a whole.

What a contact does that strikes again and again is for nothing: all of its group is taken back, and strikes together.
So nothing of it strikes any more, once that is known.

Source: S. McNamara, W. R. Young, "Inelastic collapse and clumping in a one-dimensional granular medium", Physics of
Fluids A 4 (1992), for how many in a row come to no end.
"""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.bodies.flags import is_driving
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.groups import DRIVEN, RATTLES, STRIKES
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.worklist import END, next_contact
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC

FEWEST_STRIKES = 4
"""Of a contact, however many hang together with it."""
_MOST_STRIKES = 16
"""Of a contact, as many as a ball of 100 times the mass needs on a light one at a wall."""
_LARGEST = 32
"""Contacts of a group that is a row of balls that blows run through; a larger one is a heap that is stirred."""
_COLLAPSES = math.pi
"""Contacts in a row, times what restitution lacks to 1, from which they strike ever faster, without an end."""
_SEEN = 1
"""`group` of an impact that has struck, while its group is gone through."""


@inlined_kernel
def is_marked(solver: SolverBodies, slot: Records, mark: int) -> bool:
    """Whether a body of a contact is in a group with this mark, `RATTLES` or `DRIVEN`."""
    return bool((solver.struck[slot.body_a] | solver.struck[slot.body_b]) & mark != 0)


@kernel
def rattles(bodies: Records, solver: SolverBodies, impacts: ImpactList, k: int, restitution: float) -> bool:
    """Whether contact k, which closes with this restitution, has struck too often for as many as hang
    together with it. Then all of these are marked: they strike together, or, if a kinematic body drives them, only
    those go on that have struck less."""
    if is_marked(solver, impacts.slots[k], DRIVEN):
        return True
    count, driven = _go_through(bodies, solver, impacts, k)
    often = bool(
        impacts.slots[k].strikes >= _MOST_STRIKES or count > _LARGEST or count * (1.0 - restitution) > _COLLAPSES
    )
    _mark(bodies, solver, impacts, k, (DRIVEN if driven else RATTLES) if often else 0)
    return often


@kernel
def _go_through(bodies: Records, solver: SolverBodies, impacts: ImpactList, first: int) -> tuple[int, bool]:
    """Link what hangs together with the `first` contact by impacts; return how many contacts these are, and whether
    something without mass that moves is among their bodies. The bodies have the mark `RATTLES` meanwhile."""
    slots = impacts.slots
    rows = impacts.rows
    rows[first].group = _SEEN
    rows[first].next = END
    count = 1
    driven = False
    k = last = first
    while k != END:
        for i in (slots[k].body_a, slots[k].body_b):
            if bodies[i].type != DYNAMIC:
                driven = driven or is_driving(bodies[i])
            elif solver.struck[i] & RATTLES == 0:
                solver.struck[i] |= RATTLES
                j = solver.first_impact[i]
                while j != END:
                    if rows[j].group == STRIKES:
                        rows[j].group = _SEEN
                        rows[j].next = END
                        rows[last].next = j
                        last = j
                        count += 1
                    j = next_contact(slots[j], i)
        k = rows[k].next
    return count, driven


@kernel
def _mark(bodies: Records, solver: SolverBodies, impacts: ImpactList, first: int, mark: int) -> None:
    """Give the bodies of all that is linked from the `first` contact on this mark, and no other."""
    k = first
    while k != END:
        impacts.rows[k].group = STRIKES
        for i in (impacts.slots[k].body_a, impacts.slots[k].body_b):
            if bodies[i].type == DYNAMIC:
                solver.struck[i] = solver.struck[i] & ~RATTLES | mark
        k = impacts.rows[k].next
