"""Stage: wake every sleeping island that something active touches. An island wakes as a whole."""

from __future__ import annotations

from typing import Any

from sandbox._jit import kernel
from sandbox.engine.active.sleeping_islands import touch_row, wake_marked_islands
from sandbox.engine.bodies.flags import disturbs
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Records


@kernel
def wake_touched(
    bodies: Records,
    contacts: Contacts,
    joints: JointWork,
    active: ActiveSet,
    counters: Records,
) -> bool:
    """Wake every island that has a contact or a joint with an active or a driven body.

    Returns whether there was one: then the active set is out of date.
    """
    touched: Any = contacts.active[1 : 1 + contacts.active[0].contact]
    if counters[0].asleep_count == 0:
        return False
    if not (_some_touched(bodies, touched) or _some_joined(bodies, joints)):
        return False
    for slot in touched:
        _wake_either(bodies, slot.body_a, slot.body_b, active)
    for i in range(joints.ties.shape[0]):
        _wake_either(bodies, joints.ties[i].low, joints.ties[i].high, active)
    wake_marked_islands(bodies, active)
    return True


@kernel
def _some_touched(bodies: Records, touched: Records) -> bool:
    """Whether a sleeping body has a contact with an active or a driven one."""
    found = False
    for slot in touched:
        found = found or _disturbed(bodies[slot.body_a], bodies[slot.body_b])
    return found


@kernel
def _some_joined(bodies: Records, joints: JointWork) -> bool:
    """Whether a joint ties a sleeping body to an active or a driven one."""
    found = False
    for i in range(joints.ties.shape[0]):
        found = found or _disturbed(bodies[joints.ties[i].low], bodies[joints.ties[i].high])
    return found


@kernel
def _disturbed(a: Records, b: Records) -> bool:
    return bool((a.awake == 0 and disturbs(b)) or (b.awake == 0 and disturbs(a)))


@kernel
def _wake_either(bodies: Records, a: int, b: int, active: ActiveSet) -> None:
    if bodies[a].awake == 0 and disturbs(bodies[b]):
        _wake(bodies, a, active)
    elif bodies[b].awake == 0 and disturbs(bodies[a]):
        _wake(bodies, b, active)


@kernel
def _wake(bodies: Records, i: int, active: ActiveSet) -> None:
    bodies[i].awake = 1
    touch_row(active, i)
