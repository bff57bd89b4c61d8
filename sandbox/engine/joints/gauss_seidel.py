"""Soft joints, for what hangs together too densely to be factorised (nets, cloth): sweeps over rows, warm started.

A sweep carries a load one joint further, so a net that strives for no error at all after each substep never gets there,
and what is left over comes back as energy. Its rigid rows are therefore stiff damped springs, taken implicitly, and the
speed that their push has added is taken away again after the move: the soft step and relaxing of E. Catto, "Solver2D",
2024. Several sweeps share a substep, so that small nets are nearly as stiff as if they were factorised.
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.contact_solver.soft_constraint import soft_coefficients, substep_share
from sandbox.engine.joints.errors import measure_errors
from sandbox.engine.joints.jacobian import fill_rows, push_row, row_speed
from sandbox.engine.joints.joint_bodies import place_members
from sandbox.engine.joints.laws import CORRECTION_SPEED, INFINITE
from sandbox.engine.joints.net_blocks import SoftJoint
from sandbox.engine.joints.net_sweeps import sweep_nets
from sandbox.engine.joints.net_warm_start import warm_start_net
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.targets import pair_strength, target_softly
from sandbox.engine.records.workers import Workers
from sandbox.tables import Records
from sandbox.world.joint_records import GEAR

SWEEPS = 480.0
"""Sweeps for each second: 2 in a substep of 1/240 s; longer ones have more to carry."""
FEWEST = 2
"""One each way: with one, always in the same order, hubs of many joints swing themselves up, the more the finer the
substeps are."""
MOST = 64
STIFFNESS = 0.25
"""Frequency of rigid rows as a share of the rate of substeps of level 0: the most that these can follow."""
DAMPING_RATIO = 2.0


@kernel
def solve_softly(
    work: JointWork, part: Records, motions: Records, seconds: float, pushing: bool, workers: Workers
) -> None:
    """Sweep over the rows of a part: before the move with their push (`pushing`), and after it without."""
    hertz = STIFFNESS * substep_share(part.level) / seconds  # else what is drawn apart would gain energy with the level
    bias_rate, mass_scale, impulse_scale = soft_coefficients(hertz, DAMPING_RATIO, seconds)
    push = bias_rate if pushing else 0.0
    give = impulse_scale / mass_scale if pushing else 0.0
    most = CORRECTION_SPEED * work.direct.units[0] / push if pushing else 0.0
    if part.swept == 1:
        place_members(work, part, motions)
        _prepare_rows(work, motions, part, seconds, push, give)
    if pushing:
        warm_start_net(work, motions, part, seconds, workers)
    for sweep in range(_sweeps(seconds)):
        if part.swept == 1:
            _sweep_rows(work, motions, part, seconds, push, give, sweep % 2 == 1)
            if part.capped == 1:
                _cap_pairs(work, motions, part, seconds)
        sweep_nets(work, motions, part, SoftJoint(push, most, give, seconds), sweep % 2 == 1, workers)


@kernel
def _prepare_rows(work: JointWork, motions: Records, part: Records, seconds: float, push: float, give: float) -> None:
    """Fill the rows of all joints of a part that lie in no lane; gears last, for they build on others."""
    for turn in range(2 if part.geared == 1 else 1):
        for k in range(part.first_constraint, part.constraint_end):
            constraint = work.constraints[k]
            joint = work.joints[constraint.joint]
            if constraint.in_lane == 0 and (joint.kind == GEAR) == (turn == 1):
                measure_errors(work, motions, constraint, joint)
                fill_rows(work, constraint, joint, seconds, push, give)


@kernel
def _sweep_rows(
    work: JointWork, motions: Records, part: Records, seconds: float, push: float, give: float, backwards: bool
) -> None:
    """One sweep over the rows of a part that lie in no lane."""
    for k in range(part.row_end - part.first_row):
        row = work.rows[part.row_end - 1 - k if backwards else part.first_row + k]
        if row.stiffness > 0.0:
            _solve_row(work, motions, row, seconds, push, give)


@kernel
def _sweeps(seconds: float) -> int:
    wanted = int(SWEEPS * seconds + 0.5)
    wanted = wanted if wanted < MOST else MOST
    return wanted if wanted > FEWEST else FEWEST


@kernel
def _solve_row(work: JointWork, motions: Records, row: Records, seconds: float, push: float, give: float) -> None:
    """Give one row the impulse that it strives for, within its bounds."""
    speed = row_speed(work.members, motions, row)
    if row.steady == 0:
        joint = work.joints[work.constraints[row.constraint].joint]
        target_softly(work.members, row, joint, speed, seconds, push, give, work.direct.units[0])
    after = row.impulse - (speed + row.bias + row.softness * row.impulse) / (row.stiffness + row.softness)
    after = after if after < row.high else row.high
    after = after if after > row.low else row.low
    _change_impulse(work, motions, row, after - row.impulse)


@kernel
def _change_impulse(work: JointWork, motions: Records, row: Records, change: float) -> None:
    """Add to a row's impulse and to the velocities of its members."""
    row.impulse += change
    push_row(work.members, motions, row, change)


@kernel
def _cap_pairs(work: JointWork, motions: Records, part: Records, seconds: float) -> None:
    """Shorten forces of two rows that are together past their limit."""
    for r in range(part.first_row, part.row_end):
        row = work.rows[r]
        joint = work.joints[work.constraints[row.constraint].joint]
        most = pair_strength(row, joint) if row.slot == 0 and row.stiffness > 0.0 else INFINITE
        if most >= INFINITE:
            continue
        other = work.rows[r + 1]
        size = math.sqrt(row.impulse * row.impulse + other.impulse * other.impulse)
        if size > most * seconds:
            share = most * seconds / size - 1.0
            _change_impulse(work, motions, row, share * row.impulse)
            _change_impulse(work, motions, other, share * other.impulse)
