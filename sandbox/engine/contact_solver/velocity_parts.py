"""Stage: warm starting by bodies. What contacts gave a body in a substep, they give it as the next one begins.

A velocity has two parts: what contacts have given in the substep, and all else. Axes, anchors and levers of contacts
stay as they are during a step, so that their accumulated impulses would give the first part again, contact by contact:
to add it, body by body, is the same, and a body has a third of the contacts and a sixth of the memory of each.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox._vectors import lane_numbers, load_fields, select, store_fields
from sandbox.engine.records.bodies import VELOCITY, SolverBodies
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import ADD_PARTS, TURN_PARTS
from sandbox.tables import Integers


@kernel
def begin_parts(rows: Integers, solver: SolverBodies) -> None:
    """Contacts have given nothing yet: `solver.parts` gets all else."""
    for i in rows:
        store_fields(solver.parts, i, 0, load_fields(solver.motions, i, VELOCITY))


@kernel
def turn_parts(rows: Integers, solver: SolverBodies, workers: Workers) -> None:
    """Let `solver.parts` have the other of the two parts: either is the velocity without the other."""
    first, end = first_part(workers, TURN_PARTS, 0, rows.shape[0])
    while first < end:
        turn_some_parts(rows[first:end], solver)
        first, end = next_part(workers, first, end)


@kernel
def turn_some_parts(rows: Integers, solver: SolverBodies) -> None:
    """The same for some bodies."""
    for i in rows:
        other = load_fields(solver.motions, i, VELOCITY) - load_fields(solver.parts, i, 0)
        store_fields(solver.parts, i, 0, other)


@kernel
def add_parts(rows: Integers, solver: SolverBodies, workers: Workers) -> None:
    """Warm start: add what contacts gave in the substep before, which `solver.parts` has; then that has all else."""
    first, end = first_part(workers, ADD_PARTS, 0, rows.shape[0])
    while first < end:
        add_some_parts(rows[first:end], solver)
        first, end = next_part(workers, first, end)


@kernel
def add_some_parts(rows: Integers, solver: SolverBodies) -> None:
    """The same for some bodies."""
    is_velocity = lane_numbers() < 3.0  # behind it is a place
    for i in rows:
        velocity = load_fields(solver.motions, i, VELOCITY)
        sum_of_both = select(is_velocity, velocity + load_fields(solver.parts, i, 0), velocity)
        store_fields(solver.motions, i, VELOCITY, sum_of_both)
        store_fields(solver.parts, i, 0, velocity)
