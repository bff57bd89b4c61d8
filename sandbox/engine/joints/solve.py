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
from sandbox.engine.joints.errors import measure_errors
from sandbox.engine.joints.gauss_seidel import solve_softly
from sandbox.engine.joints.geometric_stiffness import add_geometric_stiffness, remove_geometric_stiffness
from sandbox.engine.joints.hinges import accumulate_hinges, load_hinges
from sandbox.engine.joints.jacobian import fill_rows
from sandbox.engine.joints.joint_bodies import (
    gather_members,
    load_members,
    move_by_end_velocity,
    predict_poses,
    scatter_members,
)
from sandbox.engine.joints.ldl import change_impulse, factorize, solve_directly
from sandbox.engine.joints.pivoting import cap_pairs, choose_rows, clamp, release_bounded
from sandbox.engine.joints.position_correction import apply_corrections, find_corrections
from sandbox.engine.joints.reactions import accumulate, read_impulses
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.separated import detect_separation, misses_targets, solve_velocities_only
from sandbox.engine.records.contacts import Contacts
from sandbox.tables import Records

_TURNS = 16
"""Most guesses at which rows are at their bounds, in one pass."""


@kernel
def begin_joints(work: JointWork, bodies: Records, contacts: Contacts) -> None:
    """Load members, find out which parts something bears, and take over the impulses of the last step."""
    load_members(work, bodies)
    for p in range(work.parts.shape[0]):
        work.parts[p].supported = 0
    for k in range(1, contacts.active[0] + 1):
        contact = contacts.now[contacts.active[k]]
        if contact.normal_impulse1 > 0.0 or contact.normal_impulse2 > 0.0:
            for side in range(2):
                part = work.part_of[contact.body_a if side == 0 else contact.body_b]
                if part >= 0:
                    work.parts[part].supported = 1
    for p in range(work.parts.shape[0]):
        work.parts[p].halves = work.parts[p].direct * (1 - work.parts[p].supported)
    read_impulses(work)
    load_hinges(work)


@kernel
def select_parts(work: JointWork, free_motions: Records, substep_level: int) -> None:
    """Choose the parts whose islands take their substeps now."""
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        same = part.awake == 1 and free_motions[work.members[part.first_member].body].substep_level == substep_level
        part.current = 1 if same else 0


@kernel
def solve_joints(work: JointWork, motions: Records, free_motions: Records, seconds: float) -> None:
    """Before the move: change velocities so that joints will be kept after it."""
    gather_members(work, motions, free_motions, True)
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.current == 1 and part.direct == 0:
            solve_softly(work, part, motions, seconds, True)
        elif part.current == 1:
            acting = 0.5 * seconds if part.halves == 1 else seconds
            _update_rows(work, part, motions)
            add_geometric_stiffness(work, part, seconds, acting)
            fill_rows(work, part)
            detect_separation(work, part, seconds)
            if part.separated == 1:
                remove_geometric_stiffness(work, part)
                fill_rows(work, part)
            _start_warm(work, part, False)
            settled = _solve(work, part, motions, seconds, acting, False)
            if part.separated == 0 and not (settled and _reaches_targets(work, part, motions, seconds)):
                solve_velocities_only(work, part)
                remove_geometric_stiffness(work, part)
                _update_rows(work, part, motions)
                _solve(work, part, motions, seconds, acting, False)
            if part.separated == 1:
                find_corrections(work, part, seconds)
    scatter_members(work, motions)


@kernel
def _update_rows(work: JointWork, part: Records, motions: Records) -> None:
    """Rows of the present pose."""
    predict_poses(work, part, motions, 0.0)
    measure_errors(work, part)
    fill_rows(work, part)


@kernel
def _reaches_targets(work: JointWork, part: Records, motions: Records, seconds: float) -> bool:
    """Whether the velocities found bring every joint about where it was meant to be."""
    predict_poses(work, part, motions, seconds)
    measure_errors(work, part)
    return not misses_targets(work, part, seconds)


@kernel
def prepare_move(work: JointWork, motions: Records, free_motions: Records, seconds: float) -> None:
    """Make `integrate_positions` move members by the velocities that the joints count on; correct what is separated."""
    move_by_end_velocity(work, motions, free_motions)
    apply_corrections(work, motions, seconds)


@kernel
def relax_joints(work: JointWork, motions: Records, free_motions: Records, seconds: float) -> None:
    """After the move: change velocities so that they keep the joints, too."""
    gather_members(work, motions, free_motions, False)
    for p in range(work.parts.shape[0]):
        part = work.parts[p]
        if part.current == 1 and part.direct == 0:
            solve_softly(work, part, motions, seconds, False)
            accumulate(work, part)
            accumulate_hinges(work, part)
        elif part.current == 1:
            _update_rows(work, part, motions)
            _start_warm(work, part, True)
            _solve(work, part, motions, seconds, seconds, True)
            accumulate(work, part)
    scatter_members(work, motions)


@kernel
def _start_warm(work: JointWork, part: Records, relaxing: bool) -> None:
    """Apply the impulses of the substep before; springs give the other half of theirs where they act in halves."""
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        row.capped = 0
        row.active = -1
        if row.stiffness == 0.0:
            row.impulse = 0.0
            row.relaxing = 0.0
            row.active = 0
        current = row.relaxing if relaxing else row.impulse
        if relaxing and row.soft == 1:
            current = row.impulse if part.halves == 1 else 0.0
        if relaxing:
            row.relaxing = 0.0
        else:
            row.impulse = 0.0
            row.stop = 1 if current > 0.0 else (-1 if current < 0.0 else 0)
        change_impulse(work, row, current, relaxing)


@kernel
def _solve(
    work: JointWork,
    part: Records,
    motions: Records,
    seconds: float,
    acting: float,
    relaxing: bool,
) -> bool:
    """Whether all marks of the rows came to rest."""
    again = False
    settled = False
    for turn in range(_TURNS):
        if not relaxing:
            predict_poses(work, part, motions, seconds)
            measure_errors(work, part)
        changed = choose_rows(work, part, seconds, acting, relaxing)
        if turn > 0 and not (changed or again):
            settled = True
            break
        again = changed and turn > 0  # then the pose looked at was that of a wrong guess
        if changed:
            factorize(work, part)
        solve_directly(work, part, relaxing)
        cap_pairs(work, part, seconds, acting, relaxing)
        if part.bounded == 0:
            settled = True
            break
    if part.separated == 1 and not settled:
        release_bounded(work, part, relaxing)
        factorize(work, part)
        solve_directly(work, part, relaxing)
        return False
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        if row.stiffness > 0.0 and row.capped == 0:
            clamp(work, row, relaxing)
    return settled
