"""Stage: warm starting. Every substep begins with the impulses accumulated so far, its best guess.

E. Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import load, select
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.gather import gather_velocities, rows_of, scatter_velocities
from sandbox.engine.contact_solver.lanes import (
    lanes_between,
    load_anchors,
    load_masses,
    load_normal_impulses,
    store_lanes,
)
from sandbox.engine.contact_solver.law import Levers, PairMass, PairVelocity, push_along, push_both
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import color_count, first_part_of_color, next_part
from sandbox.engine.workers.task_kinds import WARM_START
from sandbox.tables import Floats, Records

BLOCK_SIZE = cb.BLOCK_SIZE


@kernel
def warm_start(motions: Records, blocks: ContactBlocks, block_count: int, workers: Workers) -> None:
    """Apply the accumulated impulses of the first blocks of contacts."""
    for color in range(color_count(workers, blocks)):
        first, end = first_part_of_color(workers, WARM_START, blocks, color, (0, block_count))
        while first < end:
            warm_start_blocks(motions, blocks, first, end)
            first, end = next_part(workers, first, end)


@kernel
def warm_start_blocks(motions: Records, blocks: ContactBlocks, first: int, end: int) -> None:
    """The same for the blocks first..end-1."""
    for n in range(first, end):
        block = blocks.blocks[n]
        width = 1 if block.serial == 1 else block.count
        for lane in range(0, block.count, width):
            _warm_start_lanes(motions, block, blocks.lanes[n * BLOCK_SIZE :], lane, lane + width)


@inlined_kernel
def _warm_start_lanes(motions: Records, block: Records, v: Floats, first_lane: int, end_lane: int) -> None:
    """Apply the impulses of the lanes first_lane..end_lane-1 of a block with lanes `v`."""
    rows = rows_of(block)
    gathered = gather_velocities(motions, rows)
    before = gathered.velocity
    nx = load(v, cb.NORMAL_X)
    ny = load(v, cb.NORMAL_Y)
    mass = load_masses(v)
    velocity = _roll(v, before, mass) if block.rolling == 1 else before
    normal = load_normal_impulses(v)
    total = load(v, cb.TOTAL_IMPULSE)
    lanes = lanes_between(first_lane, end_lane)
    store_lanes(v, cb.TOTAL_IMPULSE, lanes, total + (normal.first + normal.second), total)
    r1 = load_anchors(v, cb.POINT_1)
    r2 = load_anchors(v, cb.POINT_2)
    velocity = push_both(velocity, mass, r1, r2, normal, nx, ny)
    if block.frictional == 1:
        tangent_levers = Levers(load(v, cb.TANGENT_LEVER_A), load(v, cb.TANGENT_LEVER_B))
        velocity = push_along(velocity, mass, tangent_levers, load(v, cb.TANGENT_IMPULSE), ny, -nx)
    scatter_velocities(motions, rows, velocity, gathered, first_lane, end_lane)


@inlined_kernel
def _roll(v: Floats, velocity: PairVelocity, mass: PairMass) -> PairVelocity:
    """The velocities after the impulses of rolling resistance; contacts without keep even the signs of their zeros."""
    impulse = load(v, cb.ROLLING_IMPULSE)
    rolls = impulse != 0.0
    return PairVelocity(
        velocity.ax,
        velocity.ay,
        select(rolls, velocity.aw - mass.inertia_a * impulse, velocity.aw),
        velocity.bx,
        velocity.by,
        select(rolls, velocity.bw + mass.inertia_b * impulse, velocity.bw),
    )


@kernel
def forget_impulses(blocks: ContactBlocks, first: int, end: int) -> None:
    """Let the blocks first..end-1 begin with no impulses; those of now are added to what the step has given so far."""
    for n in range(first, end):
        block = blocks.blocks[n]
        for k in range(block.count):
            v = blocks.lanes[n * BLOCK_SIZE + k : (n + 1) * BLOCK_SIZE]
            v[cb.TOTAL_IMPULSE] += v[cb.POINT_1 + cb.NORMAL_IMPULSE] + v[cb.POINT_2 + cb.NORMAL_IMPULSE]
            if block.rolling == 1:
                v[cb.ROLLING_IMPULSE] = 0.0
            v[cb.TANGENT_IMPULSE] = 0.0
            v[cb.POINT_1 + cb.NORMAL_IMPULSE] = 0.0
            v[cb.POINT_2 + cb.NORMAL_IMPULSE] = 0.0
