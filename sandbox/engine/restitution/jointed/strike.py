"""Impacts on jointed bodies: joints pass them on at once, and what is struck rebounds all the same.

Impacts strike as if bodies were free (`impacts.py`). Where joints then take of what they have done, those of all that
hangs together are taken back, and strike in turns, all that close at once: for the loads under which each point opens
as fast as is asked, while joints pass them on (`loads.py`), with the friction that these allow. Where joints
take nothing, as in a cradle whose balls hang on rods, impacts stay as they were.
"""

from __future__ import annotations

from sandbox._jit import entry_point, kernel
from sandbox.engine.contact_solver.closing_speed import opening_speed
from sandbox.engine.contact_solver.law import anchors_of, pair_velocity, relative_velocity, start_velocity
from sandbox.engine.joints.direct.records import MOST_STRUCK
from sandbox.engine.joints.direct.transmit import begin_blows
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import Workers
from sandbox.engine.restitution.groups import (
    OPENING,
    fastest,
    form_jointed_groups,
    is_driven,
    size_of,
    starts_group,
    take_back,
)
from sandbox.engine.restitution.impact_list import ImpactList, listed_impacts
from sandbox.engine.restitution.jointed.loads import solve_jointed
from sandbox.engine.restitution.jointed.parts import (
    LAST,
    are_driven,
    count_parts,
    forget_batches,
    forget_parts,
    list_batches,
    list_parts,
)
from sandbox.engine.restitution.jointed.reach import Reach, begin_pushes, end_pushes, keep_joints, take_over, work_left
from sandbox.engine.restitution.jointed.single_contact import strike_rough_jointed
from sandbox.engine.restitution.rebound import rebound
from sandbox.engine.restitution.rebound_speed import rebound_speed
from sandbox.engine.restitution.worklist import END
from sandbox.engine.workers.task_kinds import IMPACT_SECONDS
from sandbox.tables import Records

_AGREED = 1e-4
"""Share of the highest speed that is asked for to which all agree."""
_LEAST_WORK = 8
"""For a contact: it strikes two parts, and to find its load and to give it takes four rounds."""


@entry_point
def strike_through_joints(
    state: StateTables,
    solver: SolverBodies,
    contacts: Contacts,
    blocks: ContactBlocks,
    joints: JointWork,
    workers: Workers,
) -> None:
    """Pass the impacts of a substep on batch 0, which have struck, on through the joints of factorised parts.

    `strike_batch` calls it by its address, and the substeps have told both what they need to know.
    """
    impacts = listed_impacts(state, blocks, 0)
    seconds = workers.numbers[IMPACT_SECONDS]
    _strike_through(state.bodies, solver, contacts.now, impacts, joints, seconds)


@kernel
def _strike_through(
    bodies: Records, solver: SolverBodies, contacts: Records, impacts: ImpactList, work: JointWork, seconds: float
) -> None:
    """The same for the impacts that are listed, in a substep of `seconds`."""
    if not form_jointed_groups(bodies, impacts, solver.struck, work):
        return
    begin_blows(work.direct)
    for k in range(impacts.length):
        if starts_group(impacts, k, solver.struck):
            head = list_parts(impacts, work, k)
            if _may_strike(bodies, impacts, k, work, head):
                reach = Reach(work, head, list_batches(work, head), abs(seconds))
                _strike(bodies, solver, contacts, impacts, k, reach, seconds)
                forget_batches(work, head)
            forget_parts(work, head)


@kernel
def _may_strike(bodies: Records, impacts: ImpactList, first: int, work: JointWork, head: int) -> bool:
    """Whether a group is small enough, and nothing drives it, which would give it energy without bounds."""
    if head == LAST or size_of(impacts, first) > MOST_STRUCK:
        return False
    return not (is_driven(bodies, impacts, first) or are_driven(bodies, work, head))


@kernel
def _strike(
    bodies: Records,
    solver: SolverBodies,
    contacts: Records,
    impacts: ImpactList,
    first: int,
    reach: Reach,
    seconds: float,
) -> None:
    """The same for the group that is linked from impact `first` on, if there is work left for it."""
    count = size_of(impacts, first)
    least = 2 * count_parts(reach.work, reach.head) + _LEAST_WORK * count
    if work_left(reach) < least:  # where each contact closes by what the one before it has done
        return
    begin_pushes(bodies, solver, impacts, first, reach)
    keep_joints(solver, reach)
    if _taken(solver, contacts, impacts, first) <= _AGREED * fastest(solver, contacts, impacts, first, OPENING):
        take_over(bodies, solver, impacts, first, reach)
    else:
        take_back(bodies, solver, contacts, impacts, first)
        begin_pushes(bodies, solver, impacts, first, reach)
        keep_joints(solver, reach)
        take_over(bodies, solver, impacts, first, reach)
        for _ in range(2 * count):
            if work_left(reach) < _LEAST_WORK:
                break
            agreed = _AGREED * _ask(solver, contacts, impacts, first, seconds)
            if agreed <= 0.0:
                break
            solve_jointed(bodies, solver, contacts, impacts, first, False, agreed, reach)
            contact = contacts[impacts.slots[first].contact]
            if impacts.rows[first].next == END and contact.point_count == 1 and contact.friction > 0.0:
                strike_rough_jointed(bodies, solver, contacts, impacts, first, reach)
            else:
                rebound(bodies, solver, contacts, impacts, first, 1.0, _AGREED, reach)
    end_pushes(bodies, solver, impacts, first, reach)


@kernel
def _ask(solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int, seconds: float) -> float:
    """Ask of each contact how it is to rebound; returns the highest speed (m/s) that is asked for, or 0 if none
    closes."""
    highest = 0.0
    k = first
    while k != END:
        row = impacts.rows[k]
        slot = impacts.slots[k]
        asked = rebound_speed(solver, contacts[slot.contact], slot, impacts.threshold, seconds)
        row.rebound1 = asked.first
        row.rebound2 = asked.second
        highest = asked.first if asked.first > highest else highest
        highest = asked.second if asked.second > highest else highest
        k = row.next
    return highest


@kernel
def _taken(solver: SolverBodies, contacts: Records, impacts: ImpactList, first: int) -> float:
    """The most that joints change the speed (m/s) of a point to its other side: along the normal, or, where it rubs, at
    all."""
    most = 0.0
    k = first
    while k != END:
        contact = contacts[impacts.slots[k].contact]
        start = start_velocity(solver.free_motions, contact)
        now = pair_velocity(solver.motions[contact.body_a], solver.motions[contact.body_b])
        for point in range(1, contact.point_count + 1):
            taken = abs(opening_speed(now, contact, point) - opening_speed(start, contact, point))
            if contact.friction > 0.0:
                before_x, before_y = relative_velocity(start, anchors_of(contact, point))
                x, y = relative_velocity(now, anchors_of(contact, point))
                taken += abs((x - before_x) * contact.normal_y - (y - before_y) * contact.normal_x)
            most = taken if taken > most else most
        k = impacts.rows[k].next
    return most
