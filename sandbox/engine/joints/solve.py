"""The stages of the joint solver, in the order in which the step calls them.

Positions are solved by RATTLE (H. Andersen, 1983), the constrained form of velocity Verlet: impulses along the rows
of now bring the members to where every joint is kept *after* the move, and after it the velocities are relaxed along
the rows of then. It is of second order and symplectic, so that a pendulum keeps its energy. Springs follow the
implicit midpoint rule. Parts that something else bears take the whole force before the move, as contacts do; parts
that are separated keep to velocities (`separated`); parts that are too dense to be factorised have soft joints
(`gauss_seidel`).
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.joints.direct.batches import fill_batches
from sandbox.engine.joints.direct.records import IS_LAST, SUBSTEP_LEVEL
from sandbox.engine.joints.direct.solve import solve_batches
from sandbox.engine.joints.gauss_seidel import solve_softly
from sandbox.engine.joints.joint_bodies import load_members, part_level
from sandbox.engine.joints.net_sweeps import load_nets
from sandbox.engine.joints.reactions import accumulate, read_impulses
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.task_kinds import RELAX_BATCHES, SOLVE_BATCHES
from sandbox.tables import Records


@kernel
def begin_joints(
    work: JointWork, bodies: Records, motions: Records, free_motions: Records, new: bool, workers: Workers
) -> None:
    """Load members, choose whose forces act in halves, and take over the impulses of the last step.

    In the first step of a world all is `new`.
    """
    load_members(work, bodies, motions)
    for p in range(work.parts.shape[0]):
        work.parts[p].halves = work.parts[p].direct * (1 - work.parts[p].supported)
    read_impulses(work)
    load_nets(work, motions, workers)
    fill_batches(work, bodies, free_motions, new)


@kernel
def select_parts(work: JointWork, free_motions: Records, substep_level: int) -> None:
    """Choose the parts whose islands take their substeps now."""
    work.direct.level[SUBSTEP_LEVEL] = substep_level
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        same = part.awake == 1 and part_level(work, part, free_motions) == substep_level
        part.current = 1 if same else 0


@kernel
def solve_joints(work: JointWork, motions: Records, free_motions: Records, seconds: float, workers: Workers) -> None:
    """Before the move: change velocities so that joints will be kept after it."""
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.current == 1 and part.direct == 0:
            solve_softly(work, part, motions, seconds, True, workers)
    solve_batches(work.direct, motions, free_motions, seconds, SOLVE_BATCHES, workers)


@kernel
def relax_joints(
    work: JointWork, motions: Records, free_motions: Records, seconds: float, last: bool, workers: Workers
) -> None:
    """After the move: change velocities so that they keep the joints, too. Some parts ask for that after the `last`
    substep alone (`direct.stagger`)."""
    work.direct.level[IS_LAST] = 1 if last else 0
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.current == 1 and part.direct == 0:
            solve_softly(work, part, motions, seconds, False, workers)
            accumulate(work, part)
    solve_batches(work.direct, motions, free_motions, seconds, RELAX_BATCHES, workers)
