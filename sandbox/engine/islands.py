"""Stages: wake what is touched, and let resting islands fall asleep.

An island is a set of dynamic bodies joined by contacts. It falls asleep as a whole once every body in it has been
slow for a while, and wakes as a whole. Sleeping bodies are not moved or solved; their contacts are kept as they are,
so that a pile wakes with the impulses it fell asleep with.
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.joints.rest import keep_drawn_awake, keep_driven_awake, mark_held
from sandbox.engine.joints.work import JointWork
from sandbox.engine.marks import KEPT, LIVELY, RESTS, disturbs, is_active
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC, KINEMATIC

STILL_SPEED = 0.001
"""A body that has become faster while it was slow is about to slide or tip, unless it is slower than this, in m/s."""
SLEEP_SECONDS = 0.5
"""How long all bodies of an island have to be slow."""


@kernel
def wake_touched(
    bodies: Records, flights: Records, contacts: Records, count: int, joints: JointWork | None, counters: Records
) -> None:
    """Wake every island that has a contact or a joint with an active or a driven body; `undo_waking` takes it back."""
    if counters[0].asleep_count == 0:
        return
    for i in range(bodies.shape[0]):
        flights[i].was_awake = bodies[i].awake
        flights[i].was_island = bodies[i].island
        flights[i].was_slow = bodies[i].sleep_time
    found = False
    for i in range(count):
        a = bodies[contacts[i].body_a]
        b = bodies[contacts[i].body_b]
        if a.awake == 0 and disturbs(b):
            a.awake = 1
            found = True
        elif b.awake == 0 and disturbs(a):
            b.awake = 1
            found = True
    if joints is not None:
        found = _wake_joined(bodies, joints) or found
    if found:
        wake_marked_islands(bodies)


@kernel
def _wake_joined(bodies: Records, joints: JointWork) -> bool:
    """Wake sleeping bodies that a joint ties to active or driven ones."""
    found = False
    for i in range(joints.ties.shape[0]):
        a = bodies[joints.ties[i].low]
        b = bodies[joints.ties[i].high]
        if a.awake == 0 and disturbs(b):
            a.awake = 1
            found = True
        elif b.awake == 0 and disturbs(a):
            b.awake = 1
            found = True
    return found


@kernel
def undo_waking(bodies: Records, flights: Records, counters: Records) -> None:
    """Put all bodies back to sleep that `wake_touched` has woken, for a step that has to begin again."""
    if counters[0].asleep_count == 0:
        return
    for i in range(bodies.shape[0]):
        bodies[i].awake = flights[i].was_awake
        bodies[i].island = flights[i].was_island
        bodies[i].sleep_time = flights[i].was_slow


@kernel
def wake_marked_islands(bodies: Records) -> None:
    """Wake all bodies of every island in which one body is awake already; that one still carries the island's root.

    `island` is the row of the island's first body plus one, 0 for a body that has not been asleep.
    """
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
def find_islands(bodies: Records, flights: Records, contacts: Records, count: int, joints: JointWork | None) -> None:
    """Union-find over contacts and joints: `flight.island` of an active body becomes the lowest row of its island."""
    for i in range(bodies.shape[0]):
        flights[i].island = i
    for i in range(count):
        contact = contacts[i]
        if not (is_active(bodies[contact.body_a]) and is_active(bodies[contact.body_b])):
            continue
        _unite(flights, contact.body_a, contact.body_b)
    if joints is not None:
        for i in range(joints.ties.shape[0]):
            if is_active(bodies[joints.ties[i].low]) and is_active(bodies[joints.ties[i].high]):
                _unite(flights, joints.ties[i].low, joints.ties[i].high)
    for i in range(bodies.shape[0]):
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
    flights: Records,
    marks: Integers,
    contacts: Records,
    count: int,
    joints: JointWork | None,
    seconds: float,
    sleeping: bool,
    counters: Records,
) -> None:
    """Count how long bodies have been slow; put islands to sleep in which all have been slow long enough."""
    if joints is not None:
        mark_held(marks, joints)
        keep_driven_awake(marks, joints)
        keep_drawn_awake(marks, joints)
    _count_slow_time(bodies, marks, seconds)
    ready = False
    for i in range(bodies.shape[0]):
        if is_active(bodies[i]) and bodies[i].sleep_time >= SLEEP_SECONDS:
            ready = True
    if ready and sleeping:
        find_islands(bodies, flights, contacts, count, joints)
        _sleep_islands(bodies, flights, marks)
    _count_sleepers(bodies, counters[0])


@kernel
def _count_sleepers(bodies: Records, counter: Records) -> None:
    """Count who is awake, and note who has just fallen asleep or woken.

    The world is still when nobody is awake and no driven body moves.
    """
    asleep = 0
    awake = 0
    driven = False
    for i in range(bodies.shape[0]):
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
def _count_slow_time(bodies: Records, marks: Integers, seconds: float) -> None:
    for i in range(bodies.shape[0]):
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
def _sleep_islands(bodies: Records, flights: Records, marks: Integers) -> None:
    """An island sleeps if none of its bodies is too lively; a lively body marks the root."""
    for i in range(bodies.shape[0]):
        if is_active(bodies[i]) and bodies[i].sleep_time < SLEEP_SECONDS:
            marks[flights[i].island] |= LIVELY
    for i in range(bodies.shape[0]):
        body = bodies[i]
        if is_active(body) and marks[flights[i].island] & LIVELY == 0:
            body.awake = 0
            body.island = flights[i].island + 1
            body.velocity_x = 0.0
            body.velocity_y = 0.0
            body.angular_velocity = 0.0
