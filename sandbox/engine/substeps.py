"""Stage: the substeps. Velocities from forces, impacts, joints and contacts; then positions; then the relax pass."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from sandbox._jit import kernel
from sandbox.engine.bodies.free_flight import Flight, fly
from sandbox.engine.bodies.integrate import integrate_velocities, prepare_forces
from sandbox.engine.bodies.integrate_positions import Scale, integrate_positions
from sandbox.engine.bodies.quarantine import guard_velocities
from sandbox.engine.contact_solver.mouse_joint import solve_mouse_joints
from sandbox.engine.contact_solver.put_down import put_down
from sandbox.engine.contact_solver.soft_constraint import contact_spring
from sandbox.engine.contact_solver.solve import solve_again, solve_contacts
from sandbox.engine.contact_solver.velocity_parts import add_parts, begin_parts, turn_parts
from sandbox.engine.contact_solver.warm_start import forget_impulses, warm_start
from sandbox.engine.joints.direct.position_correction import apply_corrections
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.stages import RELAX, RELAX_LAST, SELECT, SOLVE, call_joints, has_joints
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contact_blocks import BlockRanges, ContactBlocks, SoftContact
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import Workers
from sandbox.engine.restitution.inelastic import stop_late, stop_struck
from sandbox.engine.restitution.strike_batch import call_strikes
from sandbox.engine.workers.task_kinds import SLOTS
from sandbox.tables import Integers, Records

WAIT = 1e30
"""Speed (m/s) that a relax pass grants contacts which may bounce: the next substep decides on their impact."""

AT_ONCE = 1e30
"""Rate (1/s) at which points apart may close their gap where contacts are not speculative: they are left alone."""

OVER_RELAXATION = 0.2
"""Of the relax pass, which finds the loads that the next substep begins with: the top of a pyramid of 110 rows that is
put down at rest jumps by 6 cm, without it by 14. In the soft pass as well it would be 2 cm, but then some heaps never
come to rest, as springs are too lively."""

RELAX_DEEP = 8
"""Relax passes where bodies overlap deeply: 40 boxes thrown into one place part at 3 m/s instead of 12."""


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


@kernel
def relax_contacts(
    motions: Records,
    blocks: ContactBlocks,
    ranges: BlockRanges,
    workers: Workers,
    relax: SoftContact,
    relax_deep: SoftContact,
    accumulate: bool,
) -> None:
    """Take back the velocity that pushes overlaps apart: `RELAX_DEEP` passes over what overlaps deeply, of which the
    last goes over all blocks."""
    first = ranges.deep_first
    end = ranges.deep_end
    for turn in range(RELAX_DEEP - 1 if first < end else 0):
        if not accumulate:
            forget_impulses(blocks, first, end)
        if turn == 0:
            solve_contacts(motions, blocks, first, end, workers, relax_deep)
        else:
            solve_again(motions, blocks, first, end, workers, relax_deep)
    if not accumulate:
        forget_impulses(blocks, 0, ranges.total)
    solve_contacts(motions, blocks, 0, ranges.total, workers, relax)


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

    The settings may switch off any technique of the contact solver.
    """
    bodies = state.bodies
    setting = state.settings[0]
    motions = solver.motions
    level = todo.level
    rest = todo.batch == 0
    jointed = rest and has_joints(joints)
    count = todo.blocks.total
    unsettled = todo.blocks.unsettled
    struck_count = todo.blocks.struck
    batches = blocks.batches
    listed = batches.first_impact[todo.batch + 1] - batches.first_impact[todo.batch]
    unit = setting.units_per_meter
    substeps = setting.substeps << level
    seconds = setting.step_seconds / substeps
    closing = 1.0 / seconds if setting.speculative == 1 else AT_ONCE
    spring = contact_spring(setting, level)
    rigid = SoftContact(closing, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, False, True)
    relax = SoftContact(closing, 0.0, 0.0, 0.0, 0.0, WAIT, OVER_RELAXATION, False, False)
    relax_deep = SoftContact(closing, 0.0, 0.0, 0.0, 0.0, WAIT, OVER_RELAXATION, False, True)
    accumulate = setting.accumulate == 1
    warm = accumulate and setting.warm_starting == 1 and count > 0
    gravity = math.sqrt(setting.gravity_x * setting.gravity_x + setting.gravity_y * setting.gravity_y)

    prepare_forces(bodies, rows, solver, level, setting, seconds, workers)
    if jointed:
        workers.numbers[SLOTS] = blocks.blocks[count - 1].first + blocks.blocks[count - 1].count if count > 0 else 0
        call_joints(contacts, workers, SELECT, seconds)
    scale = Scale(gravity, unit)
    flight = Flight(substeps, seconds, scale, todo.impacts)
    now = state.counters[0].step_count
    struck: Any = batches.struck[batches.first_body[todo.batch] :]
    frozen = fly(bodies, rows, todo.held_count, solver, active.info, now, flight, workers)
    touched = rows[: todo.touched_count]
    rows = rows[: todo.held_count]
    late = 0  # impacts without restitution, no more than the scene's own substeps would have
    for substep in range(substeps):
        integrate_velocities(rows, solver, workers)
        if listed > 0:
            call_strikes(contacts, workers, todo.batch, seconds)
        if struck_count > 0 and substep == 0:
            stop_struck(bodies, solver, struck, blocks, struck_count, workers, rigid, unit)
        if rest:
            solve_mouse_joints(state, solver, level, seconds)
        frozen += guard_velocities(bodies, rows, solver, active.info, now, workers)
        if warm and substep == 0:
            begin_parts(touched, solver)
            warm_start(motions, blocks, count, workers)
        elif warm:
            add_parts(touched, solver, workers)
        else:
            forget_impulses(blocks, 0, count)
        if jointed:
            if warm:
                turn_parts(touched, solver, workers)
            call_joints(contacts, workers, SOLVE, seconds)
            if warm:
                turn_parts(touched, solver, workers)
        if todo.new and substep == 0:
            # What was just put there has no impulses yet, and soft contacts alone would let it slip until it has.
            if now == 0 and spring.yields > 0.0:
                put_down(bodies, solver, struck, contacts.now, blocks, unsettled, workers, rigid, spring, gravity)
            else:
                solve_contacts(motions, blocks, 0, unsettled, workers, rigid)
            if not accumulate:
                forget_impulses(blocks, 0, unsettled)
        sums = warm and substep > 0
        push = -setting.push_out_speed * unit
        soft = SoftContact(closing, spring.bias, spring.softness, spring.softness_jointed, push, 0.0, 0.0, sums, False)
        solve_contacts(motions, blocks, 0, count, workers, soft)
        if jointed:
            apply_corrections(joints.direct, motions, seconds)
        integrate_positions(rows, solver, scale, seconds, todo.impacts, workers)
        apart = warm and (todo.impacts or jointed)
        if apart:
            turn_parts(touched, solver, workers)
        if listed > 0:
            call_strikes(contacts, workers, todo.batch, -seconds)
        if struck_count > 0 and late <= substep >> level:  # the relax pass would stop them a contact at a time
            late += 1 if stop_late(bodies, solver, struck, blocks, struck_count, workers, rigid, unit) else 0
        if jointed:
            call_joints(contacts, workers, RELAX if substep + 1 < substeps else RELAX_LAST, seconds)
        if apart:
            turn_parts(touched, solver, workers)
        if setting.relax == 1:
            relax_contacts(motions, blocks, todo.blocks, workers, relax, relax_deep, accumulate)
        if warm and substep + 1 < substeps:
            turn_parts(touched, solver, workers)
    return frozen
