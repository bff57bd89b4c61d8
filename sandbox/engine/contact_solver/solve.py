"""Stages: solve and relax contacts, block by block.

Sequential impulses with accumulated clamping (E. Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005);
soft contacts with a relax pass after the positions have moved (Box2D v3's soft step). The four contacts of a block are
solved side by side in vectors; see `blocks` for the layout.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Mask, Number, any_lane, load, select, spread, store
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.gather import (
    Gathered,
    PairPose,
    PairRows,
    gather_poses,
    gather_velocities,
    rows_of,
    scatter_velocities,
)
from sandbox.engine.contact_solver.lanes import (
    lanes_between,
    load_anchors,
    load_masses,
    load_normal_impulses,
    store_lanes,
)
from sandbox.engine.contact_solver.law import (
    Levers,
    PairMass,
    PairVelocity,
    PointImpulses,
    clamp_to_cone,
    coupling,
    levers_of,
    push_along,
    push_along_both,
    speed_of_centers,
    speed_of_turning,
)
from sandbox.engine.contact_solver.normal_pair import NormalRow, pushing, solve_pair
from sandbox.engine.contact_solver.soft_constraint import JOINTED_STIFFENS
from sandbox.engine.records.contact_blocks import ContactBlocks, SoftContact
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import color_count, first_part_of_color, next_part
from sandbox.engine.workers.task_kinds import SOLVE_AGAIN, SOLVE_CONTACTS, tell_soft
from sandbox.tables import Floats, Records

BLOCK_SIZE = cb.BLOCK_SIZE


class Push(NamedTuple):
    """What a point strives for along the normal: the velocity (m/s) that is added to the one it has, the share of the
    effective mass with which it does, and that of the impulse so far by which it gives way."""

    bias: Number
    scale: Number
    softness: Number


@kernel
def solve_contacts(
    motions: Records, blocks: ContactBlocks, first_block: int, end_block: int, workers: Workers, soft: SoftContact
) -> None:
    """One pass over some blocks of contacts: push apart, then friction, then rolling resistance."""
    tell_soft(workers.numbers, soft)
    for color in range(color_count(workers, blocks)):
        first, end = first_part_of_color(workers, SOLVE_CONTACTS, blocks, color, (first_block, end_block))
        while first < end:
            solve_blocks(motions, blocks, first, end, soft)
            first, end = next_part(workers, first, end)


@kernel
def solve_again(
    motions: Records, blocks: ContactBlocks, first_block: int, end_block: int, workers: Workers, soft: SoftContact
) -> None:
    """The same after a rigid pass over them since which no body has moved."""
    tell_soft(workers.numbers, soft)
    for color in range(color_count(workers, blocks)):
        first, end = first_part_of_color(workers, SOLVE_AGAIN, blocks, color, (first_block, end_block))
        while first < end:
            solve_blocks_again(motions, blocks, first, end, soft)
            first, end = next_part(workers, first, end)


@kernel
def solve_blocks(motions: Records, blocks: ContactBlocks, first: int, end: int, soft: SoftContact) -> None:
    """A pass over the blocks first..end-1. The lanes of a serial block are solved one by one."""
    for n in range(first, end):
        block = blocks.blocks[n]
        rows = rows_of(block)
        turns = block.count if block.serial == 1 else 1
        width = 1 if block.serial == 1 else block.count
        for turn in range(turns):
            v = blocks.lanes[n * BLOCK_SIZE :]
            lane = turn * width
            of = gather_velocities(motions, rows)
            pose = gather_poses(motions, rows, of)
            push1 = _push(block, v, pose, cb.POINT_1, soft)
            push2 = _push(block, v, pose, cb.POINT_2, soft) if block.single == 0 else push1
            if soft.keeps:
                store(v, cb.BIAS_1, push1.bias)
                store(v, cb.BIAS_2, push2.bias)
            _solve_lanes(motions, block, rows, of, v, (push1, push2), soft, lane, lane + width)


@kernel
def solve_blocks_again(motions: Records, blocks: ContactBlocks, first: int, end: int, soft: SoftContact) -> None:
    """The same after a rigid pass since which no body has moved."""
    for n in range(first, end):
        block = blocks.blocks[n]
        rows = rows_of(block)
        turns = block.count if block.serial == 1 else 1
        width = 1 if block.serial == 1 else block.count
        for turn in range(turns):
            v = blocks.lanes[n * BLOCK_SIZE :]
            lane = turn * width
            of = gather_velocities(motions, rows)
            push1 = Push(load(v, cb.BIAS_1), 1.0, 0.0)
            push2 = Push(load(v, cb.BIAS_2), 1.0, 0.0)
            _solve_lanes(motions, block, rows, of, v, (push1, push2), soft, lane, lane + width)


@inlined_kernel
def _solve_lanes(
    motions: Records,
    block: Records,
    rows: PairRows,
    of: Gathered,
    v: Floats,
    pushes: tuple[Push, Push],
    soft: SoftContact,
    first_lane: int,
    end_lane: int,
) -> None:
    """Solve the lanes first_lane..end_lane-1 of a block with lanes `v`: all are worked out, and those kept.

    What follows from velocities is a chain of operations that wait for each other, and takes most of the time: what
    does not depend on them is kept out of it.
    """
    lanes = lanes_between(first_lane, end_lane)
    velocity = of.velocity
    mass = load_masses(v)
    nx = load(v, cb.NORMAL_X)
    ny = load(v, cb.NORMAL_Y)
    r1 = load_anchors(v, cb.POINT_1)
    levers1 = levers_of(r1, nx, ny)
    before = load_normal_impulses(v)
    if soft.sums:
        total = load(v, cb.TOTAL_IMPULSE)
        store_lanes(v, cb.TOTAL_IMPULSE, lanes, total + (before.first + before.second), total)
    speed = speed_of_centers(velocity, nx, ny)
    row1 = _normal_row(v, cb.POINT_1, speed + speed_of_turning(velocity, levers1), before.first, pushes[0])
    if block.single == 1:
        normal = PointImpulses(pushing(row1.alone), before.second)
        store_lanes(v, cb.POINT_1 + cb.NORMAL_IMPULSE, lanes, normal.first, before.first)
        velocity = push_along(velocity, mass, levers1, normal.first - before.first, nx, ny)
    else:
        r2 = load_anchors(v, cb.POINT_2)
        levers2 = levers_of(r2, nx, ny)
        row2 = _normal_row(v, cb.POINT_2, speed + speed_of_turning(velocity, levers2), before.second, pushes[1])
        normal = solve_pair(row1, row2, coupling(mass, levers1, levers2), before, soft.over_relaxation)
        store_lanes(v, cb.POINT_1 + cb.NORMAL_IMPULSE, lanes, normal.first, before.first)
        store_lanes(v, cb.POINT_2 + cb.NORMAL_IMPULSE, lanes, normal.second, before.second)
        change = PointImpulses(normal.first - before.first, normal.second - before.second)
        velocity = push_along_both(velocity, mass, levers1, levers2, change, nx, ny)
    if block.frictional == 1:
        levers = Levers(load(v, cb.TANGENT_LEVER_A), load(v, cb.TANGENT_LEVER_B))
        speed = speed_of_centers(velocity, ny, -nx) + speed_of_turning(velocity, levers)
        if block.driven == 1:
            speed = speed - load(v, cb.SURFACE_SPEED)
        rubbed = load(v, cb.TANGENT_IMPULSE)
        limit = load(v, cb.FRICTION) * (normal.first + normal.second)
        after = clamp_to_cone(rubbed - load(v, cb.TANGENT_MASS) * speed, limit)
        store_lanes(v, cb.TANGENT_IMPULSE, lanes, after, rubbed)
        velocity = push_along(velocity, mass, levers, after - rubbed, ny, -nx)
    if block.rolling == 1:
        velocity = _resist_rolling(v, velocity, mass, normal, lanes)
    scatter_velocities(motions, rows, velocity, of, first_lane, end_lane)


@inlined_kernel
def _push(block: Records, v: Floats, pose: PairPose, point: int, soft: SoftContact) -> Push:
    """What `POINT_1` or `POINT_2` of the contacts of a block strive for at these poses."""
    nx = load(v, cb.NORMAL_X)
    ny = load(v, cb.NORMAL_Y)
    r = load_anchors(v, point)
    gap_x = pose.x + (pose.cos_b * r.bx - pose.sin_b * r.by) - (pose.cos_a * r.ax - pose.sin_a * r.ay)
    gap_y = pose.y + (pose.sin_b * r.bx + pose.cos_b * r.by) - (pose.sin_a * r.ax + pose.cos_a * r.ay)
    separation = gap_x * nx + gap_y * ny
    if block.rounded == 1:
        separation = separation + (load(v, cb.RADIUS_A) * pose.cos_a + load(v, cb.RADIUS_B) * pose.cos_b)
    separation = separation + load(v, point + cb.SEPARATION)
    overlaps = separation <= soft.touching
    wanted = soft.bias_rate * separation
    saturated = wanted < soft.slowest_bias
    push = select(saturated, soft.slowest_bias, wanted)
    ahead = separation * soft.inverse_seconds
    if block.strikes == 1:
        ahead = ahead + load(v, cb.MAY_IMPACT) * soft.impact_allowance
    bias = select(overlaps, push, ahead)
    stiffest = spread(0.0)
    softness = spread(soft.softness)
    if block.jointed == 1:
        jointed = load(v, cb.JOINTED)
        softness = select(jointed > 0.0, soft.softness_jointed, softness)
        stiffest = (1.0 / JOINTED_STIFFENS) * jointed
    scale = select(overlaps, 1.0 - softness, 1.0)
    softness = select(overlaps, softness, spread(0.0))
    if any_lane(saturated):
        # There the contact grows stiffer, so that it sinks no deeper than the same spring would; if joints hold its
        # bodies no further than so much, as they may press it for ever.
        less = push / select(saturated, wanted, 1.0)
        softness = select(saturated, softness * select(less > stiffest, less, stiffest), softness)
    return Push(bias, scale, softness)


@inlined_kernel
def _normal_row(v: Floats, point: int, speed: Number, before: Number, push: Push) -> NormalRow:
    """What `POINT_1` or `POINT_2` of the contacts of a block asks for along the normal; it opens at a `speed` (m/s)."""
    mass = load(v, point + cb.NORMAL_MASS) * push.scale
    return NormalRow(mass, (before - push.softness * before - mass * push.bias) - mass * speed)


@inlined_kernel
def _resist_rolling(
    v: Floats, velocity: PairVelocity, mass: PairMass, normal: PointImpulses, lanes: Mask
) -> PairVelocity:
    """Rolling resistance: a torque impulse against relative spin, bounded by lever arm times normal impulse.

    Contacts without it keep even the signs of their zeros: what shares a block must not matter.
    """
    resistance = load(v, cb.ROLLING_RESISTANCE)
    resists = resistance > 0.0
    before = load(v, cb.ROLLING_IMPULSE)
    spin = velocity.bw - velocity.aw
    limit = resistance * (normal.first + normal.second)
    after = clamp_to_cone(before - load(v, cb.ROLLING_MASS) * spin, limit)
    store(v, cb.ROLLING_IMPULSE, select(lanes & resists, after, before))
    return PairVelocity(
        velocity.ax,
        velocity.ay,
        select(resists, velocity.aw - mass.inertia_a * (after - before), velocity.aw),
        velocity.bx,
        velocity.by,
        select(resists, velocity.bw + mass.inertia_b * (after - before), velocity.bw),
    )
