"""Stages: wake what is touched, and let resting islands fall asleep.

An island is a set of dynamic bodies joined by contacts. It falls asleep as a whole once every body in it has been
slow for a while, and wakes as a whole. Sleeping bodies are not moved or solved; their contacts are kept as they are,
so that a pile wakes with the impulses it fell asleep with.
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.active.body_flags import KEPT, LIVELY, RESTS, disturbs, is_active
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.sleep import keep_drawn_awake, keep_driven_awake, mark_held
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC, KINEMATIC

STILL_SPEED = 0.001
"""A body that has become faster while it was slow is about to slide or tip, unless it is slower than this, in m/s."""
SLEEP_SECONDS = 0.5
"""How long all bodies of an island have to be slow."""


@kernel
def wake_touched(
    bodies: Records,
    flights: Records,
    contacts: Records,
    live: Integers,
    joints: JointWork | None,
    census: Records,
    counters: Records,
) -> bool:
    """Wake every island that has a contact or a joint with an active or a driven body; `undo_waking` takes it back.

    Returns whether there was one: then the lists of `census` are out of date.
    """
    census[0].woke = 0
    if counters[0].asleep_count == 0 or not (_some_touched(bodies, contacts, live) or _some_joined(bodies, joints)):
        return False
    census[0].woke = 1
    for i in range(bodies.shape[0]):
        flights[i].was_awake = bodies[i].awake
        flights[i].was_island = bodies[i].island
        flights[i].was_slow = bodies[i].sleep_time
    for i in live:
        _wake_either(bodies[contacts[i].body_a], bodies[contacts[i].body_b])
    if joints is not None:
        for i in range(joints.ties.shape[0]):
            _wake_either(bodies[joints.ties[i].low], bodies[joints.ties[i].high])
    wake_marked_islands(bodies, census)
    return True


@kernel
def _some_touched(bodies: Records, contacts: Records, live: Integers) -> bool:
    """Whether a sleeping body has a contact with an active or a driven one."""
    found = False
    for i in live:
        found = found or _disturbed(bodies[contacts[i].body_a], bodies[contacts[i].body_b])
    return found


@kernel
def _some_joined(bodies: Records, joints: JointWork | None) -> bool:
    """Whether a joint ties a sleeping body to an active or a driven one."""
    found = False
    if joints is not None:
        for i in range(joints.ties.shape[0]):
            found = found or _disturbed(bodies[joints.ties[i].low], bodies[joints.ties[i].high])
    return found


@kernel
def _disturbed(a: Records, b: Records) -> bool:
    return bool((a.awake == 0 and disturbs(b)) or (b.awake == 0 and disturbs(a)))


@kernel
def _wake_either(a: Records, b: Records) -> None:
    if a.awake == 0 and disturbs(b):
        a.awake = 1
    elif b.awake == 0 and disturbs(a):
        b.awake = 1


@kernel
def undo_waking(bodies: Records, flights: Records, census: Records) -> None:
    """Put all bodies back to sleep that `wake_touched` has woken, for a step that has to begin again."""
    if census[0].woke == 0:
        return
    for i in range(bodies.shape[0]):
        bodies[i].awake = flights[i].was_awake
        bodies[i].island = flights[i].was_island
        bodies[i].sleep_time = flights[i].was_slow


@kernel
def wake_marked_islands(bodies: Records, census: Records) -> None:
    """Wake all bodies of every island in which one body is awake already; that one still carries the island's root.

    `island` is the row of the island's first body plus one, 0 for a body that has not been asleep.
    """
    census[0].stale = 1
    for i in range(bodies.shape[0]):
        body = bodies[i]
        if body.island > 0 and body.awake == 1:
            bodies[body.island - 1].sleep_time = -1.0
    for i in range(bodies.shape[0]):
        body = bodies[i]
        if body.island > 0 and bodies[body.island - 1].sleep_time < 0.0:
            body.awake = 1
    for i in range(bodies.shape[0]):
        body = bodies[i]
        if body.island > 0 and body.awake == 1:
            body.sleep_time = 0.0
            body.island = 0


@kernel
def find_islands(
    bodies: Records, movers: Integers, flights: Records, contacts: Records, live: Integers, joints: JointWork | None
) -> None:
    """Union-find over contacts and joints: `flight.island` of an active body becomes the lowest row of its island."""
    for i in movers:
        flights[i].island = i
    for i in live:
        contact = contacts[i]
        if is_active(bodies[contact.body_a]) and is_active(bodies[contact.body_b]):
            _unite(flights, contact.body_a, contact.body_b)
    if joints is not None:
        for i in range(joints.ties.shape[0]):
            if is_active(bodies[joints.ties[i].low]) and is_active(bodies[joints.ties[i].high]):
                _unite(flights, joints.ties[i].low, joints.ties[i].high)
    for i in movers:
        flights[i].island = _root(flights, i)


@kernel
def _unite(flights: Records, i: int, j: int) -> None:
    """Put two bodies into one island."""
    a = _root(flights, i)
    b = _root(flights, j)
    if a < b:
        flights[b].island = a
    elif b < a:
        flights[a].island = b


@kernel
def _root(flights: Records, i: int) -> int:
    """Root of body i; halves the path on its way."""
    while flights[i].island != i:
        flights[i].island = flights[flights[i].island].island
        i = flights[i].island
    return i


@kernel
def fall_asleep(
    bodies: Records,
    movers: Integers,
    flights: Records,
    marks: Integers,
    contacts: Records,
    live: Integers,
    joints: JointWork | None,
    seconds: float,
    sleeping: bool,
    census: Records,
    counters: Records,
) -> None:
    """Count how long bodies have been slow; put islands to sleep in which all have been slow long enough."""
    if joints is not None:
        mark_held(marks, joints)
        keep_driven_awake(marks, joints)
        keep_drawn_awake(marks, joints)
    _count_slow_time(bodies, movers, marks, seconds)
    ready = False
    for i in movers:
        if is_active(bodies[i]) and bodies[i].sleep_time >= SLEEP_SECONDS:
            ready = True
    if ready and sleeping:
        find_islands(bodies, movers, flights, contacts, live, joints)
        _sleep_islands(bodies, movers, flights, marks, census)
    _count_sleepers(bodies, movers, census[0], counters[0])


@kernel
def _count_sleepers(bodies: Records, movers: Integers, census: Records, counter: Records) -> None:
    """Count who is awake, and note who has just fallen asleep or woken.

    The world is still when nobody is awake and no driven body moves.
    """
    asleep = census.asleep
    awake = 0
    driven = False
    for i in movers:
        body = bodies[i]
        if body.type == DYNAMIC:
            asleep += 1 - body.awake
            awake += body.awake
            body.stirred = body.awake - 1 + body.was_asleep
            body.was_asleep = 1 - body.awake
        elif body.type == KINEMATIC and disturbs(body):
            driven = True
    counter.asleep_count = asleep
    counter.awake_count = awake
    counter.still = 0 if driven or awake > 0 else 1


@kernel
def _count_slow_time(bodies: Records, movers: Integers, marks: Integers, seconds: float) -> None:
    for i in movers:
        body = bodies[i]
        if not is_active(body):
            continue
        rim = body.angular_velocity * body.extent
        speed = math.sqrt(body.velocity_x * body.velocity_x + body.velocity_y * body.velocity_y + rim * rim)
        if speed >= body.sleep_speed or (marks[i] & RESTS == 0 and speed > 0.0):
            body.sleep_time = 0.0
            continue
        if body.sleep_time == 0.0:
            body.slow_speed = speed
        body.sleep_time += seconds
        nudged = body.sleep_time >= SLEEP_SECONDS and speed > STILL_SPEED and speed > body.slow_speed
        if nudged or marks[i] & KEPT != 0:
            body.sleep_time = 0.0


@kernel
def _sleep_islands(bodies: Records, movers: Integers, flights: Records, marks: Integers, census: Records) -> None:
    """An island sleeps if none of its bodies is too lively; a lively body marks the root."""
    for i in movers:
        if is_active(bodies[i]) and bodies[i].sleep_time < SLEEP_SECONDS:
            marks[flights[i].island] |= LIVELY
    for i in movers:
        body = bodies[i]
        if is_active(body) and marks[flights[i].island] & LIVELY == 0:
            census[0].stale = 1
            body.awake = 0
            body.island = flights[i].island + 1
            body.velocity_x = 0.0
            body.velocity_y = 0.0
            body.angular_velocity = 0.0
