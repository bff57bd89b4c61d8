"""The factorised parts that a group of impacts reaches, and their batches: linked, each once, by `next_struck`."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import WIDTH
from sandbox.engine.bodies.flags import is_driving
from sandbox.engine.joints.direct.transmit import forget_stops, set_struck
from sandbox.engine.joints.records import JointWork
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.restitution.worklist import END
from sandbox.tables import Records

UNLISTED = 0
LAST = -1
"""`next_struck` of the last one, and the head of an empty list; of the others it is 1 + the next one."""
NO_PART = -1


@inlined_kernel
def factorised_part(work: JointWork, i: int) -> int:
    """The part of body i, if it is factorised, or `NO_PART`."""
    p = work.part_of[i]
    return int(p) if p >= 0 and work.parts[p].direct == 1 and work.parts[p].current == 1 else NO_PART


@inlined_kernel
def first_of_part(work: JointWork, i: int) -> int:
    """The first body of the part of body i, or `NO_PART`."""
    p = factorised_part(work, i)
    return int(work.members[work.parts[p].first_member].body) if p != NO_PART else NO_PART


@kernel
def list_parts(impacts: ImpactList, work: JointWork, first: int) -> int:
    """List the parts of what the impacts strike that are linked from the `first` one on; returns 1 + the first part, or
    `LAST`."""
    head = LAST
    k = first
    while k != END:
        slot = impacts.slots[k]
        for i in (slot.body_a, slot.body_b):
            p = factorised_part(work, i)
            if p != NO_PART and work.parts[p].next_struck == UNLISTED:
                work.parts[p].next_struck = head
                head = p + 1
        k = impacts.rows[k].next
    return head


@kernel
def list_batches(work: JointWork, head: int) -> int:
    """List the batches of the parts listed from `head` on, which the next impacts reach; returns 1 + the first one."""
    d = work.direct
    listed = LAST
    p = head
    while p != LAST:
        part = work.parts[p - 1]
        forget_stops(d, part.lane)
        batch = d.batches[part.lane // WIDTH]
        if batch.next_struck == UNLISTED:
            batch.next_struck = listed
            listed = part.lane // WIDTH + 1
        p = part.next_struck
    return listed


@kernel
def forget_batches(work: JointWork, head: int) -> None:
    """List no batch any longer, of those of the parts listed from `head` on."""
    p = head
    while p != LAST:
        part = work.parts[p - 1]
        set_struck(work.direct, part.lane, False)
        work.direct.batches[part.lane // WIDTH].next_struck = UNLISTED
        p = part.next_struck


@kernel
def count_parts(work: JointWork, head: int) -> int:
    """How many parts are listed from `head` on."""
    count = 0
    p = head
    while p != LAST:
        count += 1
        p = work.parts[p - 1].next_struck
    return count


@kernel
def are_driven(bodies: Records, work: JointWork, head: int) -> bool:
    """Whether something without mass that moves is joined to one of the listed parts."""
    p = head
    while p != LAST:
        part = work.parts[p - 1]
        layout = work.direct.layouts[part.layout]
        for k in range(part.first_fixed, part.first_fixed + layout.seats - layout.moving):
            i = work.direct.fixed[k]
            if i >= 0 and is_driving(bodies[i]):
                return True
        p = part.next_struck
    return False


@kernel
def forget_parts(work: JointWork, head: int) -> None:
    """List no part any longer, of those from `head` on."""
    p = head
    while p != LAST:
        part = work.parts[p - 1]
        p = part.next_struck
        part.next_struck = UNLISTED
