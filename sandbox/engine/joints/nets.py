"""The joint solver for nets: its stages (`stages.py`) for parts that are too dense to be factorised, after those of the
others (`solve.py`), which load the members of all."""

from __future__ import annotations

from sandbox._jit import entry_point, kernel
from sandbox.engine.joints.gauss_seidel import solve_softly
from sandbox.engine.joints.net_blocks import SoftJoint
from sandbox.engine.joints.net_sweeps import (
    load_net_blocks,
    load_nets,
    report_net_blocks,
    report_nets,
    sweep_net_blocks,
    warm_start_net_blocks,
)
from sandbox.engine.joints.reactions import accumulate, read_impulses, report_swept
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.stages import LOAD, REPORT, SELECT, SOLVE, TOUCH
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import TASK, told_range
from sandbox.engine.workers.task_kinds import (
    GIVE,
    LOAD_NETS,
    MOST,
    PUSH,
    SECONDS,
    STAGE,
    SWEEP_NETS,
    WARM_START_NETS,
)
from sandbox.tables import Records, plain


def has_nets(work: JointWork) -> bool:
    """Whether some part is a net."""
    return bool((plain(work.parts)["direct"] == 0).any())


@entry_point
def do_nets(state: StateTables, solver: SolverBodies, joints: JointWork, workers: Workers) -> None:
    """Do the stage of the joint solver that `workers.numbers` tells of; another worker than the first, a range of the
    task under way."""
    if workers.number > 0:
        _help(state, solver, joints, workers)
        return
    seconds = workers.numbers[SECONDS]
    stage = int(workers.numbers[STAGE])
    if stage == LOAD:
        read_impulses(joints)
        load_nets(joints, workers)
    elif stage == REPORT:
        report_nets(joints, seconds, state.counters[0], workers)
        report_swept(joints, seconds, state.counters[0])
    elif stage != TOUCH and stage != SELECT:
        _solve_nets(joints, solver.motions, seconds, stage == SOLVE, workers)


@kernel
def _solve_nets(work: JointWork, motions: Records, seconds: float, pushing: bool, workers: Workers) -> None:
    """Sweep over all nets: before the move with their push (`pushing`), and after it without."""
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.current == 1 and part.direct == 0:
            solve_softly(work, part, motions, seconds, pushing, workers)
            if not pushing:
                accumulate(work, part)


@kernel
def _help(state: StateTables, solver: SolverBodies, joints: JointWork, workers: Workers) -> None:
    """Do a range of the task under way."""
    first, end = told_range(workers)
    n = workers.numbers
    motions = solver.motions
    task = workers.words[TASK]
    if task == LOAD_NETS:
        load_net_blocks(joints, first, end)
    elif task == SWEEP_NETS:
        soft = SoftJoint(n[PUSH], n[MOST], n[GIVE], n[SECONDS])
        sweep_net_blocks(joints.side_by_side, motions, first, end, soft)
    elif task == WARM_START_NETS:
        warm_start_net_blocks(joints.side_by_side, motions, first, end)
    else:
        report_net_blocks(joints, n[SECONDS], state.counters[0].step_count, workers, first, end)
