"""Contacts with restitution that are still to be looked at, first in, first out.

A contact that strikes changes its bodies, so that all contacts of these are to be looked at again, and no others. An
impact so runs through a row of balls at one strike a contact, in whatever order they come.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.records.bodies import SolverBodies
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC

END = -1
"""No further contact, of a body or of the worklist."""
DONE = -2
"""`following` of a contact that is not in the worklist."""
IDLE = 0
"""`turn` of a contact that has struck since it closed, or has not closed."""


class Worklist(NamedTuple):
    """Its first and its last contact, each of which has the `following` one: rows of the slots, or `END`."""

    first: int
    last: int


@kernel
def link_contacts(bodies: Records, slots: Records, length: int, solver: SolverBodies) -> None:
    """Link the contacts `slots[:length]` of every dynamic body, in their order."""
    heads = solver.first_impact
    for k in range(length):
        for i in (slots[k].body_a, slots[k].body_b):
            if bodies[i].type == DYNAMIC:
                heads[i] = END
    for k in range(length - 1, -1, -1):
        slot = slots[k]
        slot.next_a = slot.next_b = END
        if bodies[slot.body_a].type == DYNAMIC:
            slot.next_a = heads[slot.body_a]
            heads[slot.body_a] = k
        if bodies[slot.body_b].type == DYNAMIC:
            slot.next_b = heads[slot.body_b]
            heads[slot.body_b] = k


@kernel
def list_all(slots: Records, length: int) -> Worklist:
    """A worklist of the contacts `slots[:length]`, none of which has struck."""
    for k in range(length):
        slots[k].strikes = 0
        slots[k].turn = IDLE
        slots[k].following = k + 1
    if length == 0:
        return Worklist(END, END)
    slots[length - 1].following = END
    return Worklist(0, length - 1)


@kernel
def take_first(slots: Records, listed: Worklist) -> Worklist:
    """What is left without the first contact, which is in the worklist no longer."""
    following = slots[listed.first].following
    slots[listed.first].following = DONE
    return Worklist(0 + following, listed.last if following != END else END)


@kernel
def add_contact(slots: Records, k: int, listed: Worklist) -> Worklist:
    """The worklist with contact k as its last, if it is not in it."""
    if slots[k].following != DONE:
        return listed
    slots[k].following = END
    if listed.last == END:
        return Worklist(k, k)
    slots[listed.last].following = k
    return Worklist(listed.first, k)


@kernel
def add_contacts(bodies: Records, slots: Records, k: int, heads: Integers, listed: Worklist) -> Worklist:
    """The worklist with all contacts of the bodies that contact k moves, `heads[i]` the first one of body i."""
    for i in (slots[k].body_a, slots[k].body_b):
        if bodies[i].type == DYNAMIC:
            j = heads[i]
            while j != END:
                listed = add_contact(slots, j, listed)
                j = next_contact(slots[j], i)
    return listed


@inlined_kernel
def next_contact(slot: Records, i: int) -> int:
    """The next contact of body i."""
    return int(slot.next_a if slot.body_a == i else slot.next_b)
