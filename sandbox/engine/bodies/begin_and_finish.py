"""Stages: what is done to each active body before the substeps, and after them by all workers."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._atomics import atomic_add
from sandbox._jit import kernel
from sandbox.engine.active.sleep import count_slow_time, note_awake
from sandbox.engine.bodies.flags import AHEAD, TURNING, disturbs, first_flags, is_active, keep_dragged_awake
from sandbox.engine.bodies.integrate import begin_motion, finish_motion
from sandbox.engine.bodies.quarantine import guard_forces, guard_position
from sandbox.engine.continuous_collision.candidates import mark_fast
from sandbox.engine.midpoint.midpoint import turning_flags
from sandbox.engine.midpoint.poses import put_back
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import AWAKE, DRIVEN, FAST, FROZEN, RESTED, Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import FINISH_BODIES
from sandbox.tables import Integers, Records
from sandbox.world.records import KINEMATIC


class Finished(NamedTuple):
    """How many of the active bodies are driven and move, have been slow long enough to sleep, are to be swept."""

    driven: int
    rested: int
    fast: int


@kernel
def begin_bodies(state: StateTables, active: ActiveSet, solver: SolverBodies) -> bool:
    """Make active bodies ready for the substeps; returns whether some were frozen: then the active set is out of date.

    `active.info` notes the square of the highest speed of a point of any, and whether some turn notably.
    """
    setting = state.settings[0]
    counter = state.counters[0]
    froze = False
    found = 0
    fastest = 0.0
    for i in active.bodies[1 : 1 + active.bodies[0]]:
        body = state.bodies[i]
        free_motion = solver.free_motions[i]
        if guard_forces(body, setting, active.info, counter.step_count):
            counter.frozen_count += 1
            froze = True
        square = begin_motion(body, solver.motions[i], free_motion)
        fastest = square if square > fastest else fastest
        flags = first_flags(body, free_motion) | turning_flags(body, solver.ccd[i], 0.5 * setting.step_seconds)
        solver.flags[i] = flags
        found |= flags
    keep_dragged_awake(solver.flags, state.drags)
    active.info[0].fastest = fastest
    active.info[0].turning = 1 if found & TURNING else 0
    return froze


@kernel
def forget_posed(bodies: Records, active: ActiveSet) -> None:
    """Whoever was put somewhere since the last step has woken by now what it touches."""
    for i in active.bodies[1 : 1 + active.bodies[0]]:
        bodies[i].posed = 0


@kernel
def finish_bodies(state: StateTables, active: ActiveSet, solver: SolverBodies, workers: Workers) -> Finished:
    """Freeze active bodies that would leave the world, and write the motions of all others to them.

    Counts who is awake; nobody has fallen asleep yet.
    """
    words = workers.words
    for word in (FROZEN, AWAKE, DRIVEN, RESTED, FAST):
        words[word] = 0
    first, end = first_part(workers, FINISH_BODIES, 0, active.bodies[0])
    while first < end:
        finish_some_bodies(state, active.bodies[1 + first : 1 + end], solver, active, workers)
        first, end = next_part(workers, first, end)
    counter = state.counters[0]
    counter.frozen_count += words[FROZEN]
    counter.awake_count = words[AWAKE]
    counter.asleep_count = active.info[0].asleep
    return Finished(words[DRIVEN], words[RESTED], words[FAST])


@kernel
def finish_some_bodies(
    state: StateTables, rows: Integers, solver: SolverBodies, active: ActiveSet, workers: Workers
) -> None:
    """The same for some of them."""
    words = workers.words
    step = state.counters[0].step_count
    seconds = state.settings[0].step_seconds
    unit = state.settings[0].units_per_meter
    frozen = awake = driven = rested = fast = 0
    for i in rows:
        body = state.bodies[i]
        motion = solver.motions[i]
        if solver.flags[i] & AHEAD:
            put_back(body, motion, 0.5 * seconds)
        frozen += 1 if guard_position(body, motion, active.info, step) else 0
        fast += 1 if mark_fast(body, motion, solver.ccd[i], seconds, unit) else 0
        finish_motion(body, motion)
        if is_active(body):
            rested += 1 if count_slow_time(body, motion, solver.flags[i], seconds, unit) else 0
            awake += 1
            note_awake(body)
        elif body.type == KINEMATIC and disturbs(body):
            driven += 1
    for word, count in ((FROZEN, frozen), (AWAKE, awake), (DRIVEN, driven), (RESTED, rested), (FAST, fast)):
        if count > 0:
            atomic_add(words, word, count)
