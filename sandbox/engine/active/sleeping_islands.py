"""Who sleeps together: the members of each sleeping island are a list, so that it wakes without a look at all others.

A list leads from the last member to the first, which is the root of the island: rows descend.
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.records.active_set import ActiveSet
from sandbox.tables import Records

NOBODY = -1


@inlined_kernel
def begin_member(bodies: Records, active: ActiveSet, i: int) -> None:
    """A body has this row since now, after all that were there or behind rows that have kept their bodies."""
    root: int = bodies[i].island - 1
    active.last_member[i] = NOBODY
    if 0 <= root <= i and bodies[i].awake == 0:
        join_island(active, root, i)


@inlined_kernel
def join_island(active: ActiveSet, root: int, i: int) -> None:
    """Put a body into the list of a sleeping island, after all members of lower rows.

    Where rows have gone the list may still have some from this one on: they come first in it, and are left out.
    """
    before: int = active.last_member[root]
    while before >= i:
        before = active.member_before[before]
    active.member_before[i] = before
    active.last_member[root] = i


@kernel
def touch_row(active: ActiveSet, i: int) -> None:
    """A body has to be looked at; all have, if there is no room for it."""
    last = active.touched[0] + 1
    if last < active.touched.shape[0]:
        active.touched[0] = last
        active.touched[last] = i
    else:
        active.info[0].stale = 1


@kernel
def wake_marked_islands(bodies: Records, active: ActiveSet) -> None:
    """Wake all bodies of every island in which a touched body is awake already; that one still carries the island's
    root. Of all bodies, where everybody is to be looked at.

    `island` is the row of the island's first body plus one, 0 for a body that has not been asleep.
    """
    if active.info[0].stale == 1:
        _wake_among_all(bodies)
        return
    some: Any = active.touched[1 : 1 + active.touched[0]]
    for i in some:
        if bodies[i].island > 0 and bodies[i].awake == 1:
            _wake_members(bodies, active, bodies[i].island)


@kernel
def _wake_members(bodies: Records, active: ActiveSet, island: int) -> None:
    i = active.last_member[island - 1]
    while i != NOBODY:
        body = bodies[i]
        if body.island == island:
            if body.awake == 0:
                body.awake = 1
                touch_row(active, i)
            body.sleep_time = 0.0
            body.island = 0
        i = active.member_before[i]


@kernel
def _wake_among_all(bodies: Records) -> None:
    for body in bodies:
        if body.island > 0 and body.awake == 1:
            bodies[body.island - 1].sleep_time = -1.0
    for body in bodies:
        if body.island > 0 and bodies[body.island - 1].sleep_time < 0.0:
            body.awake = 1
    for body in bodies:
        if body.island > 0 and body.awake == 1:
            body.sleep_time = 0.0
            body.island = 0
