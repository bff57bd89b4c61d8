"""Islands: sets of active bodies joined by contacts and joints, found by union-find with path halving.

R. Tarjan, J. van Leeuwen, "Worst-case analysis of set union algorithms", 1984; the root is the lowest row, so that it
does not depend on the order of the contacts.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Integers, Records


@kernel
def find_islands(
    bodies: Records,
    active_bodies: Integers,
    islands: Integers,
    contacts: Contacts,
    joints: JointWork,
) -> None:
    """Write into `islands` of every active body the lowest row of its island."""
    for i in active_bodies:
        islands[i] = i
    for slot in contacts.active[1 : 1 + contacts.active[0].contact]:
        if is_active(bodies[slot.body_a]) and is_active(bodies[slot.body_b]):
            unite(islands, slot.body_a, slot.body_b)
    for i in range(joints.ties.shape[0]):
        if is_active(bodies[joints.ties[i].low]) and is_active(bodies[joints.ties[i].high]):
            unite(islands, joints.ties[i].low, joints.ties[i].high)
    for i in active_bodies:
        islands[i] = root_of(islands, i)


@kernel
def unite(islands: Integers, i: int, j: int) -> None:
    """Put two bodies into one island."""
    if islands[i] == islands[j]:
        return
    a = root_of(islands, i)
    b = root_of(islands, j)
    if a < b:
        islands[b] = a
    elif b < a:
        islands[a] = b


@kernel
def root_of(islands: Integers, i: int) -> int:
    """Root of body i; halves the path on its way."""
    while islands[i] != i:
        islands[i] = islands[islands[i]]
        i = islands[i]
    return i
