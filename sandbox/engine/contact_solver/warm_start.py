"""Stage: warm starting. Every substep begins with the impulses accumulated so far, its best guess.

E. Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.gather import gather_velocities, scatter_velocities
from sandbox.engine.contact_solver.lanes import (
    is_solved_singly,
    lane_anchors,
    lane_mass,
    lane_velocity,
    set_lane_velocity,
)
from sandbox.engine.contact_solver.law import PairVelocity, PointImpulses, apply_impulse, bearing_anchors, push_both
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import color_count, first_part_of_color, next_part
from sandbox.engine.workers.task_kinds import WARM_START
from sandbox.tables import Floats, Records

BLOCK_SIZE = cb.BLOCK_SIZE
VECTOR = cb.VECTOR


@kernel
def warm_start(motions: Records, blocks: ContactBlocks, block_count: int, workers: Workers) -> None:
    """Apply the accumulated impulses of the first blocks of contacts."""
    for color in range(color_count(workers, blocks)):
        first, end = first_part_of_color(workers, WARM_START, blocks, color, block_count)
        while first < end:
            warm_start_blocks(motions, blocks, first, end, workers.gathered)
            first, end = next_part(workers, first, end)


@kernel
def warm_start_blocks(motions: Records, blocks: ContactBlocks, first: int, end: int, gathered: Floats) -> None:
    """The same for the blocks first..end-1. `gathered` is scratch."""
    slots = blocks.slots
    for n in range(first, end):
        block = blocks.blocks[n]
        singly = is_solved_singly(block)
        turns = block.count if singly else 1
        width = 1 if singly else block.count
        for turn in range(turns):
            v = blocks.lanes[n * BLOCK_SIZE + turn : (n + 1) * BLOCK_SIZE]
            slot = block.first + turn
            gather_velocities(motions, slots, slot, width, gathered)
            if singly:
                _warm_start_lane(v, gathered, 0)
            else:
                for lane in range(0, width, VECTOR):
                    _warm_start_lanes(v[lane:], gathered[lane:])
            scatter_velocities(motions, slots, slot, width, gathered)


@kernel
def _warm_start_lanes(v: Floats, g: Floats) -> None:
    for k in range(VECTOR):
        _warm_start_lane(v, g, k)


@inlined_kernel
def _warm_start_lane(v: Floats, g: Floats, k: int) -> None:
    nx = v[cb.NORMAL_X + k]
    ny = v[cb.NORMAL_Y + k]
    mass = lane_mass(v, k)
    before = lane_velocity(g, k)
    aw = before.aw - mass.inertia_a * v[cb.ROLLING_IMPULSE + k]
    bw = before.bw + mass.inertia_b * v[cb.ROLLING_IMPULSE + k]
    velocity = PairVelocity(before.ax, before.ay, aw, before.bx, before.by, bw)
    v[cb.TOTAL_IMPULSE + k] += v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] + v[cb.POINT_2 + cb.NORMAL_IMPULSE + k]
    normal1 = v[cb.POINT_1 + cb.NORMAL_IMPULSE + k]
    normal2 = v[cb.POINT_2 + cb.NORMAL_IMPULSE + k]
    tangent = v[cb.TANGENT_IMPULSE + k]
    r1 = lane_anchors(v, cb.POINT_1, k)
    r2 = lane_anchors(v, cb.POINT_2, k)
    velocity = push_both(velocity, mass, r1, r2, PointImpulses(normal1, normal2), nx, ny)
    velocity = apply_impulse(velocity, mass, bearing_anchors(r1, r2, normal1, normal2), tangent * ny, -tangent * nx)
    set_lane_velocity(g, k, velocity)


@kernel
def forget_impulses(blocks: ContactBlocks, block_count: int) -> None:
    """Begin with no impulses; those of now are added to what has been given in the step so far."""
    for n in range(block_count):
        block = blocks.blocks[n]
        for k in range(block.count):
            v = blocks.lanes[n * BLOCK_SIZE + k : (n + 1) * BLOCK_SIZE]
            v[cb.TOTAL_IMPULSE] += v[cb.POINT_1 + cb.NORMAL_IMPULSE] + v[cb.POINT_2 + cb.NORMAL_IMPULSE]
            v[cb.ROLLING_IMPULSE] = 0.0
            v[cb.TANGENT_IMPULSE] = 0.0
            v[cb.POINT_1 + cb.NORMAL_IMPULSE] = 0.0
            v[cb.POINT_2 + cb.NORMAL_IMPULSE] = 0.0
