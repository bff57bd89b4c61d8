"""The hinges of nets, solved side by side: soft joints as in `gauss_seidel`, both rows of a hinge at once."""

from __future__ import annotations

import math
from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver.blocks import LANES
from sandbox.engine.joints import hinge_lanes as hl
from sandbox.engine.joints.hinge_lanes import HINGE_BLOCK_SIZE, HingeLanes
from sandbox.engine.joints.records import JointWork
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import FASTEST, GIVE, MOST, PUSH, SWEEP_HINGES, WARM_START_HINGES
from sandbox.tables import Floats, Records


class SoftHinge(NamedTuple):
    """How a sweep treats hinges: `push` (1/s) turns a gap into the speed that takes it back, of `most` m at most;
    `give` is the softness as a share of the stiffness."""

    push: float
    most: float
    give: float


class HingePose(NamedTuple):
    """Where the anchors of a hinge are: a's, where it is pushed, b's, both from the centres, and the gap, m."""

    ax: float
    ay: float
    bx: float
    by: float
    gap_x: float
    gap_y: float


@kernel
def load_hinges(work: JointWork) -> None:
    """Fill the lanes for a step: anchors, masses, and the impulses to start from."""
    h = work.side_by_side
    for n in range(h.blocks.shape[0]):
        block = h.blocks[n]
        v = h.lanes[n * HINGE_BLOCK_SIZE : (n + 1) * HINGE_BLOCK_SIZE]
        for k in range(block.count):
            hinge = h.hinges[block.first + k]
            joint = work.joints[hinge.joint]
            a = work.members[hinge.member_a]
            b = work.members[hinge.member_b]
            v[hl.ANCHOR_AX + k] = joint.anchor_ax
            v[hl.ANCHOR_AY + k] = joint.anchor_ay
            v[hl.ANCHOR_BX + k] = joint.anchor_bx
            v[hl.ANCHOR_BY + k] = joint.anchor_by
            v[hl.CENTER_X + k] = b.center_x - a.center_x
            v[hl.CENTER_Y + k] = b.center_y - a.center_y
            v[hl.INVERSE_MASS_A + k] = a.inverse_mass
            v[hl.INVERSE_INERTIA_A + k] = a.inverse_inertia
            v[hl.INVERSE_MASS_B + k] = b.inverse_mass
            v[hl.INVERSE_INERTIA_B + k] = b.inverse_inertia
            v[hl.IMPULSE_X + k] = joint.impulse_0
            v[hl.IMPULSE_Y + k] = joint.impulse_1
            v[hl.TOTAL_X + k] = 0.0
            v[hl.TOTAL_Y + k] = 0.0


@kernel
def warm_start_hinges(work: JointWork, part: Records, seconds: float, far: float, workers: Workers) -> None:
    """Apply the impulses of the substep before, but at what turns by more than `far` rad in this one."""
    workers.numbers[FASTEST] = far / seconds
    h = work.side_by_side
    at = part.first_block
    while at < part.block_end:
        stop = at + h.blocks[at].left
        first, end = first_part(workers, WARM_START_HINGES, at, stop)
        while first < end:
            warm_start_hinge_blocks(h, work.members, first, end, far / seconds, workers.gathered)
            first, end = next_part(workers, first, end)
        at = stop


@kernel
def warm_start_hinge_blocks(
    h: HingeLanes, members: Records, first: int, end: int, fastest: float, gathered: Floats
) -> None:
    """The same for blocks of one colour, but at what turns faster than `fastest` rad/s. `gathered` is scratch."""
    for n in range(first, end):
        v = h.lanes[n * HINGE_BLOCK_SIZE : (n + 1) * HINGE_BLOCK_SIZE]
        _gather(members, h, h.blocks[n], gathered)
        _warm_start_lanes(v, gathered, fastest)
        _scatter(members, h, h.blocks[n], gathered)


@kernel
def sweep_hinges(work: JointWork, part: Records, soft: SoftHinge, backwards: bool, workers: Workers) -> None:
    """One sweep over the hinges of a part: colour after colour, or from the last colour on."""
    n = workers.numbers
    n[PUSH] = soft.push
    n[MOST] = soft.most
    n[GIVE] = soft.give
    h = work.side_by_side
    done = part.first_block
    while done < part.block_end:
        last = part.first_block + part.block_end - 1 - done
        at = last - h.blocks[last].before if backwards else done
        stop = last + 1 if backwards else done + h.blocks[done].left
        first, end = first_part(workers, SWEEP_HINGES, at, stop)
        while first < end:
            sweep_hinge_blocks(h, work.members, first, end, soft, workers.gathered)
            first, end = next_part(workers, first, end)
        done += stop - at


@kernel
def sweep_hinge_blocks(
    h: HingeLanes, members: Records, first: int, end: int, soft: SoftHinge, gathered: Floats
) -> None:
    """The same for blocks of one colour. `gathered` is scratch."""
    for n in range(first, end):
        v = h.lanes[n * HINGE_BLOCK_SIZE : (n + 1) * HINGE_BLOCK_SIZE]
        _gather(members, h, h.blocks[n], gathered)
        _sweep_lanes(v, gathered, soft)
        _scatter(members, h, h.blocks[n], gathered)


@kernel
def accumulate_hinges(work: JointWork, part: Records) -> None:
    """Add the impulses of a substep to those of the step."""
    lanes = work.side_by_side.lanes
    for n in range(part.first_block, part.block_end):
        v = lanes[n * HINGE_BLOCK_SIZE : (n + 1) * HINGE_BLOCK_SIZE]
        for k in range(LANES):
            v[hl.TOTAL_X + k] += v[hl.IMPULSE_X + k]
            v[hl.TOTAL_Y + k] += v[hl.IMPULSE_Y + k]


@kernel
def report_hinges(work: JointWork, part: Records, seconds: float, counter: Records) -> None:
    """Write impulses, mean forces on b over the step and breakage into the joint table."""
    h = work.side_by_side
    for n in range(part.first_block, part.block_end):
        block = h.blocks[n]
        v = h.lanes[n * HINGE_BLOCK_SIZE : (n + 1) * HINGE_BLOCK_SIZE]
        for k in range(block.count):
            joint = work.joints[h.hinges[block.first + k].joint]
            joint.impulse_0 = v[hl.IMPULSE_X + k]
            joint.impulse_1 = v[hl.IMPULSE_Y + k]
            x = v[hl.TOTAL_X + k] / seconds
            y = v[hl.TOTAL_Y + k] / seconds
            joint.force_x = x
            joint.force_y = y
            joint.torque = 0.0
            if math.sqrt(x * x + y * y) > joint.break_force:
                joint.broken_step = counter.step_count
                counter.broken_count += 1


@kernel
def _gather(members: Records, h: HingeLanes, block: Records, g: Floats) -> None:
    for k in range(block.count):
        hinge = h.hinges[block.first + k]
        a = members[hinge.member_a]
        b = members[hinge.member_b]
        g[hl.VELOCITY_AX + k] = a.velocity_x
        g[hl.VELOCITY_AY + k] = a.velocity_y
        g[hl.ANGULAR_A + k] = a.angular_velocity
        g[hl.VELOCITY_BX + k] = b.velocity_x
        g[hl.VELOCITY_BY + k] = b.velocity_y
        g[hl.ANGULAR_B + k] = b.angular_velocity
        g[hl.DELTA_X + k] = b.displacement_x - a.displacement_x
        g[hl.DELTA_Y + k] = b.displacement_y - a.displacement_y
        g[hl.COS_A + k] = a.cos
        g[hl.SIN_A + k] = a.sin
        g[hl.COS_B + k] = b.cos
        g[hl.SIN_B + k] = b.sin


@kernel
def _scatter(members: Records, h: HingeLanes, block: Records, g: Floats) -> None:
    for k in range(block.count):
        hinge = h.hinges[block.first + k]
        a = members[hinge.member_a]
        b = members[hinge.member_b]
        a.velocity_x = g[hl.VELOCITY_AX + k]
        a.velocity_y = g[hl.VELOCITY_AY + k]
        a.angular_velocity = g[hl.ANGULAR_A + k]
        b.velocity_x = g[hl.VELOCITY_BX + k]
        b.velocity_y = g[hl.VELOCITY_BY + k]
        b.angular_velocity = g[hl.ANGULAR_B + k]


@inlined_kernel
def _pose(v: Floats, g: Floats, k: int) -> HingePose:
    """Both are pushed at b's anchor, unless that is further off than half of the longer arm; see `jacobian`."""
    ax = g[hl.COS_A + k] * v[hl.ANCHOR_AX + k] - g[hl.SIN_A + k] * v[hl.ANCHOR_AY + k]
    ay = g[hl.SIN_A + k] * v[hl.ANCHOR_AX + k] + g[hl.COS_A + k] * v[hl.ANCHOR_AY + k]
    bx = g[hl.COS_B + k] * v[hl.ANCHOR_BX + k] - g[hl.SIN_B + k] * v[hl.ANCHOR_BY + k]
    by = g[hl.SIN_B + k] * v[hl.ANCHOR_BX + k] + g[hl.COS_B + k] * v[hl.ANCHOR_BY + k]
    gap_x = v[hl.CENTER_X + k] + g[hl.DELTA_X + k] + (bx - ax)
    gap_y = v[hl.CENTER_Y + k] + g[hl.DELTA_Y + k] + (by - ay)
    arm_a = ax * ax + ay * ay
    arm_b = bx * bx + by * by
    close = gap_x * gap_x + gap_y * gap_y < 0.25 * (arm_a if arm_a > arm_b else arm_b)
    return HingePose(ax + (gap_x if close else 0.0), ay + (gap_y if close else 0.0), bx, by, gap_x, gap_y)


@inlined_kernel
def _push(v: Floats, g: Floats, k: int, p: HingePose, x: float, y: float) -> None:
    """Give b the impulse (x, y) N s, and a the opposite."""
    g[hl.VELOCITY_AX + k] -= v[hl.INVERSE_MASS_A + k] * x
    g[hl.VELOCITY_AY + k] -= v[hl.INVERSE_MASS_A + k] * y
    g[hl.ANGULAR_A + k] -= v[hl.INVERSE_INERTIA_A + k] * (p.ax * y - p.ay * x)
    g[hl.VELOCITY_BX + k] += v[hl.INVERSE_MASS_B + k] * x
    g[hl.VELOCITY_BY + k] += v[hl.INVERSE_MASS_B + k] * y
    g[hl.ANGULAR_B + k] += v[hl.INVERSE_INERTIA_B + k] * (p.bx * y - p.by * x)


@kernel
def _warm_start_lanes(v: Floats, g: Floats, fastest: float) -> None:
    for k in range(LANES):
        spins = abs(g[hl.ANGULAR_A + k]) > fastest or abs(g[hl.ANGULAR_B + k]) > fastest
        x = 0.0 if spins else v[hl.IMPULSE_X + k]
        y = 0.0 if spins else v[hl.IMPULSE_Y + k]
        v[hl.IMPULSE_X + k] = x
        v[hl.IMPULSE_Y + k] = y
        _push(v, g, k, _pose(v, g, k), x, y)


@kernel
def _sweep_lanes(v: Floats, g: Floats, soft: SoftHinge) -> None:
    for k in range(LANES):
        p = _pose(v, g, k)
        v[hl.GAP_X + k] = p.gap_x
        v[hl.GAP_Y + k] = p.gap_y
        ia = v[hl.INVERSE_INERTIA_A + k]
        ib = v[hl.INVERSE_INERTIA_B + k]
        mass = v[hl.INVERSE_MASS_A + k] + v[hl.INVERSE_MASS_B + k]
        xx = mass + ia * p.ay * p.ay + ib * p.by * p.by
        yy = mass + ia * p.ax * p.ax + ib * p.bx * p.bx
        xy = -(ia * p.ax * p.ay) - ib * p.bx * p.by
        # Where the push is cut the hinge grows stiffer, so that it gives way no further than the same spring would.
        share_x = soft.most / abs(p.gap_x) if abs(p.gap_x) > soft.most else 1.0
        share_y = soft.most / abs(p.gap_y) if abs(p.gap_y) > soft.most else 1.0
        give_x = soft.give * xx * share_x
        give_y = soft.give * yy * share_y
        x = g[hl.VELOCITY_BX + k] - g[hl.ANGULAR_B + k] * p.by - g[hl.VELOCITY_AX + k] + g[hl.ANGULAR_A + k] * p.ay
        y = g[hl.VELOCITY_BY + k] + g[hl.ANGULAR_B + k] * p.bx - g[hl.VELOCITY_AY + k] - g[hl.ANGULAR_A + k] * p.ax
        x = x + soft.push * share_x * p.gap_x + give_x * v[hl.IMPULSE_X + k]
        y = y + soft.push * share_y * p.gap_y + give_y * v[hl.IMPULSE_Y + k]
        soft_xx = xx + give_x
        soft_yy = yy + give_y
        determinant = soft_xx * soft_yy - xy * xy
        inverse = 1.0 / determinant if determinant > 0.0 else 0.0
        change_x = -inverse * (soft_yy * x - xy * y)
        change_y = -inverse * (soft_xx * y - xy * x)
        v[hl.IMPULSE_X + k] += change_x
        v[hl.IMPULSE_Y + k] += change_y
        _push(v, g, k, p, change_x, change_y)
