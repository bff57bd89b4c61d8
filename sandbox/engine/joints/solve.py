"""The joint solver: its stages (`stages.py`) for all parts that are factorised; `nets.py` has those of the others.

Positions are solved by RATTLE (H. Andersen, 1983), the constrained form of velocity Verlet: impulses along the rows
of now bring the members to where every joint is kept *after* the move, and after it the velocities are relaxed along
the rows of then. It is of second order and symplectic, so that a pendulum keeps its energy. Springs follow the
implicit midpoint rule. Parts that something else bears take the whole force before the move, as contacts do; parts
that are separated keep to velocities (`separated`); parts that are too dense to be factorised have soft joints
(`gauss_seidel`).
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import entry_point, kernel
from sandbox.engine.joints.direct.batches import fill_batches
from sandbox.engine.joints.direct.records import IS_LAST, SUBSTEP_LEVEL
from sandbox.engine.joints.direct.reports import report_batches
from sandbox.engine.joints.direct.solve import solve_batches, solve_some_batches
from sandbox.engine.joints.fine_substeps import refine_small_parts
from sandbox.engine.joints.joint_bodies import load_members, move_by_end_velocity, part_level
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.sleep import flag_joined
from sandbox.engine.joints.stages import LOAD, RELAX_LAST, REPORT, SELECT, SOLVE, TOUCH
from sandbox.engine.joints.touched_parts import flag_touched_parts
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import TASK, told_range
from sandbox.engine.workers.task_kinds import LEVEL, RELAX_BATCHES, SECONDS, SLOTS, SOLVE_BATCHES, STAGE
from sandbox.tables import Records


@entry_point
def do_joints(
    state: StateTables,
    active: ActiveSet,
    solver: SolverBodies,
    contacts: Contacts,
    blocks: ContactBlocks,
    joints: JointWork,
    workers: Workers,
) -> None:
    """Do the stage of the joint solver that `workers.numbers` tells of; another worker than the first, a range of the
    task under way."""
    motions = solver.motions
    free_motions = solver.free_motions
    numbers = workers.numbers
    seconds = numbers[SECONDS]
    if workers.number > 0:
        first, end = told_range(workers)
        task = workers.words[TASK]
        solve_some_batches(joints.direct, motions, free_motions, seconds, task, workers.number, first, end)
        return
    stage = int(numbers[STAGE])
    if stage == TOUCH:
        flag_touched_parts(joints, contacts, state.drags)
        active.info[0].substep_levels |= refine_small_parts(joints, state.bodies, free_motions)
    elif stage == LOAD:
        _load(joints, state.bodies, solver, state.counters[0].step_count == 0)
    elif stage == SELECT:
        _select_parts(joints, int(numbers[LEVEL]))
        in_contact: Any = blocks.slots[: int(numbers[SLOTS])]
        move_by_end_velocity(joints, state.bodies, solver.forces, in_contact, solver.struck)
    elif stage == REPORT:
        report_batches(joints, seconds, state.counters[0])
        flag_joined(solver.flags, joints)
    else:
        joints.direct.level[IS_LAST] = 1 if stage == RELAX_LAST else 0
        task = SOLVE_BATCHES if stage == SOLVE else RELAX_BATCHES
        solve_batches(joints.direct, motions, free_motions, seconds, task, workers)


@kernel
def _load(work: JointWork, bodies: Records, solver: SolverBodies, new: bool) -> None:
    """Load members, choose whose forces act in halves, and take over the impulses of the last step.

    In the first step of a world all is `new`.
    """
    load_members(work, bodies, solver)
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        part.halves = part.direct * (1 - part.supported)
        part.level = part_level(work, part, solver.free_motions)
    fill_batches(work, bodies, new)


@kernel
def _select_parts(work: JointWork, substep_level: int) -> None:
    """Choose the parts whose islands take their substeps now."""
    work.direct.level[SUBSTEP_LEVEL] = substep_level
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        part.current = 1 if part.awake == 1 and part.level == substep_level else 0
