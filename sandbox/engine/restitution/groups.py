"""Groups of impacts: contacts that strike, joined by the bodies that they have in common and that move.

Union-find over bodies, as for islands (R. Tarjan, J. van Leeuwen, 1984), in `solver.struck`; a group is a list of
impacts in their order, linked by `next`, so that no group's result depends on another.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.active.islands import root_of, unite
from sandbox.engine.records.bodies import SolverBodies
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC

NOT_STRUCK = -1
"""`solver.struck` of a body that no impact of the substep has changed."""
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
            kept = solver.before_impacts[i]
            free_motion = solver.free_motions[i]
            kept.start_x = free_motion.start_x
            kept.start_y = free_motion.start_y
            kept.start_w = free_motion.start_w
            kept.free_x = free_motion.free_x
            kept.free_y = free_motion.free_y
            kept.free_w = free_motion.free_w


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
                kept = solver.before_impacts[i]
                free_motion = solver.free_motions[i]
                free_motion.start_x = kept.start_x
                free_motion.start_y = kept.start_y
                free_motion.start_w = kept.start_w
                free_motion.free_x = kept.free_x
                free_motion.free_y = kept.free_y
                free_motion.free_w = kept.free_w
        k = next_of(group, k)


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
def starts_group(slots: Records, k: int, lowest: Integers) -> bool:
    """Whether an impact is the first one of a group, of those that `form_groups` has linked."""
    return bool(slots[k].group != ALONE and lowest[slots[k].group] == -1 - k)
