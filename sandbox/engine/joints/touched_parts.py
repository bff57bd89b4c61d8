"""Which parts something bears, touches or drags: how a part may be solved depends on it."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Records


@kernel
def flag_touched_parts(work: JointWork, contacts: Contacts, drags: Records) -> None:
    """Set `supported`, `free` and `dragged` of all parts, from the contacts of this step and who is dragged."""
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        part.supported = 0
        part.free = 1
        part.dragged = 0
    for slot in contacts.active[1 : 1 + contacts.active[0].contact]:
        for side in range(2):
            p = work.part_of[slot.body_a if side == 0 else slot.body_b]
            if p >= 0:
                contact = contacts.now[slot.contact]
                work.parts[p].free = 0
                if contact.normal_impulse1 > 0.0 or contact.normal_impulse2 > 0.0:
                    work.parts[p].supported = 1
    for k in range(drags.shape[0]):
        body = drags[k].body
        if body >= 0 and work.part_of[body] >= 0:
            work.parts[work.part_of[body]].dragged = 1
