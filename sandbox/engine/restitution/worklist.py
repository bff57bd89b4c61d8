"""Contacts with restitution that are still to be looked at, first in, first out.

A contact that strikes changes its bodies, so that all contacts of these are to be looked at again, and no others. An
impact so runs through a row of balls at one strike a contact, in whatever order they come.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.records.bodies import SolverBodies
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC

END = -1
"""No further contact, of a body or of the worklist."""
DONE = -2
"""`following` of a contact that is not in the worklist."""


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
def add_all(slots: Records, length: int) -> tuple[int, int]:
    """Put the contacts `slots[:length]` into the empty worklist, none of which has struck: its first and its last."""
    for k in range(length):
        slots[k].strikes = 0
        slots[k].following = k + 1
    if length == 0:
        return END, END
    slots[length - 1].following = END
    return 0, length - 1


@kernel
def take_first(slots: Records, first: int, last: int) -> tuple[int, int]:
    """Take the first contact out of the worklist: the first and the last of what is left."""
    following = slots[first].following
    slots[first].following = DONE
    return following, (last if following != END else END)


@kernel
def add_contacts(slots: Records, i: int, head: int, first: int, last: int) -> tuple[int, int]:
    """Add the contacts of body i, which begin with `head`, as far as they are not in the worklist: its first and its
    last."""
    k = head
    while k != END:
        slot = slots[k]
        if slot.following == DONE:
            slot.following = END
            if last == END:
                first = k
            else:
                slots[last].following = k
            last = k
        k = _next(slot, i)
    return first, last


@inlined_kernel
def _next(slot: Records, i: int) -> int:
    """The next contact of body i."""
    return int(slot.next_a if slot.body_a == i else slot.next_b)
