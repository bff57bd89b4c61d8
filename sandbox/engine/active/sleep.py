"""Stage: let resting islands fall asleep.

An island falls asleep as a whole once every body in it has been slow for a while. Sleeping bodies are not moved or
solved; their contacts are kept as they are, so that a pile wakes with the impulses it fell asleep with.
"""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.islands import find_islands
from sandbox.engine.bodies.flags import ISLAND_AWAKE, KEPT_AWAKE, SUPPORTED, disturbs, is_active
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.sleep import flag_supported, keep_awake_at_kinematic
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.state import StateTables
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC, KINEMATIC

STILL_SPEED = 0.001
"""A body that has become faster while it was slow is about to slide or tip, unless it is slower than this, in m/s."""
SLEEP_SECONDS = 0.5
"""How long all bodies of an island have to be slow."""
CORRECTED = 0.5
"""What counts of the pace at which a body is moved: overlaps and torn joints are taken back without a velocity that
lasts. The factor is Box2D's."""


@kernel
def fall_asleep(
    state: StateTables, active: ActiveSet, solver: SolverBodies, contacts: Contacts, joints: JointWork | None
) -> None:
    """Count how long bodies have been slow; put islands to sleep in which all have been slow long enough."""
    bodies = state.bodies
    rows = active.bodies[1 : 1 + active.bodies[0]]
    if joints is not None:
        flag_supported(solver.flags, joints)
        keep_awake_at_kinematic(solver.flags, joints)
    ready = _count_slow_time(bodies, rows, solver, state.settings[0].step_seconds)
    if ready and state.settings[0].sleeping == 1:
        find_islands(bodies, rows, solver.islands, contacts, joints)
        _sleep_islands(bodies, rows, solver.islands, solver.flags, active.info)
    _count_sleepers(bodies, rows, active.info[0], state.counters[0])


@kernel
def _count_sleepers(bodies: Records, rows: Integers, active_info: Records, counter: Records) -> None:
    """Count who is awake, and note who has just fallen asleep or woken.

    The world is still when nobody is awake and no driven body moves.
    """
    asleep = active_info.asleep
    awake = 0
    driven = False
    for i in rows:
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
def _count_slow_time(bodies: Records, rows: Integers, solver: SolverBodies, seconds: float) -> bool:
    """Count how long bodies have been slow; whether one of them long enough to sleep."""
    ready = False
    for i in rows:
        body = bodies[i]
        if not is_active(body):
            continue
        moved = solver.motions[i]
        speed = _speed(body.velocity_x, body.velocity_y, body.angular_velocity * body.extent)
        pace = _speed(moved.delta_x, moved.delta_y, moved.delta_angle * body.extent) * CORRECTED / seconds
        speed = pace if pace > speed else speed
        if speed >= body.sleep_speed or (solver.flags[i] & SUPPORTED == 0 and speed > 0.0):
            body.sleep_time = 0.0
            continue
        if body.sleep_time == 0.0:
            body.slow_speed = speed
        body.sleep_time += seconds
        nudged = body.sleep_time >= SLEEP_SECONDS and speed > STILL_SPEED and speed > body.slow_speed
        if nudged or solver.flags[i] & KEPT_AWAKE != 0:
            body.sleep_time = 0.0
        ready = ready or body.sleep_time >= SLEEP_SECONDS
    return ready


@inlined_kernel
def _speed(x: float, y: float, rim: float) -> float:
    return math.sqrt(x * x + y * y + rim * rim)


@kernel
def _sleep_islands(bodies: Records, rows: Integers, islands: Integers, flags: Integers, active_info: Records) -> None:
    """An island sleeps if none of its bodies is too lively; a lively body flags the root."""
    for i in rows:
        if is_active(bodies[i]) and bodies[i].sleep_time < SLEEP_SECONDS:
            flags[islands[i]] |= ISLAND_AWAKE
    for i in rows:
        body = bodies[i]
        if is_active(body) and flags[islands[i]] & ISLAND_AWAKE == 0:
            active_info[0].shifted = 1
            body.awake = 0
            body.island = islands[i] + 1
            body.velocity_x = 0.0
            body.velocity_y = 0.0
            body.angular_velocity = 0.0
