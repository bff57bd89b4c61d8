"""Stages: solve and relax contacts, block by block.

Sequential impulses with accumulated clamping (E. Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005);
soft contacts with a relax pass after the positions have moved (Box2D v3's soft step). The four contacts of a block are
solved side by side in vectors; see `blocks` for the layout.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import Mask, load, select, store
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.gather import (
    PairPose,
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
    PairMass,
    PairVelocity,
    PointImpulses,
    apply_impulse,
    bearing_anchors,
    clamp_to_cone,
    push_both,
    relative_velocity,
)
from sandbox.engine.contact_solver.normal_pair import NormalRow, solve_pair
from sandbox.engine.records.contact_blocks import ContactBlocks, SoftContact
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import color_count, first_part_of_color, next_part
from sandbox.engine.workers.task_kinds import SOLVE_CONTACTS, tell_soft
from sandbox.tables import Floats, Records

BLOCK_SIZE = cb.BLOCK_SIZE


@kernel
def solve_contacts(
    motions: Records, blocks: ContactBlocks, block_count: int, workers: Workers, soft: SoftContact
) -> None:
    """One pass over the first blocks of contacts: push apart, then friction, then rolling resistance."""
    tell_soft(workers.numbers, soft)
    for color in range(color_count(workers, blocks)):
        first, end = first_part_of_color(workers, SOLVE_CONTACTS, blocks, color, block_count)
        while first < end:
            solve_blocks(motions, blocks, first, end, soft)
            first, end = next_part(workers, first, end)


@kernel
def solve_blocks(motions: Records, blocks: ContactBlocks, first: int, end: int, soft: SoftContact) -> None:
    """The same for the blocks first..end-1. The lanes of a serial block are solved one by one."""
    for n in range(first, end):
        block = blocks.blocks[n]
        width = 1 if block.serial == 1 else block.count
        for lane in range(0, block.count, width):
            _solve_lanes(motions, blocks.slots, block, blocks.lanes[n * BLOCK_SIZE :], lane, lane + width, soft)


@inlined_kernel
def _solve_lanes(
    motions: Records, slots: Records, block: Records, v: Floats, first_lane: int, end_lane: int, soft: SoftContact
) -> None:
    """Solve the lanes first_lane..end_lane-1 of a block with lanes `v`: all are worked out, and those kept."""
    rows = rows_of(slots, block.first, block.count)
    gathered = gather_velocities(motions, rows)
    pose = gather_poses(motions, rows, gathered)
    lanes = lanes_between(first_lane, end_lane)
    velocity = gathered.velocity
    mass = load_masses(v)
    nx = load(v, cb.NORMAL_X)
    ny = load(v, cb.NORMAL_Y)
    r1 = load_anchors(v, cb.POINT_1)
    r2 = load_anchors(v, cb.POINT_2)
    before = load_normal_impulses(v)
    row1 = _normal_row(v, pose, cb.POINT_1, velocity, soft)
    row2 = _normal_row(v, pose, cb.POINT_2, velocity, soft)
    normal = solve_pair(row1, row2, load(v, cb.COUPLING), before, soft.over_relaxation)
    store_lanes(v, cb.POINT_1 + cb.NORMAL_IMPULSE, lanes, normal.first, before.first)
    store_lanes(v, cb.POINT_2 + cb.NORMAL_IMPULSE, lanes, normal.second, before.second)
    change = PointImpulses(normal.first - before.first, normal.second - before.second)
    velocity = push_both(velocity, mass, r1, r2, change, nx, ny)
    r = bearing_anchors(r1, r2, normal.first, normal.second)
    vx, vy = relative_velocity(velocity, r)
    speed = vx * ny - vy * nx - load(v, cb.SURFACE_SPEED)
    rubbed = load(v, cb.TANGENT_IMPULSE)
    limit = load(v, cb.FRICTION) * (normal.first + normal.second)
    after = clamp_to_cone(rubbed - load(v, cb.TANGENT_MASS) * speed, limit)
    store_lanes(v, cb.TANGENT_IMPULSE, lanes, after, rubbed)
    impulse = after - rubbed
    velocity = apply_impulse(velocity, mass, r, impulse * ny, -impulse * nx)
    if block.rolling == 1:
        velocity = _resist_rolling(v, velocity, mass, normal, lanes)
    scatter_velocities(motions, rows, velocity, gathered, first_lane, end_lane)


@inlined_kernel
def _normal_row(v: Floats, pose: PairPose, point: int, velocity: PairVelocity, soft: SoftContact) -> NormalRow:
    """What `POINT_1` or `POINT_2` of the contacts of a block ask for along the normal."""
    nx = load(v, cb.NORMAL_X)
    ny = load(v, cb.NORMAL_Y)
    r = load_anchors(v, point)
    gap_x = pose.x + (pose.cos_b * r.bx - pose.sin_b * r.by) - (pose.cos_a * r.ax - pose.sin_a * r.ay)
    gap_y = pose.y + (pose.sin_b * r.bx + pose.cos_b * r.by) - (pose.sin_a * r.ax + pose.cos_a * r.ay)
    rounding = load(v, cb.RADIUS_A) * pose.cos_a + load(v, cb.RADIUS_B) * pose.cos_b
    separation = gap_x * nx + gap_y * ny + rounding + load(v, point + cb.SEPARATION)
    overlaps = separation <= 0.0
    wanted = soft.bias_rate * separation
    saturated = wanted < soft.slowest_bias
    push = select(saturated, soft.slowest_bias, wanted)
    ahead = separation * soft.inverse_seconds + load(v, cb.MAY_IMPACT) * soft.impact_allowance
    bias = select(overlaps, push, ahead)
    scale = select(overlaps, 1.0 - soft.softness, 1.0)
    # Where the push is saturated the contact grows stiffer, so that it sinks no deeper than the same spring would.
    softness = soft.softness * select(saturated, push / select(saturated, wanted, 1.0), 1.0)
    softness = select(overlaps, softness, 0.0)
    vx, vy = relative_velocity(velocity, r)
    speed = vx * nx + vy * ny
    mass = load(v, point + cb.NORMAL_MASS) * scale
    before = load(v, point + cb.NORMAL_IMPULSE)
    return NormalRow(mass, before - mass * (speed + bias) - softness * before)


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
