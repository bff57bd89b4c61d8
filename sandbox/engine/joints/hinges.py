"""The hinges of nets, solved side by side: soft joints as in `gauss_seidel`, both rows of a hinge at once."""

from __future__ import annotations

import math
from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Vector, absolute, load, select, store
from sandbox.engine.contact_solver.gather import PairPose, PairRows, gather_fields, scatter_fields
from sandbox.engine.contact_solver.law import Anchors, PairMass, PairVelocity, apply_impulse, relative_velocity
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


class Members(NamedTuple):
    """The bodies of the hinges of a block: their rows in the table of members, their velocities and poses, and what
    lies behind the velocities there."""

    rows: PairRows
    velocity: PairVelocity
    pose: PairPose
    start_cos_a: Vector
    start_cos_b: Vector


class Gap(NamedTuple):
    """The anchors of hinges: where their bodies are pushed, and from anchor a to anchor b, m."""

    anchors: Anchors
    x: Vector
    y: Vector


_VELOCITY, _DISPLACEMENT = 4, 12
"""Numbers of fields of the table of members: velocity_x and displacement_x, each before what belongs to it."""


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
            warm_start_hinge_blocks(h, work.members, first, end, far / seconds)
            first, end = next_part(workers, first, end)
        at = stop


@kernel
def warm_start_hinge_blocks(h: HingeLanes, members: Records, first: int, end: int, fastest: float) -> None:
    """The same for blocks of one colour, but at what turns faster than `fastest` rad/s."""
    for n in range(first, end):
        block = h.blocks[n]
        v = h.lanes[n * HINGE_BLOCK_SIZE : (n + 1) * HINGE_BLOCK_SIZE]
        of = _gather(members, h, block)
        spins = (absolute(of.velocity.aw) > fastest) | (absolute(of.velocity.bw) > fastest)
        x = select(spins, 0.0, load(v, hl.IMPULSE_X))
        y = select(spins, 0.0, load(v, hl.IMPULSE_Y))
        store(v, hl.IMPULSE_X, x)
        store(v, hl.IMPULSE_Y, y)
        anchors = _gap(v, of.pose).anchors
        _scatter(members, of, apply_impulse(of.velocity, _masses(v), anchors, x, y), block.count)


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
            sweep_hinge_blocks(h, work.members, first, end, soft)
            first, end = next_part(workers, first, end)
        done += stop - at


@kernel
def sweep_hinge_blocks(h: HingeLanes, members: Records, first: int, end: int, soft: SoftHinge) -> None:
    """The same for blocks of one colour."""
    for n in range(first, end):
        block = h.blocks[n]
        v = h.lanes[n * HINGE_BLOCK_SIZE : (n + 1) * HINGE_BLOCK_SIZE]
        of = _gather(members, h, block)
        _scatter(members, of, _swept(v, of, soft), block.count)


@kernel
def accumulate_hinges(work: JointWork, part: Records) -> None:
    """Add the impulses of a substep to those of the step."""
    lanes = work.side_by_side.lanes
    for n in range(part.first_block, part.block_end):
        v = lanes[n * HINGE_BLOCK_SIZE : (n + 1) * HINGE_BLOCK_SIZE]
        store(v, hl.TOTAL_X, load(v, hl.TOTAL_X) + load(v, hl.IMPULSE_X))
        store(v, hl.TOTAL_Y, load(v, hl.TOTAL_Y) + load(v, hl.IMPULSE_Y))


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


@inlined_kernel
def _gather(members: Records, h: HingeLanes, block: Records) -> Members:
    """The bodies of a block; lanes that are not used have those of the first one."""
    k0 = block.first
    k1 = k0 + 1 if block.count > 1 else k0
    k2 = k0 + 2 if block.count > 2 else k0
    k3 = k0 + 3 if block.count > 3 else k0
    rows = PairRows(
        (h.hinges[k0].member_a, h.hinges[k1].member_a, h.hinges[k2].member_a, h.hinges[k3].member_a),
        (h.hinges[k0].member_b, h.hinges[k1].member_b, h.hinges[k2].member_b, h.hinges[k3].member_b),
    )
    ax, ay, aw, start_cos_a = gather_fields(members, rows.a, _VELOCITY)
    bx, by, bw, start_cos_b = gather_fields(members, rows.b, _VELOCITY)
    from_x, from_y, cos_a, sin_a = gather_fields(members, rows.a, _DISPLACEMENT)
    to_x, to_y, cos_b, sin_b = gather_fields(members, rows.b, _DISPLACEMENT)
    pose = PairPose(to_x - from_x, to_y - from_y, cos_a, sin_a, cos_b, sin_b)
    return Members(rows, PairVelocity(ax, ay, aw, bx, by, bw), pose, start_cos_a, start_cos_b)


@inlined_kernel
def _scatter(members: Records, of: Members, v: PairVelocity, count: int) -> None:
    """Write the velocities of `count` hinges back to the rows they came from."""
    scatter_fields(members, of.rows.a, _VELOCITY, (v.ax, v.ay, v.aw, of.start_cos_a), 0, count)
    scatter_fields(members, of.rows.b, _VELOCITY, (v.bx, v.by, v.bw, of.start_cos_b), 0, count)


@inlined_kernel
def _masses(v: Floats) -> PairMass:
    return PairMass(
        load(v, hl.INVERSE_MASS_A),
        load(v, hl.INVERSE_INERTIA_A),
        load(v, hl.INVERSE_MASS_B),
        load(v, hl.INVERSE_INERTIA_B),
    )


@inlined_kernel
def _gap(v: Floats, pose: PairPose) -> Gap:
    """Both are pushed at b's anchor, unless that is further off than half of the longer arm; see `jacobian`."""
    anchor_ax = load(v, hl.ANCHOR_AX)
    anchor_ay = load(v, hl.ANCHOR_AY)
    anchor_bx = load(v, hl.ANCHOR_BX)
    anchor_by = load(v, hl.ANCHOR_BY)
    ax = pose.cos_a * anchor_ax - pose.sin_a * anchor_ay
    ay = pose.sin_a * anchor_ax + pose.cos_a * anchor_ay
    bx = pose.cos_b * anchor_bx - pose.sin_b * anchor_by
    by = pose.sin_b * anchor_bx + pose.cos_b * anchor_by
    gap_x = load(v, hl.CENTER_X) + pose.x + (bx - ax)
    gap_y = load(v, hl.CENTER_Y) + pose.y + (by - ay)
    arm_a = ax * ax + ay * ay
    arm_b = bx * bx + by * by
    close = gap_x * gap_x + gap_y * gap_y < 0.25 * select(arm_a > arm_b, arm_a, arm_b)
    return Gap(Anchors(ax + select(close, gap_x, 0.0), ay + select(close, gap_y, 0.0), bx, by), gap_x, gap_y)


@inlined_kernel
def _swept(v: Floats, of: Members, soft: SoftHinge) -> PairVelocity:
    """The velocities after a sweep over a block with lanes `v`, whose impulses it changes."""
    velocity = of.velocity
    gap = _gap(v, of.pose)
    r = gap.anchors
    store(v, hl.GAP_X, gap.x)
    store(v, hl.GAP_Y, gap.y)
    masses = _masses(v)
    ia = masses.inertia_a
    ib = masses.inertia_b
    mass = masses.mass_a + masses.mass_b
    xx = mass + ia * r.ay * r.ay + ib * r.by * r.by
    yy = mass + ia * r.ax * r.ax + ib * r.bx * r.bx
    xy = -(ia * r.ax * r.ay) - ib * r.bx * r.by
    share_x = _share(gap.x, soft.most)
    share_y = _share(gap.y, soft.most)
    give_x = soft.give * xx * share_x
    give_y = soft.give * yy * share_y
    impulse_x = load(v, hl.IMPULSE_X)
    impulse_y = load(v, hl.IMPULSE_Y)
    x, y = relative_velocity(velocity, r)
    x = x + soft.push * share_x * gap.x + give_x * impulse_x
    y = y + soft.push * share_y * gap.y + give_y * impulse_y
    soft_xx = xx + give_x
    soft_yy = yy + give_y
    determinant = soft_xx * soft_yy - xy * xy
    regular = determinant > 0.0
    inverse = select(regular, 1.0 / select(regular, determinant, 1.0), 0.0)
    change_x = -inverse * (soft_yy * x - xy * y)
    change_y = -inverse * (soft_xx * y - xy * x)
    store(v, hl.IMPULSE_X, impulse_x + change_x)
    store(v, hl.IMPULSE_Y, impulse_y + change_y)
    return apply_impulse(velocity, masses, r, change_x, change_y)


@inlined_kernel
def _share(gap: Vector, most: float) -> Vector:
    """What is left of a push that is cut to that of `most` m.

    The hinge grows stiffer by it, so that it gives way no further than the same spring would.
    """
    cut = absolute(gap) > most
    return select(cut, most / select(cut, absolute(gap), 1.0), 1.0)
