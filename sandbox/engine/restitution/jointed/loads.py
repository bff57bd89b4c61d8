"""The normal loads of impacts on jointed bodies: rounds of what their contacts would ask for if bodies were free.

Joints pass each round on, which takes from it where it struck. So it is scaled to do as much as it can, and the next
one asks for the rest: steepest descent, preconditioned by the passes over free bodies. A single contact takes one
round, however much hangs on its bodies.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import pair_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.jointed.give import push_loads
from sandbox.engine.restitution.jointed.reach import Reach, count_passes, pass_on, work_left
from sandbox.engine.restitution.jointed.step_length import best_share, until
from sandbox.engine.restitution.solve_group import solve_group
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Records

_MOST_ROUNDS = 32
_MOST_PASSES = 64


@kernel
def solve_jointed(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    agreed: float,
    reach: Reach,
) -> None:
    """Find the loads as `solve_group` does, to `agreed` (m/s), of contacts on what reaches further by joints."""
    k = first
    while k != END:
        row = impacts.rows[k]
        row.load1 = row.load2 = row.drag = 0.0
        k = row.next
    for _ in range(_MOST_ROUNDS):
        push_loads(bodies, solver, contacts, impacts, first, 1.0, 1.0, reach)
        _note_openings(solver, contacts, impacts, first)
        count_passes(reach, solve_group(bodies, solver, contacts, impacts, first, True, agreed, _MOST_PASSES))
        if _change(bodies, contacts, impacts, first) <= agreed or work_left(reach) <= 0:
            break
        pass_on(solver, reach)
        share = _share_of(solver, contacts, impacts, first)
        k = first
        while k != END:
            row = impacts.rows[k]
            row.load1 = row.passed1 + share * (row.load1 - row.passed1)
            row.load2 = row.passed2 + share * (row.load2 - row.passed2)
            k = row.next
    push_loads(bodies, solver, contacts, impacts, first, 1.0, 1.0, reach)


@kernel
def _note_openings(solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int) -> None:
    """Note what has been passed on, and how fast points then open."""
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
        row.passed1 = row.load1
        row.passed2 = row.load2
        row.opening1 = opening_speed(now, contact, 1)
        row.opening2 = opening_speed(now, contact, 2)
        k = row.next


@kernel
def _change(bodies: Records, contacts: Records, impacts: ImpactList, first: int) -> float:
    """The most (m/s) that a round changes a speed, were its bodies free."""
    most = 0.0
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        mass = bodies[contact.body_a].inverse_mass + bodies[contact.body_b].inverse_mass
        change = mass * (abs(row.load1 - row.passed1) + abs(row.load2 - row.passed2))
        most = change if change > most else most
        k = row.next
    return most


@kernel
def _share_of(solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int) -> float:
    """The share of a round that does most of what is asked for, and lets no contact pull."""
    asked = changed = 0.0
    k = first
    while k != END:
        row = impacts.rows[k]
        contact = contacts[impacts.slots[k].contact]
        now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
        added = row.load1 - row.passed1
        if added != 0.0:
            asked += added * (row.rebound1 - row.opening1)
            changed += added * (opening_speed(now, contact, 1) - row.opening1)
        added = row.load2 - row.passed2
        if added != 0.0:
            asked += added * (row.rebound2 - row.opening2)
            changed += added * (opening_speed(now, contact, 2) - row.opening2)
        k = row.next
    share = best_share(asked, changed)
    k = first
    while k != END:
        row = impacts.rows[k]
        share = until(share, row.passed1 - row.load1, row.passed1)
        share = until(share, row.passed2 - row.load2, row.passed2)
        k = row.next
    return share
