"""Stages: solve and relax contacts, block by block.

Sequential impulses with accumulated clamping (E. Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005);
soft contacts with a relax pass after the positions have moved (Box2D v3's soft step). Each block is gathered into
`gathered`, computed lane by lane, and scattered; see `blocks` for the layout.
"""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.contact_solver import blocks as cb
from sandbox.engine.contact_solver.gather import gather_deltas, gather_velocities, scatter_velocities
from sandbox.engine.contact_solver.lanes import lane_anchors, lane_mass, lane_velocity, set_lane_velocity
from sandbox.engine.contact_solver.law import apply_impulse, clamp_to_cone, relative_velocity
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
        turns = block.count if block.serial == 1 else 1
        width = 1 if block.serial == 1 else block.count
        for turn in range(turns):
            v = blocks.lanes[n * BLOCK_SIZE + turn : (n + 1) * BLOCK_SIZE]
            slot = block.first + turn
            gather_velocities(motions, slots, slot, width, gathered)
            gather_deltas(motions, slots, slot, width, gathered)
            if block.serial == 1:
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
    rounding = v[cb.RADIUS_A + k] * g[cb.COS_A + k] + v[cb.RADIUS_B + k] * g[cb.COS_B + k]
    for point in (cb.POINT_1, cb.POINT_2):
        r = lane_anchors(v, point, k)
        gap_x = g[cb.DELTA_X + k] + (g[cb.COS_B + k] * r.bx - g[cb.SIN_B + k] * r.by)
        gap_x = gap_x - (g[cb.COS_A + k] * r.ax - g[cb.SIN_A + k] * r.ay)
        gap_y = g[cb.DELTA_Y + k] + (g[cb.SIN_B + k] * r.bx + g[cb.COS_B + k] * r.by)
        gap_y = gap_y - (g[cb.SIN_A + k] * r.ax + g[cb.COS_A + k] * r.ay)
        separation = gap_x * nx + gap_y * ny + rounding + v[point + cb.SEPARATION + k]
        overlaps = separation <= 0.0
        wanted = soft.bias_rate * separation
        saturated = wanted < soft.slowest_bias
        push = soft.slowest_bias if saturated else wanted
        ahead = separation * soft.inverse_seconds + v[cb.MAY_IMPACT + k] * soft.impact_allowance
        bias = push if overlaps else ahead
        scale = soft.mass_scale if overlaps else 1.0
        # Where the push is saturated the contact grows stiffer, so that it sinks no deeper than the same spring would.
        softness = soft.impulse_scale * (push / wanted if saturated else 1.0)
        softness = softness if overlaps else 0.0
        vx, vy = relative_velocity(velocity, r)
        speed = vx * nx + vy * ny
        before = v[point + cb.NORMAL_IMPULSE + k]
        after = before - v[point + cb.NORMAL_MASS + k] * scale * (speed + bias) - softness * before
        after = after if after > 0.0 else 0.0
        v[point + cb.NORMAL_IMPULSE + k] = after
        impulse = after - before
        velocity = apply_impulse(velocity, mass, r, impulse * nx, impulse * ny)
    for point in (cb.POINT_1, cb.POINT_2):
        r = lane_anchors(v, point, k)
        vx, vy = relative_velocity(velocity, r)
        speed = vx * ny - vy * nx - v[cb.SURFACE_SPEED + k]
        before = v[point + cb.TANGENT_IMPULSE + k]
        limit = v[cb.FRICTION + k] * v[point + cb.NORMAL_IMPULSE + k]
        after = clamp_to_cone(before - v[point + cb.TANGENT_MASS + k] * speed, limit)
        v[point + cb.TANGENT_IMPULSE + k] = after
        impulse = after - before
        velocity = apply_impulse(velocity, mass, r, impulse * ny, -impulse * nx)
    set_lane_velocity(g, k, velocity)


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
