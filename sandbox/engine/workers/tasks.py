"""What the parts of a step do when another worker than the first calls them (`serve`): a range of the task under way.

The machine code that a part has for its tasks is then made once, for those who offer them and for those who help.
"""

from __future__ import annotations

from typing import Any

from sandbox._atomics import atomic_add
from sandbox._jit import kernel
from sandbox.engine.bodies.begin_and_finish import finish_some_bodies
from sandbox.engine.bodies.free_flight import fly_some, told_flight
from sandbox.engine.bodies.integrate import integrate_some_velocities, prepare_some_forces
from sandbox.engine.bodies.integrate_positions import Scale, integrate_some_positions
from sandbox.engine.bodies.quarantine import guard_some_velocities
from sandbox.engine.broad_phase.proxies import bound_some_shapes
from sandbox.engine.contact_solver.impact_criteria import ImpactCriteria
from sandbox.engine.contact_solver.prepare import prepare_blocks
from sandbox.engine.contact_solver.soft_constraint import contact_spring
from sandbox.engine.contact_solver.solve import solve_blocks, solve_blocks_again
from sandbox.engine.contact_solver.store import store_blocks
from sandbox.engine.contact_solver.velocity_parts import add_some_parts, turn_some_parts
from sandbox.engine.contact_solver.warm_start import warm_start_blocks
from sandbox.engine.joints.records import JointWork
from sandbox.engine.narrow_phase.decide_pairs import decide_pairs
from sandbox.engine.narrow_phase.write_contacts import write_contacts
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.colliders import Colliders, Grid
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.decisions import Decisions
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import FROZEN, Workers
from sandbox.engine.solve_islands import solve_batches, told_share
from sandbox.engine.workers.parallel_for import FIRST_PAIR, TASK, told_range
from sandbox.engine.workers.task_kinds import (
    ADD_PARTS,
    ANEW,
    BOUND_SHAPES,
    DECIDE_PAIRS,
    FLY,
    GRAVITY,
    GUARD_VELOCITIES,
    IMPACT_SPEED,
    IMPACTS,
    INTEGRATE_POSITIONS,
    INTEGRATE_VELOCITIES,
    LEVEL,
    PREPARE_CONTACTS,
    PREPARE_FORCES,
    SECONDS,
    SOLVE_AGAIN,
    SOLVE_CONTACTS,
    SOLVE_ISLANDS,
    STORE_IMPULSES,
    STRUCK_BLOCKS,
    TURN_PARTS,
    UNITS,
    WARM_START,
    told_soft,
)


@kernel
def help_collide(
    state: StateTables,
    active: ActiveSet,
    colliders: Colliders,
    grid: Grid,
    contacts: Contacts,
    workers: Workers,
    decisions: Decisions,
) -> None:
    """Bound active shapes, or do a task for pairs of the batch under way."""
    first, end = told_range(workers)
    task = workers.words[TASK]
    pairs: Any = grid.pairs[workers.words[FIRST_PAIR] :]
    if task == BOUND_SHAPES:
        bound_some_shapes(state, active.shapes[first:end], workers.numbers[ANEW] > 0.0, colliders, grid)
    elif task == DECIDE_PAIRS:
        decide_pairs(state, colliders, pairs, contacts.before, decisions, workers.number, first, end)
    else:
        write_contacts(colliders.proxies, pairs, contacts, decisions, first, end)


@kernel
def help_solve(
    state: StateTables,
    active: ActiveSet,
    solver: SolverBodies,
    contacts: Contacts,
    blocks: ContactBlocks,
    joints: JointWork,
    workers: Workers,
) -> None:
    """Do a task for batches of islands, or for what batch 0 has."""
    first, end = told_range(workers)
    task = workers.words[TASK]
    if task == SOLVE_ISLANDS:
        solve_batches(state, active, solver, contacts, blocks, joints, workers, told_share(workers), first, end)
    else:
        _do_bodies(state, active, solver, contacts, blocks, workers, first, end)


@kernel
def help_finish(state: StateTables, active: ActiveSet, solver: SolverBodies, workers: Workers) -> None:
    """Finish active bodies."""
    first, end = told_range(workers)
    finish_some_bodies(state, active.bodies[1 + first : 1 + end], solver, active, workers)


@kernel
def _do_bodies(
    state: StateTables,
    active: ActiveSet,
    solver: SolverBodies,
    contacts: Contacts,
    blocks: ContactBlocks,
    workers: Workers,
    first: int,
    end: int,
) -> None:
    """Do a task of `solve` for blocks of contacts or bodies of batch 0, which come first."""
    task = workers.words[TASK]
    n = workers.numbers
    motions = solver.motions
    now = state.counters[0].step_count
    frozen = 0
    if task == SOLVE_CONTACTS:
        solve_blocks(motions, blocks, first, end, told_soft(n))
    elif task == SOLVE_AGAIN:
        solve_blocks_again(motions, blocks, first, end, told_soft(n))
    elif task == WARM_START:
        warm_start_blocks(motions, blocks, first, end)
    elif task == INTEGRATE_VELOCITIES:
        rows = blocks.batches.bodies[first:end]
        frozen = integrate_some_velocities(state.bodies, rows, solver, active.info, now)
    elif task == INTEGRATE_POSITIONS:
        rows = blocks.batches.bodies[first:end]
        integrate_some_positions(rows, solver, Scale(n[GRAVITY], n[UNITS]), n[SECONDS], n[IMPACTS] > 0.0)
    elif task == ADD_PARTS:
        add_some_parts(blocks.batches.bodies[first:end], solver)
    elif task == TURN_PARTS:
        turn_some_parts(blocks.batches.bodies[first:end], solver)
    elif task == PREPARE_FORCES:
        rows = blocks.batches.bodies[first:end]
        prepare_some_forces(state.bodies, rows, solver, state.settings[0], n[SECONDS])
    elif task == FLY:
        rows = blocks.batches.bodies[first:end]
        frozen = fly_some(state.bodies, rows, solver, state.settings[0], active.info, now, told_flight(n))
    elif task == GUARD_VELOCITIES:
        rows = blocks.batches.bodies[first:end]
        frozen = guard_some_velocities(state.bodies, rows, solver, active.info, now)
    elif task == PREPARE_CONTACTS:
        spring = contact_spring(state.settings[0], int(n[LEVEL]))
        criteria = ImpactCriteria(n[IMPACTS] > 0.0, int(n[STRUCK_BLOCKS]), n[IMPACT_SPEED])
        prepare_blocks(state, solver, contacts.now, blocks, first, end, spring, criteria)
    elif task == STORE_IMPULSES:
        spring = contact_spring(state.settings[0], int(n[LEVEL]))
        store_blocks(state, solver, contacts, blocks, first, end, spring)
    if frozen > 0:
        atomic_add(workers.words, FROZEN, frozen)
