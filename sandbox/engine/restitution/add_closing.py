"""Who joins what strikes together: contacts that close by what it has done, and what touches beyond them.

What touches takes part in the blow, as the next boxes of a stack that lands do: were each to join when it closes, a
stack would strike as often as it is high. So every round adds twice as many contacts in a row as the one before.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.groups import ALONE, NOT_STRUCK, SPENT, STRUCK, note_first_strike
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.rebound_speed import closes, gap_at, rebound_speed
from sandbox.engine.restitution.worklist import DONE, END, IDLE, Worklist, add_contact, next_contact, take_first
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC

JOINS = -1
"""`turn` of a contact that has joined in the last round."""


@kernel
def add_closing(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, seconds: float, layers: int
) -> bool:
    """Let contacts that close strike too, and what touches, so many `layers` of contacts from those that had not struck
    before; return whether any close. Those that join get the turn `JOINS`."""
    slots = impacts.slots
    found = False
    listed = Worklist(END, END)
    _begin_round(solver, impacts)
    for k in range(impacts.length):
        contact = contacts[slots[k].contact]
        if closes(rebound_speed(solver, contact, slots[k], impacts.threshold, seconds)):
            found = found or impacts.rows[k].passes < SPENT
            if impacts.rows[k].group == ALONE:
                listed = _join(bodies, solver, contacts, impacts, k, listed)
    near = impacts.threshold * abs(seconds)
    for _ in range(layers):
        listed = _add_layer(bodies, solver, contacts, impacts, listed, near)
    return found


@kernel
def _begin_round(solver: SolverBodies, impacts: ImpactList) -> None:
    """Nobody has joined yet, and bodies have `STRUCK` again, in the place of their groups."""
    slots = impacts.slots
    for k in range(impacts.length):
        slots[k].turn = IDLE
        slots[k].following = DONE
        solver.struck[slots[k].body_a] = solver.struck[slots[k].body_b] = NOT_STRUCK
    for k in range(impacts.length):
        if impacts.rows[k].group != ALONE:
            solver.struck[slots[k].body_a] = solver.struck[slots[k].body_b] = STRUCK


@kernel
def _join(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, k: int, listed: Worklist
) -> Worklist:
    """Let contact k strike too, and list it."""
    note_first_strike(bodies, solver, contacts[impacts.slots[k].contact], impacts.rows[k])
    impacts.slots[k].turn = JOINS
    return add_contact(impacts.slots, k, listed)


@kernel
def _add_layer(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, listed: Worklist, near: float
) -> Worklist:
    """Let what touches the bodies of the listed contacts, with gaps of less than `near` (m), strike too; list that."""
    slots = impacts.slots
    layer = Worklist(END, END)
    while listed.first != END:
        k = listed.first
        listed = take_first(slots, listed)
        for i in (slots[k].body_a, slots[k].body_b):
            if bodies[i].type == DYNAMIC:
                j = solver.first_impact[i]
                while j != END:
                    if impacts.rows[j].group == ALONE and _touches(solver, contacts[slots[j].contact], slots[j], near):
                        layer = _join(bodies, solver, contacts, impacts, j, layer)
                    j = next_contact(slots[j], i)
    return layer


@kernel
def _touches(solver: SolverBodies, contact: Records, slot: Records, near: float) -> bool:
    """Whether a gap is smaller than `near` (m)."""
    motion_a = solver.motions[slot.body_a]
    motion_b = solver.motions[slot.body_b]
    if gap_at(motion_a, motion_b, contact, 1) < near:
        return True
    return bool(contact.point_count == 2 and gap_at(motion_a, motion_b, contact, 2) < near)
