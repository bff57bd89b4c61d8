"""Groups of impacts: contacts that strike, joined by the bodies that they have in common and that move.

Union-find over bodies, as for islands (R. Tarjan, J. van Leeuwen, 1984), in `solver.struck`; a group is a list of
impacts in their order, linked by `next`, so that no group's result depends on another.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.islands import root_of, unite
from sandbox.engine.records.bodies import SolverBodies
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC

NOT_STRUCK, STRUCK = -1, 0
"""`solver.struck` of a body before and after the first impact of the substep, until groups are formed."""
ALONE = -1
"""`group` of an impact that has not struck."""
STRIKES = 0
"""`group` of one that has, before groups are formed."""


@kernel
def note_first_strike(bodies: Records, solver: SolverBodies, contact: Records, slot: Records) -> None:
    """Keep what a contact and its bodies had before the impacts of the substep, if these strike for the first time."""
    if slot.group != ALONE:
        return
    slot.group = STRIKES
    slot.impulse = contact.impact_impulse
    for i in (contact.body_a, contact.body_b):
        if bodies[i].type == DYNAMIC and solver.struck[i] == NOT_STRUCK:
            solver.struck[i] = STRUCK
            _copy_velocities(solver.free_motions[i], solver.before_impacts[i])


@kernel
def take_back(bodies: Records, solver: SolverBodies, contacts: Records, group: Records) -> None:
    """Undo all impacts of the substep in a group."""
    k = 0
    while k >= 0:
        slot = group[k]
        contact = contacts[slot.contact]
        contact.impact_impulse = slot.impulse
        for i in (contact.body_a, contact.body_b):
            if bodies[i].type == DYNAMIC:
                _copy_velocities(solver.before_impacts[i], solver.free_motions[i])
        k = next_of(group, k)


@inlined_kernel
def _copy_velocities(source: Records, target: Records) -> None:
    """Copy what `IMPACT_VELOCITIES` lists from one row of a table that has it to a row of another."""
    target.start_x = source.start_x
    target.start_y = source.start_y
    target.start_w = source.start_w
    target.free_x = source.free_x
    target.free_y = source.free_y
    target.free_w = source.free_w


@kernel
def form_groups(bodies: Records, slots: Records, lowest: Integers) -> None:
    """Link the impacts that are not `ALONE`, each group from its first on, which `starts_group` tells.

    `lowest` is scratch with a row a body.
    """
    for slot in slots:
        lowest[slot.body_a] = slot.body_a
        lowest[slot.body_b] = slot.body_b
    for slot in slots:
        if slot.group != ALONE and bodies[slot.body_a].type == DYNAMIC and bodies[slot.body_b].type == DYNAMIC:
            unite(lowest, slot.body_a, slot.body_b)
    for slot in slots:
        if slot.group != ALONE:
            moves = slot.body_a if bodies[slot.body_a].type == DYNAMIC else slot.body_b
            slot.group = root_of(lowest, moves)
    for k in range(slots.shape[0] - 1, -1, -1):
        slot = slots[k]
        if slot.group != ALONE:
            head = lowest[slot.group]  # the body itself before its first impact, then that one's number, negative
            slot.further = -1 - head - k if head < 0 else 0
            lowest[slot.group] = -1 - k


@kernel
def next_of(group: Records, k: int) -> int:
    """The number of the next impact of a group, counted from its first; -1 after the last."""
    further = group[k].further
    return int(k + further if further > 0 else -1)


@kernel
def size_of(group: Records) -> int:
    """How many impacts a group has."""
    count = 0
    k = 0
    while k >= 0:
        count += 1
        k = next_of(group, k)
    return count


@kernel
def starts_group(slots: Records, k: int, lowest: Integers) -> bool:
    """Whether an impact is the first one of a group, of those that `form_groups` has linked."""
    return bool(slots[k].group != ALONE and lowest[slots[k].group] == -1 - k)
