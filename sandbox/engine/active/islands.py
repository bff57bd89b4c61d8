"""Islands: sets of active bodies joined by contacts and joints, found by union-find with path halving.

R. Tarjan, J. van Leeuwen, "Worst-case analysis of set union algorithms", 1984; the root is the lowest row, so that it
does not depend on the order of the contacts.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Integers, Records


@kernel
def find_islands(
    bodies: Records,
    active_bodies: Integers,
    free_motions: Records,
    contacts: Records,
    active_contacts: Integers,
    joints: JointWork | None,
) -> None:
    """Write `free_motion.island` of every active body: the lowest row of its island."""
    for i in active_bodies:
        free_motions[i].island = i
    for i in active_contacts:
        contact = contacts[i]
        if is_active(bodies[contact.body_a]) and is_active(bodies[contact.body_b]):
            _unite(free_motions, contact.body_a, contact.body_b)
    if joints is not None:
        for i in range(joints.ties.shape[0]):
            if is_active(bodies[joints.ties[i].low]) and is_active(bodies[joints.ties[i].high]):
                _unite(free_motions, joints.ties[i].low, joints.ties[i].high)
    for i in active_bodies:
        free_motions[i].island = _root(free_motions, i)


@kernel
def _unite(free_motions: Records, i: int, j: int) -> None:
    """Put two bodies into one island."""
    a = _root(free_motions, i)
    b = _root(free_motions, j)
    if a < b:
        free_motions[b].island = a
    elif b < a:
        free_motions[a].island = b


@kernel
def _root(free_motions: Records, i: int) -> int:
    """Root of body i; halves the path on its way."""
    while free_motions[i].island != i:
        free_motions[i].island = free_motions[free_motions[i].island].island
        i = free_motions[i].island
    return i
