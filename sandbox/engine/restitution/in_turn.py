"""Impacts one after the other, in the order of time, but for those that fall on a body in the same moment.

Contacts are looked at in turns. Of those that close, each strikes that shares no moving body with one that closes
earlier, together with what does in the same moment (`same_moment.py`); the others wait for the next turn. So no impact
of a turn knows of another, it does not matter in which order contacts come, and what is symmetric stays so. What shares
a body with one that has struck is looked at in the next turn, too.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver.nesterov import passes_within
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.earliest import LATER, note_closing, relation_to_others
from sandbox.engine.restitution.groups import ALONE, NOT_STRUCK, RATTLES, SPENT, note_first_strike
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.rattling import FEWEST_STRIKES, is_marked, rattles
from sandbox.engine.restitution.rebound_speed import closes, rebound_speed
from sandbox.engine.restitution.same_moment import join_same_moment, strike_alone, strike_together
from sandbox.engine.restitution.worklist import (
    END,
    Worklist,
    add_contact,
    add_contacts,
    list_all,
    take_first,
)
from sandbox.tables import Records

_SAME = 1.0 / 64.0
"""Share of a substep: what is no further apart falls in the same moment. At 240 substeps a second that is 0.07 ms, a
third of what balls of billiards touch each other in a blow."""
_MOST_PASSES = 256
_LEAST_PASSES = 16
"""What a group is given at least that strikes together, or its contacts strike alone."""
_MOST_WORK = 2_000
"""Passes times contacts of all that strike together in a substep: a hundred groups. What is left strikes alone."""
_AGREED = 1e-6
"""Share of its highest closing speed to which a group is solved."""


@kernel
def strike_in_turn(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, seconds: float
) -> bool:
    """Strike listed contacts until none closes; return whether that came to an end.

    Those that have struck have a `group` afterwards.
    """
    slots = impacts.slots
    for k in range(impacts.length):
        impacts.rows[k].group = ALONE
        solver.struck[slots[k].body_a] = solver.struck[slots[k].body_b] = NOT_STRUCK
    same = _SAME * abs(seconds)
    ended = True
    turn = 0
    left = _MOST_WORK
    listed = list_all(slots, impacts.length)
    while listed.first != END:
        turn += 1
        closing, ended = _select_closing(bodies, solver, contacts, impacts, listed, seconds, ended)
        closing = _relate(bodies, solver, impacts, closing, turn, same, ended)
        listed = Worklist(END, END)
        while closing.first != END:
            k = closing.first
            closing = take_first(slots, closing)
            if slots[k].turn == turn and impacts.rows[k].next != LATER:
                count = join_same_moment(bodies, solver, impacts, k, same)
                left -= _strike(bodies, solver, contacts, impacts, k, count, seconds, left)
                listed = _add_struck(bodies, solver, impacts, k, listed)
            else:  # it waits, or has struck together with one before it
                listed = add_contact(slots, k, listed)
    return ended


@kernel
def _select_closing(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    listed: Worklist,
    seconds: float,
    ended: bool,
) -> tuple[Worklist, bool]:
    """Those of a worklist that close and are to strike one by one; false if some do not end so, or `ended` is false, as
    some did not before."""
    slots = impacts.slots
    closing = Worklist(END, END)
    while listed.first != END:
        k = listed.first
        listed = take_first(slots, listed)
        slot = slots[k]
        if not ended and is_marked(solver, slot, RATTLES):
            continue
        contact = contacts[slot.contact]
        rebound = rebound_speed(solver, contact, slot, impacts.threshold, seconds)
        row = impacts.rows[k]
        if not closes(rebound) or row.passes >= SPENT:
            continue
        if slot.strikes >= FEWEST_STRIKES:
            note_first_strike(bodies, solver, contact, row)  # it may have found no more to do at each of its turns
            if rattles(bodies, solver, impacts, k, contact.restitution):
                ended = False
                continue
        row.moment = rebound.moment
        row.rebound1 = rebound.first
        row.rebound2 = rebound.second
        closing = add_contact(slots, k, closing)
    return closing, ended


@kernel
def _relate(
    bodies: Records,
    solver: SolverBodies,
    impacts: ImpactList,
    listed: Worklist,
    turn: int,
    same: float,
    ended: bool,
) -> Worklist:
    """Those that close, without what was found to rattle since they were listed. How each is to the others is noted in
    `next`: `LATER`, `JOINED`, or `END` if it strikes alone."""
    slots = impacts.slots
    closing = Worklist(END, END)
    while listed.first != END:
        k = listed.first
        listed = take_first(slots, listed)
        if ended or not is_marked(solver, slots[k], RATTLES):
            slots[k].turn = turn
            note_closing(bodies, solver, slots[k], impacts.rows[k].moment, turn)
            closing = add_contact(slots, k, closing)
    k = closing.first
    while k != END:
        row = impacts.rows[k]
        row.next = relation_to_others(bodies, solver, slots[k], row.moment, same)
        k = slots[k].following
    return closing


@kernel
def _strike(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    count: int,
    seconds: float,
    most: int,
) -> int:
    """Strike the `count` contacts that are linked from the `first` one on; return how much work that was, of `most`:
    passes times contacts of what strikes together."""
    if count > 1 and count * _LEAST_PASSES <= most:
        passes = passes_within(most, count, _MOST_PASSES)
        return strike_together(bodies, solver, contacts, impacts, first, passes, _AGREED)
    k = first
    while k != END:
        row = impacts.rows[k]
        slot = impacts.slots[k]
        if k != first:  # those before it may have stopped its bodies
            rebound = rebound_speed(solver, contacts[slot.contact], slot, impacts.threshold, seconds)
            row.rebound1 = rebound.first
            row.rebound2 = rebound.second
        strike_alone(bodies, solver, contacts[slot.contact], row)
        k = row.next
    return 0


@kernel
def _add_struck(bodies: Records, solver: SolverBodies, impacts: ImpactList, first: int, listed: Worklist) -> Worklist:
    """The worklist with all contacts of what has been struck: by the `first` contact and those linked from it on."""
    k = first
    while k != END:
        impacts.slots[k].strikes += 1
        listed = add_contacts(bodies, impacts.slots, k, solver.first_impact, listed)
        k = impacts.rows[k].next
    return listed
