"""Stage: let resting islands fall asleep.

An island falls asleep as a whole once every body in it has been slow for a while. Sleeping bodies are not moved or
solved; their contacts are kept as they are, so that a pile wakes with the impulses it fell asleep with.
"""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.islands import find_islands
from sandbox.engine.active.sleeping_islands import begin_member
from sandbox.engine.bodies.flags import ISLAND_AWAKE, KEPT_AWAKE, SUPPORTED, is_active
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.state import StateTables
from sandbox.tables import Records

STILL_SPEED = 0.001
"""A body that has become faster while it was slow is about to slide or tip, unless it is slower than this, in m/s."""
FASTER = 1.001
"""Times as fast as it was such a body has to be: what rolls steadily is not faster by rounding."""
SLEEP_SECONDS = 0.5
"""How long all bodies of an island have to be slow."""
CORRECTED = 0.5
"""What counts of the pace at which a body is moved: overlaps and torn joints are taken back without a velocity that
lasts. The factor is Box2D's."""


@inlined_kernel
def count_slow_time(body: Records, moved: Records, flags: int, seconds: float, unit: float) -> bool:
    """Count how long an awake body has been slow; returns whether long enough to sleep. A metre is so many units of
    length."""
    slow: float = body.sleep_speed * unit
    speed = _speed(body.velocity_x, body.velocity_y, body.angular_velocity * body.extent)
    if speed >= slow:  # most that move: how fast they were moved need not be known
        body.sleep_time = 0.0
        return False
    pace = _speed(moved.delta_x, moved.delta_y, moved.delta_angle * body.extent) * CORRECTED / seconds
    speed = pace if pace > speed else speed
    if speed >= slow or (flags & SUPPORTED == 0 and speed > 0.0):
        body.sleep_time = 0.0
        return False
    if body.sleep_time == 0.0:
        body.slow_speed = speed
    time: float = body.sleep_time + seconds
    nudged = time >= SLEEP_SECONDS and speed > STILL_SPEED * unit and speed > FASTER * body.slow_speed
    time = 0.0 if nudged or flags & KEPT_AWAKE != 0 else time
    body.sleep_time = time
    return time >= SLEEP_SECONDS


@inlined_kernel
def note_awake(body: Records) -> None:
    """Note whether a body that is awake has just woken."""
    body.stirred = body.was_asleep
    body.was_asleep = 0


@kernel
def fall_asleep(
    state: StateTables, active: ActiveSet, solver: SolverBodies, contacts: Contacts, joints: JointWork
) -> None:
    """Put islands to sleep in which all bodies have been slow long enough."""
    rows = active.bodies[1 : 1 + active.bodies[0]]
    find_islands(state.bodies, rows, solver.islands, contacts, joints)
    fallen = _sleep_islands(state.bodies, active, solver)
    active.info[0].shifted |= 1 if fallen > 0 else 0
    state.counters[0].asleep_count += fallen
    state.counters[0].awake_count -= fallen


@inlined_kernel
def _speed(x: float, y: float, rim: float) -> float:
    return math.sqrt(x * x + y * y + rim * rim)


@kernel
def _sleep_islands(bodies: Records, active: ActiveSet, solver: SolverBodies) -> int:
    """An island sleeps if none of its bodies is too lively; a lively body flags the root. Returns how many bodies
    do."""
    rows = active.bodies[1 : 1 + active.bodies[0]]
    islands = solver.islands
    flags = solver.flags
    fallen = 0
    for i in rows:
        if is_active(bodies[i]) and bodies[i].sleep_time < SLEEP_SECONDS:
            flags[islands[i]] |= ISLAND_AWAKE
    for i in rows:
        body = bodies[i]
        if is_active(body) and flags[islands[i]] & ISLAND_AWAKE == 0:
            fallen += 1
            body.awake = 0
            body.stirred -= 1
            body.was_asleep = 1
            body.island = islands[i] + 1
            begin_member(bodies, active, i)
            body.velocity_x = 0.0
            body.velocity_y = 0.0
            body.angular_velocity = 0.0
            solver.ccd[i].fast = 0
    return fallen
