"""The step: every stage of the engine, in order. Window, replay, benchmark and test all come through here.

It has four parts, so that an empty kernel cache can be filled by two processes at once (`compile_step.py`). What only
worlds with joints or impacts need they call by its address (`joints/stages.py`, `restitution/strike_batch.py`). Called
by another worker than the first, a part does a range of the task that the first one is at (`workers/tasks.py`).
"""

from __future__ import annotations

from sandbox._jit import entry_point
from sandbox.engine.active.active_set import update_active_set
from sandbox.engine.active.pile_stability import MAX_LEVEL
from sandbox.engine.active.sleep import fall_asleep
from sandbox.engine.active.substep_level import assign_substep_levels
from sandbox.engine.active.wake_islands import wake_touched
from sandbox.engine.bodies.begin_and_finish import begin_bodies, finish_bodies, forget_posed
from sandbox.engine.broad_phase.active_shapes import list_woken_shapes, order_shapes
from sandbox.engine.broad_phase.fat_boxes import SLACK
from sandbox.engine.broad_phase.pair_cache import select_pairs, update_pair_cache
from sandbox.engine.broad_phase.proxies import bound_shapes
from sandbox.engine.contact_solver.closing_speed import bounce_threshold
from sandbox.engine.contact_solver.store import clear_reports
from sandbox.engine.joints.pair_filter import JointFilter
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.stages import LOAD, REPORT, TOUCH, call_joints, has_joints
from sandbox.engine.midpoint.midpoint import move_to_midpoint
from sandbox.engine.midpoint.poses import rewind_driven
from sandbox.engine.narrow_phase.find_contacts import find_contacts
from sandbox.engine.narrow_phase.sleeping_contacts import (
    begin_sleeping_contacts,
    end_sleeping_contacts,
    list_active_contacts,
)
from sandbox.engine.narrow_phase.speculative import mark_may_stop
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.colliders import Colliders, Grid
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.decisions import Decisions
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import Workers
from sandbox.engine.restitution.strike_batch import lacks_impacts
from sandbox.engine.restitution.struck import flag_struck
from sandbox.engine.solve_islands import Level, solve_level
from sandbox.engine.workers.tasks import help_collide, help_finish, help_solve
from sandbox.tables import Records


@entry_point
def collide(
    state: StateTables,
    active: ActiveSet,
    solver: SolverBodies,
    colliders: Colliders,
    grid: Grid,
    contacts: Contacts,
    joint_filter: JointFilter,
    workers: Workers,
    decisions: Decisions,
) -> int:
    """Grid and SAT at the poses of now. `contacts.now` and `counters.found_count` have the answer.

    Returns 0, or the number of pairs that scratch memory must have room for before this is called again.
    """
    if workers.number > 0:
        help_collide(state, active, colliders, grid, contacts, workers, decisions)
        return 0
    counter = state.counters[0]
    update_active_set(state.bodies, active, solver)
    info = active.info[0]
    changed = order_shapes(state.shapes, active)
    outdated = active.shapes[: info.listed]
    bound_shapes(state, outdated, changed != 0, colliders, grid, workers)
    kept = counter.contact_count if counter.asleep_count > 0 else 0
    seconds = state.settings[0].step_seconds
    slack = SLACK * state.settings[0].units_per_meter
    pair_count = update_pair_cache(colliders, outdated, state.shapes.shape[0], seconds, slack, grid)
    if pair_count > 0:
        return pair_count + kept
    pair_count = select_pairs(colliders, seconds, joint_filter, grid)
    if pair_count + kept > grid.pairs.shape[0]:
        return pair_count + kept
    mark_may_stop(colliders, active, solver.ccd)
    counter.pair_count = pair_count
    begin_sleeping_contacts(contacts, info, counter.contact_count)
    counter.found_count = find_contacts(state, active, colliders, grid.pairs, contacts, solver.ccd, workers, decisions)
    end_sleeping_contacts(contacts, info)
    info.listed = info.moving
    return 0


@entry_point
def begin(
    state: StateTables,
    active: ActiveSet,
    solver: SolverBodies,
    piles: Records,
    contacts: Contacts,
    blocks: ContactBlocks,
    joints: JointWork,
    workers: Workers,
) -> bool:
    """Wake what is touched, choose substep levels, and make bodies, contacts and joints ready for the substeps.

    Returns whether `strike_batch` has to be compiled before these.
    """
    jointed = has_joints(joints)
    bodies = state.bodies
    info = active.info[0]
    count = state.counters[0].found_count
    froze = begin_bodies(state, active, solver)
    if wake_touched(bodies, contacts, joints, active, state.counters) or froze:
        update_active_set(bodies, active, solver)
        list_woken_shapes(state.shapes, active)
        list_active_contacts(bodies, active.activity, contacts, count)
        begin_bodies(state, active, solver)
    if info.posed == 1:
        forget_posed(bodies, active)
    info.substep_levels = assign_substep_levels(state, active, solver, piles, contacts, joints)
    if jointed:
        call_joints(contacts, workers, TOUCH, state.settings[0].step_seconds)
    unit = state.settings[0].units_per_meter
    info.impact_speed = flag_struck(bodies, contacts, solver.ccd, solver.struck, blocks.spare, info.fastest, unit)
    move_to_midpoint(state, active, solver, contacts)
    if jointed:
        call_joints(contacts, workers, LOAD, state.settings[0].step_seconds)
    clear_reports(contacts.reports, count)
    return lacks_impacts(contacts, info.fastest, bounce_threshold(state.settings[0]))


@entry_point
def solve(
    state: StateTables,
    active: ActiveSet,
    solver: SolverBodies,
    contacts: Contacts,
    blocks: ContactBlocks,
    joints: JointWork,
    workers: Workers,
) -> None:
    """Solve contacts and joints and move everything, the islands of one substep level after those of another."""
    if workers.number > 0:
        help_solve(state, active, solver, contacts, blocks, joints, workers)
        return
    info = active.info[0]
    counter = state.counters[0]
    levels = info.substep_levels
    rows = active.bodies[1 : 1 + active.bodies[0]]
    counter.color_count = 0
    for level in range(MAX_LEVEL + 1):
        if (levels >> level) & 1 == 0:
            continue
        if level > 0:
            rewind_driven(state.bodies, rows, solver, 0.5 * state.settings[0].step_seconds)
        which = Level(level, levels > 1, info.fastest)
        colors = solve_level(state, active, solver, contacts, blocks, joints, workers, which)
        counter.color_count = colors if colors > counter.color_count else counter.color_count


@entry_point
def finish(
    state: StateTables,
    active: ActiveSet,
    solver: SolverBodies,
    contacts: Contacts,
    joints: JointWork,
    workers: Workers,
) -> bool:
    """Write the new motions to the bodies and what was borne to the joints, and let rest what may.

    Returns whether the step ends with `solve_continuous`: bodies may have passed through something.
    """
    if workers.number > 0:
        help_finish(state, active, solver, workers)
        return False
    counter = state.counters[0]
    if has_joints(joints):
        call_joints(contacts, workers, REPORT, state.settings[0].step_seconds)
    count = finish_bodies(state, active, solver, workers)
    if count.rested > 0 and state.settings[0].sleeping == 1:
        fall_asleep(state, active, solver, contacts, joints)
    counter.still = 1 if counter.awake_count + count.driven == 0 else 0
    counter.step_count += 1
    counter.old_contact_count = counter.contact_count
    counter.contact_count = counter.found_count
    return bool(count.fast > 0)
