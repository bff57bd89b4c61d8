"""Impacts that fall on a body in the same moment strike together: each rebounds as it would alone.

A ball that falls into a notch rebounds straight, a box that lands flat on two posts leaves flat. The impulses are those
of one complementarity problem, with Newton's restitution of each contact (J. J. Moreau 1985; S. Goyal, A. Ruina and J.
Papadopoulos 1991). As all of these close in, they take energy or keep it, however their restitution differs.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import start_velocity
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.earliest import LATER
from sandbox.engine.restitution.elastic import strike_elastic
from sandbox.engine.restitution.groups import CLOSING, fastest, note_first_strike
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.rebound import rebound
from sandbox.engine.restitution.rebound_speed import NONE
from sandbox.engine.restitution.solve_group import solve_group
from sandbox.engine.restitution.worklist import END, IDLE, next_contact
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC


@kernel
def join_same_moment(bodies: Records, solver: SolverBodies, impacts: ImpactList, first: int, same: float) -> int:
    """Link the contacts that strike together with the `first` one: those of its turn that close in the same moment, to
    within `same` (s), and share a body that moves with it, or with one of them. Returns how many they are.

    In: the `next` of each says how it is to the others (`earliest.py`). Out: the next one, or `END`.
    """
    slots = impacts.slots
    rows = impacts.rows
    turn = slots[first].turn
    slots[first].turn = IDLE
    count = 1
    if rows[first].next == END:
        return count
    rows[first].next = END
    k = last = first
    while k != END:
        slot = slots[k]
        for i in (slot.body_a, slot.body_b):
            if bodies[i].type != DYNAMIC:
                continue
            j = solver.first_impact[i]
            while j != END:
                joins = slots[j].turn == turn and rows[j].next != LATER
                if joins and abs(rows[j].moment - rows[k].moment) <= same:
                    slots[j].turn = IDLE
                    rows[j].next = END
                    rows[last].next = j
                    last = j
                    count += 1
                j = next_contact(slots[j], i)
        k = rows[k].next
    return count


@kernel
def strike_alone(bodies: Records, solver: SolverBodies, contact: Records, row: Records) -> None:
    """Strike a contact, if it is to rebound."""
    if row.rebound1 == NONE and row.rebound2 == NONE:
        return
    note_first_strike(bodies, solver, contact, row)
    start = start_velocity(solver.free_motions, contact)
    change1 = row.rebound1 - opening_speed(start, contact, 1)
    change2 = row.rebound2 - opening_speed(start, contact, 2) if contact.point_count == 2 else NONE
    strike_elastic(bodies, solver, contact, change1, change2)


@kernel
def strike_together(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    passes: int,
    agreed: float,
) -> int:
    """Strike the contacts that are linked from the `first` one on, in so many passes at most, or until one changes no
    velocity by more than the share `agreed` of the highest closing speed; returns the work, passes times contacts."""
    k = first
    while k != END:
        note_first_strike(bodies, solver, contacts[impacts.slots[k].contact], impacts.rows[k])
        k = impacts.rows[k].next
    slow = agreed * fastest(solver, contacts, impacts, first, CLOSING)
    work = solve_group(bodies, solver, contacts, impacts, first, False, False, slow, passes)
    rebound(bodies, solver, contacts, impacts, first, 1.0, agreed, None)
    return int(work)
