"""Stages: warm start, solve and relax contacts, block by block.

Sequential impulses with accumulated clamping (E. Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005);
soft contacts with a relax pass after the positions have moved (Box2D v3's soft step). Each block is gathered into
`gathered`, computed lane by lane, and scattered; see `contact_blocks` for the layout.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.contact_solver import blocks as cb
from sandbox.tables import Floats, Records

BLOCK_SIZE = cb.BLOCK_SIZE
VECTOR = cb.VECTOR


@kernel
def warm_start(
    motions: Records, slots: Records, blocks: Records, block_count: int, lanes: Floats, gathered: Floats
) -> None:
    """Apply the impulses accumulated so far: the best guess of what this substep needs."""
    for n in range(block_count):
        block = blocks[n]
        turns = block.count if block.stride > 1 else 1
        width = 1 if block.stride > 1 else block.count
        for turn in range(turns):
            v = lanes[n * BLOCK_SIZE + turn * VECTOR : (n + 1) * BLOCK_SIZE]
            slot = block.first + turn
            _gather_velocities(motions, slots, slot, width, gathered)
            for first in range(0, width, VECTOR):
                _warm_start_lanes(v[first:], gathered[first:])
            _scatter(motions, slots, slot, width, gathered)


@kernel
def solve_contacts(
    motions: Records,
    slots: Records,
    blocks: Records,
    block_count: int,
    lanes: Floats,
    gathered: Floats,
    inverse_seconds: float,
    bias_rate: float,
    mass_scale: float,
    impulse_scale: float,
    slowest_bias: float,
    bounce_allowance: float,
) -> None:
    """One pass over all contacts: push apart, then rub, then brake rolling.

    `slowest_bias` (m/s, negative or zero) bounds the velocity that pushes overlapping bodies apart; zero makes this
    a relax pass, which removes the velocity that the push has added. `bounce_allowance` (m/s) is added to the speed
    at which bouncy contacts may close while they are apart.
    """
    for n in range(block_count):
        block = blocks[n]
        turns = block.count if block.stride > 1 else 1
        width = 1 if block.stride > 1 else block.count
        for turn in range(turns):
            v = lanes[n * BLOCK_SIZE + turn * VECTOR : (n + 1) * BLOCK_SIZE]
            slot = block.first + turn
            _gather_velocities(motions, slots, slot, width, gathered)
            _gather_deltas(motions, slots, slot, width, gathered)
            for first in range(0, width, VECTOR):
                _solve_lanes(
                    v[first:],
                    gathered[first:],
                    inverse_seconds,
                    bias_rate,
                    mass_scale,
                    impulse_scale,
                    slowest_bias,
                    bounce_allowance,
                )
            if block.rolling == 1:
                _brake_rolling(v, gathered, width)
            _scatter(motions, slots, slot, width, gathered)


@kernel
def _gather_velocities(motions: Records, slots: Records, slot: int, count: int, g: Floats) -> None:
    for k in range(count):
        a = motions[slots[slot + k].body_a]
        b = motions[slots[slot + k].body_b]
        g[cb.VELOCITY_AX + k] = a.velocity_x
        g[cb.VELOCITY_AY + k] = a.velocity_y
        g[cb.ANGULAR_A + k] = a.angular_velocity
        g[cb.VELOCITY_BX + k] = b.velocity_x
        g[cb.VELOCITY_BY + k] = b.velocity_y
        g[cb.ANGULAR_B + k] = b.angular_velocity


@kernel
def _gather_deltas(motions: Records, slots: Records, slot: int, count: int, g: Floats) -> None:
    for k in range(count):
        a = motions[slots[slot + k].body_a]
        b = motions[slots[slot + k].body_b]
        g[cb.DELTA_X + k] = b.delta_x - a.delta_x
        g[cb.DELTA_Y + k] = b.delta_y - a.delta_y
        g[cb.COS_A + k] = a.delta_cos
        g[cb.SIN_A + k] = a.delta_sin
        g[cb.COS_B + k] = b.delta_cos
        g[cb.SIN_B + k] = b.delta_sin


@kernel
def _scatter(motions: Records, slots: Records, slot: int, count: int, g: Floats) -> None:
    for k in range(count):
        a = motions[slots[slot + k].body_a]
        b = motions[slots[slot + k].body_b]
        a.velocity_x = g[cb.VELOCITY_AX + k]
        a.velocity_y = g[cb.VELOCITY_AY + k]
        a.angular_velocity = g[cb.ANGULAR_A + k]
        b.velocity_x = g[cb.VELOCITY_BX + k]
        b.velocity_y = g[cb.VELOCITY_BY + k]
        b.angular_velocity = g[cb.ANGULAR_B + k]


@kernel
def _warm_start_lanes(v: Floats, g: Floats) -> None:
    for k in range(VECTOR):
        nx = v[cb.NORMAL_X + k]
        ny = v[cb.NORMAL_Y + k]
        ax = g[cb.VELOCITY_AX + k]
        ay = g[cb.VELOCITY_AY + k]
        aw = g[cb.ANGULAR_A + k] - v[cb.INVERSE_INERTIA_A + k] * v[cb.ROLLING_IMPULSE + k]
        bx = g[cb.VELOCITY_BX + k]
        by = g[cb.VELOCITY_BY + k]
        bw = g[cb.ANGULAR_B + k] + v[cb.INVERSE_INERTIA_B + k] * v[cb.ROLLING_IMPULSE + k]
        v[cb.TOTAL_IMPULSE + k] += v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] + v[cb.POINT_2 + cb.NORMAL_IMPULSE + k]
        for point in (cb.POINT_1, cb.POINT_2):
            normal = v[point + cb.NORMAL_IMPULSE + k]
            tangent = v[point + cb.TANGENT_IMPULSE + k]
            px = normal * nx + tangent * ny
            py = normal * ny - tangent * nx
            ax = ax - v[cb.INVERSE_MASS_A + k] * px
            ay = ay - v[cb.INVERSE_MASS_A + k] * py
            turn_a = v[point + cb.ANCHOR_AX + k] * py - v[point + cb.ANCHOR_AY + k] * px
            aw = aw - v[cb.INVERSE_INERTIA_A + k] * turn_a
            bx = bx + v[cb.INVERSE_MASS_B + k] * px
            by = by + v[cb.INVERSE_MASS_B + k] * py
            turn_b = v[point + cb.ANCHOR_BX + k] * py - v[point + cb.ANCHOR_BY + k] * px
            bw = bw + v[cb.INVERSE_INERTIA_B + k] * turn_b
        g[cb.VELOCITY_AX + k] = ax
        g[cb.VELOCITY_AY + k] = ay
        g[cb.ANGULAR_A + k] = aw
        g[cb.VELOCITY_BX + k] = bx
        g[cb.VELOCITY_BY + k] = by
        g[cb.ANGULAR_B + k] = bw


@kernel
def _solve_lanes(
    v: Floats,
    g: Floats,
    inverse_seconds: float,
    bias_rate: float,
    mass_scale: float,
    impulse_scale: float,
    slowest_bias: float,
    bounce_allowance: float,
) -> None:
    for k in range(VECTOR):
        ax = g[cb.VELOCITY_AX + k]
        ay = g[cb.VELOCITY_AY + k]
        aw = g[cb.ANGULAR_A + k]
        bx = g[cb.VELOCITY_BX + k]
        by = g[cb.VELOCITY_BY + k]
        bw = g[cb.ANGULAR_B + k]
        nx = v[cb.NORMAL_X + k]
        ny = v[cb.NORMAL_Y + k]
        mass_a = v[cb.INVERSE_MASS_A + k]
        mass_b = v[cb.INVERSE_MASS_B + k]
        inertia_a = v[cb.INVERSE_INERTIA_A + k]
        inertia_b = v[cb.INVERSE_INERTIA_B + k]
        rounding = v[cb.RADIUS_A + k] * g[cb.COS_A + k] + v[cb.RADIUS_B + k] * g[cb.COS_B + k]
        for point in (cb.POINT_1, cb.POINT_2):
            rax = v[point + cb.ANCHOR_AX + k]
            ray = v[point + cb.ANCHOR_AY + k]
            rbx = v[point + cb.ANCHOR_BX + k]
            rby = v[point + cb.ANCHOR_BY + k]
            gap_x = g[cb.DELTA_X + k] + (g[cb.COS_B + k] * rbx - g[cb.SIN_B + k] * rby)
            gap_x = gap_x - (g[cb.COS_A + k] * rax - g[cb.SIN_A + k] * ray)
            gap_y = g[cb.DELTA_Y + k] + (g[cb.SIN_B + k] * rbx + g[cb.COS_B + k] * rby)
            gap_y = gap_y - (g[cb.SIN_A + k] * rax + g[cb.COS_A + k] * ray)
            separation = gap_x * nx + gap_y * ny + rounding + v[point + cb.SEPARATION + k]
            overlaps = separation <= 0.0
            push = bias_rate * separation
            push = push if push > slowest_bias else slowest_bias
            ahead = separation * inverse_seconds + v[cb.BOUNCY + k] * bounce_allowance
            bias = push if overlaps else ahead
            scale = mass_scale if overlaps else 1.0
            softness = impulse_scale if overlaps else 0.0
            vx = bx - bw * rby - ax + aw * ray
            vy = by + bw * rbx - ay - aw * rax
            speed = vx * nx + vy * ny
            before = v[point + cb.NORMAL_IMPULSE + k]
            after = before - v[point + cb.NORMAL_MASS + k] * scale * (speed + bias) - softness * before
            after = after if after > 0.0 else 0.0
            v[point + cb.NORMAL_IMPULSE + k] = after
            impulse = after - before
            px = impulse * nx
            py = impulse * ny
            ax = ax - mass_a * px
            ay = ay - mass_a * py
            aw = aw - inertia_a * (rax * py - ray * px)
            bx = bx + mass_b * px
            by = by + mass_b * py
            bw = bw + inertia_b * (rbx * py - rby * px)
        for point in (cb.POINT_1, cb.POINT_2):
            rax = v[point + cb.ANCHOR_AX + k]
            ray = v[point + cb.ANCHOR_AY + k]
            rbx = v[point + cb.ANCHOR_BX + k]
            rby = v[point + cb.ANCHOR_BY + k]
            vx = bx - bw * rby - ax + aw * ray
            vy = by + bw * rbx - ay - aw * rax
            speed = vx * ny - vy * nx - v[cb.SURFACE_SPEED + k]
            before = v[point + cb.TANGENT_IMPULSE + k]
            limit = v[cb.FRICTION + k] * v[point + cb.NORMAL_IMPULSE + k]
            after = before - v[point + cb.TANGENT_MASS + k] * speed
            after = after if after < limit else limit
            after = after if after > -limit else -limit
            v[point + cb.TANGENT_IMPULSE + k] = after
            impulse = after - before
            px = impulse * ny
            py = -impulse * nx
            ax = ax - mass_a * px
            ay = ay - mass_a * py
            aw = aw - inertia_a * (rax * py - ray * px)
            bx = bx + mass_b * px
            by = by + mass_b * py
            bw = bw + inertia_b * (rbx * py - rby * px)
        g[cb.VELOCITY_AX + k] = ax
        g[cb.VELOCITY_AY + k] = ay
        g[cb.ANGULAR_A + k] = aw
        g[cb.VELOCITY_BX + k] = bx
        g[cb.VELOCITY_BY + k] = by
        g[cb.ANGULAR_B + k] = bw


@kernel
def _brake_rolling(v: Floats, g: Floats, count: int) -> None:
    """Rolling resistance: a torque impulse against relative spin, bounded by lever arm times normal impulse."""
    for k in range(count):
        load = v[cb.POINT_1 + cb.NORMAL_IMPULSE + k] + v[cb.POINT_2 + cb.NORMAL_IMPULSE + k]
        limit = v[cb.ROLLING_RESISTANCE + k] * load
        before = v[cb.ROLLING_IMPULSE + k]
        after = before - v[cb.ROLLING_MASS + k] * (g[cb.ANGULAR_B + k] - g[cb.ANGULAR_A + k])
        after = after if after < limit else limit
        after = after if after > -limit else -limit
        v[cb.ROLLING_IMPULSE + k] = after
        g[cb.ANGULAR_A + k] = g[cb.ANGULAR_A + k] - v[cb.INVERSE_INERTIA_A + k] * (after - before)
        g[cb.ANGULAR_B + k] = g[cb.ANGULAR_B + k] + v[cb.INVERSE_INERTIA_B + k] * (after - before)
