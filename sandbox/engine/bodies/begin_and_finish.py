"""Stages: what is done to each active body before the substeps, and after them by all workers.

Some bodies at a time, so that loops which follow each other find them in the cache.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._atomics import atomic_add
from sandbox._jit import kernel
from sandbox.engine.active.sleep import count_slow_time, note_awake
from sandbox.engine.bodies.flags import AT_A_TIME, clear_flags, keep_dragged_awake
from sandbox.engine.bodies.integrate import begin_motions, finish_motions
from sandbox.engine.bodies.quarantine import guard_forces, guard_positions
from sandbox.engine.continuous_collision.candidates import mark_fast
from sandbox.engine.midpoint.poses import put_back
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import AWAKE, DRIVEN, FAST, FROZEN, RESTED, Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import FINISH_BODIES
from sandbox.tables import Integers, Records


class Finished(NamedTuple):
    """How many of the active bodies are driven and move, have been slow long enough to sleep, are to be swept."""

    driven: int
    rested: int
    fast: int


@kernel
def begin_bodies(state: StateTables, active: ActiveSet, solver: SolverBodies) -> bool:
    """Make active bodies ready for the substeps; returns whether some were frozen: then the active set is out of date.

    `active.info` notes the square of the highest speed of a point of any.
    """
    rows = active.bodies[1 : 1 + active.bodies[0]]
    setting = state.settings[0]
    froze = False
    fastest = 0.0
    for first in range(0, rows.shape[0], AT_A_TIME):
        some = rows[first : first + AT_A_TIME]
        froze = guard_forces(state.bodies, some, setting, active.info, state.counters) or froze
        square = begin_motions(state.bodies, some, solver)
        fastest = square if square > fastest else fastest
        clear_flags(state.bodies, some, solver)
    keep_dragged_awake(solver.flags, state.drags)
    active.info[0].fastest = fastest
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
    bodies = state.bodies
    motions = solver.motions
    counter = state.counters[0]
    words = workers.words
    seconds = state.settings[0].step_seconds
    unit = state.settings[0].units_per_meter
    for first in range(0, rows.shape[0], AT_A_TIME):
        some = rows[first : first + AT_A_TIME]
        put_back(bodies, some, solver, 0.5 * seconds)
        frozen = guard_positions(bodies, some, motions, active.info, counter.step_count)
        fast = mark_fast(bodies, some, motions, solver.ccd, seconds, unit)
        finish_motions(bodies, some, motions)
        rested = count_slow_time(bodies, some, solver, seconds, unit)
        awake, driven = note_awake(bodies, some)
        for word, count in ((FROZEN, frozen), (AWAKE, awake), (DRIVEN, driven), (RESTED, rested), (FAST, fast)):
            if count > 0:
                atomic_add(words, word, count)
