"""Stage: the substeps. Velocities from forces, impacts, joints and contacts; then positions; then the relax pass."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from sandbox._jit import kernel
from sandbox.engine.bodies.free_flight import Flight, fly
from sandbox.engine.bodies.integrate import integrate_velocities
from sandbox.engine.bodies.integrate_positions import Scale, integrate_positions
from sandbox.engine.bodies.quarantine import guard_velocities
from sandbox.engine.contact_solver.mouse_joint import solve_mouse_joints
from sandbox.engine.contact_solver.passes import Passes, passes_of, relax_contacts
from sandbox.engine.contact_solver.put_down import put_down
from sandbox.engine.contact_solver.soft_constraint import Spring, contact_spring
from sandbox.engine.contact_solver.solve import solve_contacts
from sandbox.engine.contact_solver.velocity_parts import add_parts, begin_parts, turn_parts
from sandbox.engine.contact_solver.warm_start import forget_impulses, warm_start
from sandbox.engine.joints.direct.position_correction import apply_corrections
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.stages import RELAX, RELAX_LAST, SELECT, SOLVE, call_joints, has_joints
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contact_blocks import BlockRanges, ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import Workers
from sandbox.engine.restitution.inelastic import stop_late, stop_struck
from sandbox.engine.restitution.strike_batch import call_strikes
from sandbox.engine.workers.task_kinds import SLOTS
from sandbox.tables import Integers, Records


class Pass(NamedTuple):
    """What is solved: the islands of a substep level, whose contacts are in `blocks`. The first `touched_count` of
    their bodies have contacts, the first `held_count` contacts, joints or a hand, the others fly freely.

    Blocks of unsettled bodies take a rigid pass first, once, if `new` says that some body of the level is to another,
    those of bodies that overlap deeply take more relax passes than all others. Batch 0 has the joints and what is
    dragged. `impacts` says that some contact of the level may have one.
    """

    level: int
    batch: int
    touched_count: int
    held_count: int
    blocks: BlockRanges
    new: bool
    impacts: bool


class Course(NamedTuple):
    """How the substeps of a level go: how many there are, and of how many seconds; `step`, how many steps came before
    this one; `gravity` (m/s^2); whether contacts keep impulses from pass to pass, and begin with those of before
    (`warm`); their springs and passes."""

    substeps: int
    seconds: float
    step: int
    gravity: float
    keeps: bool
    warm: bool
    spring: Spring
    passes: Passes


@kernel
def _course_of(state: StateTables, todo: Pass) -> Course:
    """The settings may switch off any technique of the contact solver."""
    setting = state.settings[0]
    substeps = setting.substeps << todo.level
    keeps = setting.accumulate == 1
    warm = keeps and setting.warm_starting == 1 and todo.blocks.total > 0
    gravity = math.sqrt(setting.gravity_x * setting.gravity_x + setting.gravity_y * setting.gravity_y)
    spring = contact_spring(setting, todo.level)
    step = state.counters[0].step_count
    seconds = setting.step_seconds / substeps
    return Course(substeps, seconds, step, gravity, keeps, warm, spring, passes_of(setting, spring, seconds))


@kernel
def run_substeps(
    state: StateTables,
    active: ActiveSet,
    solver: SolverBodies,
    contacts: Contacts,
    blocks: ContactBlocks,
    joints: JointWork,
    workers: Workers,
    rows: Integers,
    todo: Pass,
) -> int:
    """Integrate, solve and relax the islands of a batch, whose bodies `rows` are, in as many substeps as their level
    asks for. Returns how many bodies this worker has frozen.

    What comes to touch within the step, and is stopped at once, may be so as many times as in the scene's own substeps,
    sooner or later: passes over all that is struck cost what many finer substeps do, which stop what comes in between
    nearly as well. So a heap into which something falls all the time costs no more for that than a coarser one.
    """
    bodies = state.bodies
    setting = state.settings[0]
    motions = solver.motions
    rest = todo.batch == 0
    jointed = rest and has_joints(joints)
    count = todo.blocks.total
    struck_count = todo.blocks.struck
    batches = blocks.batches
    listed = batches.first_impact[todo.batch + 1] - batches.first_impact[todo.batch]
    struck: Any = batches.struck[batches.first_body[todo.batch] :]
    unit = setting.units_per_meter
    course = _course_of(state, todo)
    substeps = course.substeps
    seconds = course.seconds
    warm = course.warm
    rigid = course.passes.rigid

    if jointed:
        workers.numbers[SLOTS] = blocks.blocks[count - 1].first + blocks.blocks[count - 1].count if count > 0 else 0
        call_joints(contacts, workers, SELECT, seconds)
    scale = Scale(course.gravity, unit)
    flight = Flight(substeps, seconds, scale, todo.impacts)
    frozen = fly(bodies, rows, todo.held_count, solver, setting, active.info, course.step, flight, workers)
    touched = rows[: todo.touched_count]
    rows = rows[: todo.held_count]
    late = 0  # impacts without restitution, no more than the scene's own substeps would have
    for substep in range(substeps):
        frozen += integrate_velocities(bodies, rows, solver, active.info, course.step, workers)
        if listed > 0:
            call_strikes(contacts, workers, todo.batch, seconds)
        stops = struck_count > 0 and substep == 0
        if stops:
            stop_struck(bodies, solver, struck, blocks, struck_count, workers, rigid, unit)
        drags = rest and solve_mouse_joints(state, solver, todo.level, seconds)
        if listed > 0 or stops or drags:
            frozen += guard_velocities(bodies, rows, solver, active.info, course.step, workers)
        _begin_impulses(touched, solver, blocks, count, workers, warm, substep)
        if jointed:
            _solve_joints(touched, solver, contacts, workers, warm, seconds)
        if todo.new and substep == 0:
            _solve_new(bodies, solver, struck, contacts, blocks, todo.blocks.unsettled, workers, course)
        soft = course.passes.summing if warm and substep > 0 else course.passes.soft
        solve_contacts(motions, blocks, 0, count, workers, soft)
        if jointed:
            apply_corrections(joints.direct, motions, seconds)
        integrate_positions(rows, solver, scale, seconds, todo.impacts, workers)
        apart = warm and (todo.impacts or jointed)
        if apart:
            turn_parts(touched, solver, workers)
        if listed > 0:
            call_strikes(contacts, workers, todo.batch, -seconds)
        if struck_count > 0 and late <= substep >> todo.level:  # the relax pass would stop them a contact at a time
            late += 1 if stop_late(bodies, solver, struck, blocks, struck_count, workers, rigid, unit) else 0
        if jointed:
            call_joints(contacts, workers, RELAX if substep + 1 < substeps else RELAX_LAST, seconds)
        if apart:
            turn_parts(touched, solver, workers)
        if setting.relax == 1:
            relax_contacts(motions, blocks, todo.blocks, workers, course.passes, course.keeps)
        if warm and substep + 1 < substeps:
            turn_parts(touched, solver, workers)
    return frozen


@kernel
def _begin_impulses(
    touched: Integers,
    solver: SolverBodies,
    blocks: ContactBlocks,
    count: int,
    workers: Workers,
    warm: bool,
    substep: int,
) -> None:
    """Warm starting: contact by contact in the first substep, then body by body; else contacts begin anew."""
    if not warm:
        forget_impulses(blocks, 0, count)
    elif substep == 0:
        begin_parts(touched, solver)
        warm_start(solver.motions, blocks, count, workers)
    else:
        add_parts(touched, solver, workers)


@kernel
def _solve_joints(
    touched: Integers, solver: SolverBodies, contacts: Contacts, workers: Workers, warm: bool, seconds: float
) -> None:
    """Solve joints, whose impulses are no part of what contacts have given."""
    if warm:
        turn_parts(touched, solver, workers)
    call_joints(contacts, workers, SOLVE, seconds)
    if warm:
        turn_parts(touched, solver, workers)


@kernel
def _solve_new(
    bodies: Records,
    solver: SolverBodies,
    struck: Records,
    contacts: Contacts,
    blocks: ContactBlocks,
    unsettled: int,
    workers: Workers,
    course: Course,
) -> None:
    """What was just put there has no impulses yet, and soft contacts alone would let it slip until it has."""
    rigid = course.passes.rigid
    if course.step == 0 and course.spring.yields > 0.0:
        put_down(bodies, solver, struck, contacts.now, blocks, unsettled, workers, rigid, course.spring, course.gravity)
    else:
        solve_contacts(solver.motions, blocks, 0, unsettled, workers, rigid)
    if not course.keeps:
        forget_impulses(blocks, 0, unsettled)
