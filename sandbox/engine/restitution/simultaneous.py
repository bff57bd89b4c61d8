"""Impacts that strike together: where one by one does not end, as a light body rattles between heavy ones.

They rebound by 1 + e times the impulses that would stop the group: so it keeps all its energy with e = 1. As impulses
only push and energy is bounded, what closes ends.

Source: J. J. Moreau 1985 (restitution of all contacts at once); B. Smith, D. Kaufman, E. Vouga, R. Tamstorf and E.
Grinspun, "Reflections on simultaneous impact", ACM Transactions on Graphics 31 (2012).
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import start_velocity
from sandbox.engine.contact_solver.nesterov import passes_within
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.groups import CLOSING, fastest, is_driven, size_of, take_back
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.rebound import rebound
from sandbox.engine.restitution.solve_group import solve_group
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Records

MOST_PASSES = 256
LEAST_PASSES = 16
"""What a group is given at least, or it is left to the contact solver."""
AGREED = 1e-3
"""Change of velocity by a pass at any contact, as a share of the highest closing speed, below which it was the last."""


@kernel
def strike_group(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int, anew: bool, most: int
) -> int:
    """Strike the group that is linked from the `first` impact on, if one closes faster than `impacts.threshold`.

    `anew` takes back what they have done in the substep so far. Returns how much work that was, passes times contacts,
    of `most`; a group for which that is too little is left as it is, and was the last one. So is one that a kinematic
    body drives, which may press it against something immovable: nothing bounds its energy.
    """
    count = size_of(impacts, first)
    if LEAST_PASSES * count > most:
        return most
    if is_driven(bodies, impacts, first) or fastest(solver, contacts, impacts, first, CLOSING) <= impacts.threshold:
        return count
    if anew:
        take_back(bodies, solver, contacts, impacts, first)
    slow = AGREED * fastest(solver, contacts, impacts, first, CLOSING)
    _ask_to_stop(impacts, first)
    passes = passes_within(most, count, MOST_PASSES)
    work = solve_group(bodies, solver, contacts, impacts, first, False, False, slow, passes)
    more = 1.0 + _mean_restitution(solver, contacts, impacts, first)
    rebound(bodies, solver, contacts, impacts, first, more, AGREED, None)
    return int(work)


@kernel
def _ask_to_stop(impacts: ImpactList, first: int) -> None:
    """Let no contact ask for more than that it no longer closes."""
    k = first
    while k != END:
        impacts.rows[k].rebound1 = impacts.rows[k].rebound2 = 0.0
        k = impacts.rows[k].next


@kernel
def _mean_restitution(solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int) -> float:
    """The mean over what closes, by the work of the loads there."""
    closed = given = 0.0
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        start = start_velocity(solver.free_motions, contact)
        restitution = contact.restitution if contact.restitution < 1.0 else 1.0
        for point in range(1, contact.point_count + 1):
            closing = -opening_speed(start, contact, point)
            work = (row.load1 if point == 1 else row.load2) * closing if closing > 0.0 else 0.0
            closed += work
            given += restitution * work
        k = row.next
    return given / closed if closed > 0.0 else 0.0
