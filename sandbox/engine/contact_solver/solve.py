"""Stages: solve and relax contacts, block by block.

Sequential impulses with accumulated clamping (E. Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005);
soft contacts with a relax pass after the positions have moved (Box2D v3's soft step). Each block is gathered into
`gathered`, computed lane by lane, and scattered; see `blocks` for the layout.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.gather import gather_deltas, gather_velocities, scatter_velocities
from sandbox.engine.contact_solver.lanes import (
    is_solved_singly,
    lane_anchors,
    lane_mass,
    lane_velocity,
    set_lane_velocity,
)
from sandbox.engine.contact_solver.law import (
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
VECTOR = cb.VECTOR


@kernel
def solve_contacts(
    motions: Records, blocks: ContactBlocks, block_count: int, workers: Workers, soft: SoftContact
) -> None:
    """One pass over the first blocks of contacts: push apart, then friction, then rolling resistance."""
    tell_soft(workers.numbers, soft)
    for color in range(color_count(workers, blocks)):
        first, end = first_part_of_color(workers, SOLVE_CONTACTS, blocks, color, block_count)
        while first < end:
            solve_blocks(motions, blocks, first, end, workers.gathered, soft)
            first, end = next_part(workers, first, end)


@kernel
def solve_blocks(
    motions: Records, blocks: ContactBlocks, first: int, end: int, gathered: Floats, soft: SoftContact
) -> None:
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
            gather_deltas(motions, slots, slot, width, gathered)
            if singly:
                _solve_lane(v, gathered, 0, soft)
            else:
                for lane in range(0, width, VECTOR):
                    _solve_lanes(v[lane:], gathered[lane:], soft)
            if block.rolling == 1:
                _resist_rolling(v, gathered, width)
            scatter_velocities(motions, slots, slot, width, gathered)


@kernel
def _solve_lanes(v: Floats, g: Floats, soft: SoftContact) -> None:
    for k in range(VECTOR):
        _solve_lane(v, g, k, soft)


@inlined_kernel
def _solve_lane(v: Floats, g: Floats, k: int, soft: SoftContact) -> None:
    velocity = lane_velocity(g, k)
    mass = lane_mass(v, k)
    nx = v[cb.NORMAL_X + k]
    ny = v[cb.NORMAL_Y + k]
    r1 = lane_anchors(v, cb.POINT_1, k)
    r2 = lane_anchors(v, cb.POINT_2, k)
    before = PointImpulses(v[cb.POINT_1 + cb.NORMAL_IMPULSE + k], v[cb.POINT_2 + cb.NORMAL_IMPULSE + k])
    row1 = _normal_row(v, g, k, cb.POINT_1, velocity, soft)
    row2 = _normal_row(v, g, k, cb.POINT_2, velocity, soft)
    normal = solve_pair(row1, row2, v[cb.COUPLING + k], before, soft.over_relaxation)
    v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] = normal.first
    v[cb.POINT_2 + cb.NORMAL_IMPULSE + k] = normal.second
    change = PointImpulses(normal.first - before.first, normal.second - before.second)
    velocity = push_both(velocity, mass, r1, r2, change, nx, ny)
    r = bearing_anchors(r1, r2, normal.first, normal.second)
    vx, vy = relative_velocity(velocity, r)
    speed = vx * ny - vy * nx - v[cb.SURFACE_SPEED + k]
    rubbed = v[cb.TANGENT_IMPULSE + k]
    limit = v[cb.FRICTION + k] * (normal.first + normal.second)
    after = clamp_to_cone(rubbed - v[cb.TANGENT_MASS + k] * speed, limit)
    v[cb.TANGENT_IMPULSE + k] = after
    impulse = after - rubbed
    velocity = apply_impulse(velocity, mass, r, impulse * ny, -impulse * nx)
    set_lane_velocity(g, k, velocity)


@inlined_kernel
def _normal_row(v: Floats, g: Floats, k: int, point: int, velocity: PairVelocity, soft: SoftContact) -> NormalRow:
    """What point `POINT_1` or `POINT_2` of lane k asks for along the normal."""
    nx = v[cb.NORMAL_X + k]
    ny = v[cb.NORMAL_Y + k]
    r = lane_anchors(v, point, k)
    gap_x = g[cb.DELTA_X + k] + (g[cb.COS_B + k] * r.bx - g[cb.SIN_B + k] * r.by)
    gap_x = gap_x - (g[cb.COS_A + k] * r.ax - g[cb.SIN_A + k] * r.ay)
    gap_y = g[cb.DELTA_Y + k] + (g[cb.SIN_B + k] * r.bx + g[cb.COS_B + k] * r.by)
    gap_y = gap_y - (g[cb.SIN_A + k] * r.ax + g[cb.COS_A + k] * r.ay)
    rounding = v[cb.RADIUS_A + k] * g[cb.COS_A + k] + v[cb.RADIUS_B + k] * g[cb.COS_B + k]
    separation = gap_x * nx + gap_y * ny + rounding + v[point + cb.SEPARATION + k]
    overlaps = separation <= 0.0
    wanted = soft.bias_rate * separation
    saturated = wanted < soft.slowest_bias
    push = soft.slowest_bias if saturated else wanted
    ahead = separation * soft.inverse_seconds + v[cb.MAY_IMPACT + k] * soft.impact_allowance
    bias = push if overlaps else ahead
    scale = 1.0 - soft.softness if overlaps else 1.0
    # Where the push is saturated the contact grows stiffer, so that it sinks no deeper than the same spring would.
    softness = soft.softness * (push / wanted if saturated else 1.0)
    softness = softness if overlaps else 0.0
    vx, vy = relative_velocity(velocity, r)
    speed = vx * nx + vy * ny
    mass = v[point + cb.NORMAL_MASS + k] * scale
    before = v[point + cb.NORMAL_IMPULSE + k]
    return NormalRow(mass, before - mass * (speed + bias) - softness * before)


@kernel
def _resist_rolling(v: Floats, g: Floats, count: int) -> None:
    """Rolling resistance: a torque impulse against relative spin, bounded by lever arm times normal impulse.

    Contacts without it keep even the signs of their zeros: what shares a block must not matter.
    """
    for k in range(count):
        load = v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] + v[cb.POINT_2 + cb.NORMAL_IMPULSE + k]
        resists = v[cb.ROLLING_RESISTANCE + k] > 0.0
        limit = v[cb.ROLLING_RESISTANCE + k] * load
        before = v[cb.ROLLING_IMPULSE + k]
        spin_a = g[cb.ANGULAR_A + k]
        spin_b = g[cb.ANGULAR_B + k]
        after = clamp_to_cone(before - v[cb.ROLLING_MASS + k] * (spin_b - spin_a), limit)
        v[cb.ROLLING_IMPULSE + k] = after if resists else before
        g[cb.ANGULAR_A + k] = spin_a - v[cb.INVERSE_INERTIA_A + k] * (after - before) if resists else spin_a
        g[cb.ANGULAR_B + k] = spin_b + v[cb.INVERSE_INERTIA_B + k] * (after - before) if resists else spin_b
