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
from sandbox.engine.restitution.add_closing import JOINS
from sandbox.engine.restitution.from_above import begin_from_above
from sandbox.engine.restitution.groups import CLOSING, SPENT, fastest, is_driven, size_of, take_back
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.rebound import rebound
from sandbox.engine.restitution.solve_group import solve_group
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Records

_MOST_WORK = 2_000
_MOST_PASSES = 256
_FEWEST_PASSES = 64
"""Of a group in a step: passes times contacts, and passes at most, and those that it has however large it is. What is
left then goes to the contact solver. No group takes of what another one has, so that none knows of the others."""
_LEAST_PASSES = 16
"""What a group is given to strike, or it is left to the contact solver."""
_AGREED = 2e-3
"""Change of velocity by a pass at any contact, as a share of the highest closing speed, below which it was the last."""


@kernel
def forget_passes(impacts: Records) -> None:
    """Begin a step, in which no impact has taken passes yet."""
    for row in impacts:
        row.passes = 0


@kernel
def strike_group(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int, anew: bool
) -> bool:
    """Strike the group that is linked from the `first` impact on, if one closes faster than `impacts.threshold`; return
    whether it has struck.

    `anew` takes back what they have done in the substep so far, and so does what has joined in this round. A group that
    has had its passes in this step is left as it is, and so is one that a kinematic body drives, which may press it
    against something immovable: nothing bounds its energy.
    """
    if is_driven(bodies, impacts, first) or fastest(solver, contacts, impacts, first, CLOSING) <= impacts.threshold:
        return False
    passes = _passes_left(impacts, first)
    if passes < _LEAST_PASSES:
        _take_passes(impacts, first, SPENT)
        return False
    if anew or _has_grown(impacts, first):
        take_back(bodies, solver, contacts, impacts, first)
    slow = _AGREED * fastest(solver, contacts, impacts, first, CLOSING)
    _ask_to_stop(impacts, first)
    begin_from_above(bodies, solver, contacts, impacts, first)
    work = solve_group(bodies, solver, contacts, impacts, first, True, False, slow, passes)
    more = 1.0 + _mean_restitution(solver, contacts, impacts, first)
    work += rebound(bodies, solver, contacts, impacts, first, more, _AGREED, None)
    _take_passes(impacts, first, work // size_of(impacts, first))
    return True


@kernel
def _has_grown(impacts: ImpactList, first: int) -> bool:
    """Whether some impact has joined in this round."""
    k = first
    while k != END:
        if impacts.slots[k].turn == JOINS:
            return True
        k = impacts.rows[k].next
    return False


@kernel
def _passes_left(impacts: ImpactList, first: int) -> int:
    """How many passes are left in the step for a group, of which some may have struck with others before."""
    taken = 0
    k = first
    while k != END:
        taken = impacts.rows[k].passes if impacts.rows[k].passes > taken else taken
        k = impacts.rows[k].next
    most = passes_within(_MOST_WORK, size_of(impacts, first), _MOST_PASSES)
    return (most if most > _FEWEST_PASSES else _FEWEST_PASSES) - taken


@kernel
def _take_passes(impacts: ImpactList, first: int, passes: int) -> None:
    """Note that a group has taken so many passes."""
    k = first
    while k != END:
        impacts.rows[k].passes += passes
        k = impacts.rows[k].next


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
