"""Groups of impacts: contacts that strike, joined by the bodies that they have in common and that move.

Union-find over bodies, as for islands (R. Tarjan, J. van Leeuwen, 1984), in `solver.struck`; a group is a list of
impacts in their order, linked by `next`, so that no group's result depends on another.
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.islands import root_of, unite
from sandbox.engine.bodies.flags import is_driving
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import start_velocity
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.jointed.parts import first_of_part
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC

CLOSING, OPENING = -1.0, 1.0
"""Which way `fastest` looks."""
NOT_STRUCK = 0
STRUCK = 1 << 41
"""Bit of `solver.struck` of a body after the first impact of the substep, until groups are formed; the others are the
last turn in which one of its contacts closed (`earliest.py`)."""
RATTLES, DRIVEN = 1 << 42, 1 << 43
"""Bits of `solver.struck` of a body in a group that does not end one by one, and in one that something drives as well
(`rattling.py`)."""
MARKS = STRUCK | RATTLES | DRIVEN
ALONE = -1
"""`group` of an impact that has not struck."""
SPENT = 1 << 20
"""`passes` of an impact whose group has had all that it may take in the step: it does not strike any more."""
STRIKES = 0
"""`group` of one that has, before groups are formed."""


@kernel
def note_first_strike(bodies: Records, solver: SolverBodies, contact: Records, row: Records) -> None:
    """Keep what a contact and its bodies had before the impacts of the substep, if these strike for the first time."""
    if row.group != ALONE:
        return
    row.group = STRIKES
    row.impulse = contact.impact_impulse
    for i in (contact.body_a, contact.body_b):
        if bodies[i].type == DYNAMIC and solver.struck[i] & STRUCK == 0:
            solver.struck[i] |= STRUCK
            _copy_velocities(solver.free_motions[i], solver.impact_bodies[i])


@kernel
def take_back(bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int) -> None:
    """Undo all impacts of the substep in the group that is linked from the `first` one on."""
    k = first
    while k != END:
        contact = contacts[impacts.slots[k].contact]
        contact.impact_impulse = impacts.rows[k].impulse
        for i in (contact.body_a, contact.body_b):
            if bodies[i].type == DYNAMIC:
                _copy_velocities(solver.impact_bodies[i], solver.free_motions[i])
        k = impacts.rows[k].next


@kernel
def is_driven(bodies: Records, impacts: ImpactList, first: int) -> bool:
    """Whether something without mass that moves strikes too."""
    k = first
    while k != END:
        if is_driving(bodies[impacts.slots[k].body_a]) or is_driving(bodies[impacts.slots[k].body_b]):
            return True
        k = impacts.rows[k].next
    return False


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
def form_groups(bodies: Records, impacts: ImpactList, lowest: Integers) -> None:
    """Link the impacts that are not `ALONE`, each group from its first on, which `starts_group` tells.

    `lowest` is scratch with a row a body.
    """
    _begin_groups(impacts, lowest)
    _unite_struck(bodies, impacts, lowest)
    _link_groups(bodies, impacts, lowest)


@kernel
def form_jointed_groups(bodies: Records, impacts: ImpactList, lowest: Integers, work: JointWork) -> bool:
    """The same, where bodies of one factorised part belong together, if some have struck; returns whether any have."""
    _begin_groups(impacts, lowest)
    reached = False
    for k in range(impacts.length):
        if impacts.rows[k].group != ALONE:
            for i in (impacts.slots[k].body_a, impacts.slots[k].body_b):
                first = first_of_part(work, i)
                if first >= 0:
                    lowest[first] = first
                    reached = True
    if not reached:
        return False
    _unite_struck(bodies, impacts, lowest)
    for k in range(impacts.length):
        if impacts.rows[k].group != ALONE:
            for i in (impacts.slots[k].body_a, impacts.slots[k].body_b):
                first = first_of_part(work, i)
                if first >= 0:
                    unite(lowest, i, first)
    _link_groups(bodies, impacts, lowest)
    return True


@kernel
def _begin_groups(impacts: ImpactList, lowest: Integers) -> None:
    """Each body belongs to itself."""
    slots: Any = impacts.slots[: impacts.length]
    for slot in slots:
        lowest[slot.body_a] = slot.body_a
        lowest[slot.body_b] = slot.body_b


@kernel
def _unite_struck(bodies: Records, impacts: ImpactList, lowest: Integers) -> None:
    """Unite bodies that strike each other."""
    for k in range(impacts.length):
        slot = impacts.slots[k]
        struck = impacts.rows[k].group != ALONE
        if struck and bodies[slot.body_a].type == DYNAMIC and bodies[slot.body_b].type == DYNAMIC:
            unite(lowest, slot.body_a, slot.body_b)


@kernel
def _link_groups(bodies: Records, impacts: ImpactList, lowest: Integers) -> None:
    """Link the impacts of bodies that belong together."""
    rows = impacts.rows
    for k in range(impacts.length):
        if rows[k].group != ALONE:
            slot = impacts.slots[k]
            moves = slot.body_a if bodies[slot.body_a].type == DYNAMIC else slot.body_b
            rows[k].group = root_of(lowest, moves)
    for k in range(impacts.length - 1, -1, -1):
        row = rows[k]
        if row.group != ALONE:
            head = lowest[row.group]  # the body itself before its first impact, then that one's number, negative
            row.next = -1 - head if head < 0 else END
            lowest[row.group] = -1 - k


@kernel
def size_of(impacts: ImpactList, first: int) -> int:
    """How many impacts are linked from the `first` one on."""
    count = 0
    k = first
    while k != END:
        count += 1
        k = impacts.rows[k].next
    return count


@kernel
def fastest(solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int, way: float) -> float:
    """The highest speed (m/s) of the impacts that are linked from the `first` one on, `CLOSING` or `OPENING`."""
    highest = 0.0
    k = first
    while k != END:
        contact = contacts[impacts.slots[k].contact]
        start = start_velocity(solver.free_motions, contact)
        for point in range(1, contact.point_count + 1):
            speed = way * opening_speed(start, contact, point)
            highest = speed if speed > highest else highest
        k = impacts.rows[k].next
    return highest


@kernel
def starts_group(impacts: ImpactList, k: int, lowest: Integers) -> bool:
    """Whether an impact is the first one of a group, of those that `form_groups` has linked."""
    group = impacts.rows[k].group
    return bool(group != ALONE and lowest[group] == -1 - k)
