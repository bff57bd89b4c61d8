"""Stage: turn every shape into world axes, bound it, and lay side by side what its pairs will ask of it."""

from __future__ import annotations

import math

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.broad_phase.margins import shape_margin
from sandbox.engine.records.colliders import Colliders, Grid
from sandbox.engine.records.state import StateTables
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import ANEW, BOUND_SHAPES
from sandbox.geometry.bounds import core_bounds
from sandbox.geometry.core import core_of
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC, STATIC

# Bits of a proxy's `traits`, next to the `SEAMED` and `ONE_WAY` of its shape, so that a pair can be judged by one `or`.
ACTIVE = 4
"""The solver moves its body."""
SLEEPS = 8
"""Its body is dynamic and asleep."""
DRIVEN = 16
"""Its body is static or kinematic and moves, or has just been put somewhere."""
FIXED = 32
"""Its body is static."""
BULLET = 64
"""Its body does not pass through moving bodies either."""
MAY_STOP = 128
"""Something may stop its body during the step: what is immovable, or what it runs into."""
SLANTING = 256
"""It is static and slender and lies aslant, so that its box says little of where it is."""
_LOOSE = 4.0
"""The sides of the box of what lies aslant are more than so many times half its width."""


@inlined_kernel
def turn_core(body: Records, shape: Records, vertices: Records, turned: Records) -> None:
    """Turn the core of a shape into world axes; it stays measured from its body's centre of mass."""
    c = body.rotation_cos
    s = body.rotation_sin
    for j in range(shape.vertex_start, shape.vertex_start + shape.vertex_count):
        source = vertices[j]
        target = turned[j]
        target.x = c * source.x - s * source.y
        target.y = s * source.x + c * source.y
        target.normal_x = c * source.normal_x - s * source.normal_y
        target.normal_y = s * source.normal_x + c * source.normal_y


@kernel
def _how_it_moves(body: Records) -> int:
    """`ACTIVE`, `SLEEPS`, `DRIVEN`, or 0 for a body that stays where it is."""
    if body.type == DYNAMIC:
        return ACTIVE if body.awake == 1 else SLEEPS
    moves = body.velocity_x != 0.0 or body.velocity_y != 0.0 or body.angular_velocity != 0.0
    return DRIVEN if moves or body.posed == 1 else 0


@kernel
def bound_shapes(
    state: StateTables, rows: Integers, anew: bool, colliders: Colliders, grid: Grid, workers: Workers
) -> None:
    """Turn the cores of the first shapes of `active.shapes` and bound them: core, radius, margin, and the displacement
    of a step. `grid.outgrown` tells who has left its fat box, or has other pairs than before.

    Their `FILTER` and `PROXY` rows are filled in `anew` where somebody has come, changed, woken or fallen asleep.
    """
    workers.numbers[ANEW] = 1.0 if anew else 0.0
    first, end = first_part(workers, BOUND_SHAPES, 0, rows.shape[0])
    while first < end:
        bound_some_shapes(state, rows[first:end], anew, colliders, grid)
        first, end = next_part(workers, first, end)


@kernel
def bound_some_shapes(state: StateTables, rows: Integers, anew: bool, colliders: Colliders, grid: Grid) -> None:
    """The same for some of them."""
    cores = colliders.cores
    seconds = state.settings[0].step_seconds
    unit = state.settings[0].units_per_meter
    for i in rows:
        proxy = colliders.proxies[i]
        other = False
        if anew:
            body_index = state.shapes[i].body
            other = _describe_shape(state.bodies[body_index], state.shapes[i], colliders.filters[i], proxy, unit)
        body = state.bodies[proxy.body]
        turn_core(body, proxy, state.vertices, cores)
        lower_x, lower_y, upper_x, upper_y = core_bounds(cores, core_of(proxy))
        spin = body.angular_velocity if body.angular_velocity > 0.0 else -body.angular_velocity
        _follow_body(body, spin, proxy)
        swing = seconds * spin
        swing = proxy.extent * (swing if swing < 2.0 else 2.0)
        grow = proxy.radius + proxy.margin + swing
        travel_x = seconds * body.velocity_x
        travel_y = seconds * body.velocity_y
        box = colliders.boxes[i]
        box.lower_x = body.center_x + lower_x - grow + (travel_x if travel_x < 0.0 else 0.0)
        box.lower_y = body.center_y + lower_y - grow + (travel_y if travel_y < 0.0 else 0.0)
        box.upper_x = body.center_x + upper_x + grow + (travel_x if travel_x > 0.0 else 0.0)
        box.upper_y = body.center_y + upper_y + grow + (travel_y if travel_y > 0.0 else 0.0)
        grid.outgrown[i] = 0 if _lies_within(box, grid.fat_boxes[i]) and not other else 1
        if proxy.traits & FIXED:
            loose = _LOOSE * state.shapes[i].thin
            proxy.traits |= SLANTING if upper_x - lower_x > loose and upper_y - lower_y > loose else 0


@inlined_kernel
def _lies_within(box: Records, fat: Records) -> bool:
    """Whether a box lies within another one. One branch, as most do."""
    inside_x = (box.lower_x >= fat.lower_x) & (box.upper_x <= fat.upper_x)
    return bool(inside_x & (box.lower_y >= fat.lower_y) & (box.upper_y <= fat.upper_y))


@inlined_kernel
def _describe_shape(body: Records, shape: Records, filter: Records, proxy: Records, unit: float) -> bool:
    """What the grid and the narrow phase ask of a shape and its body that stays from step to step; whether the grid
    has asked with something else."""
    moves = _how_it_moves(body)
    # Nothing is in category 0, so that the grid proposes no pairs of a sensor.
    category = shape.category if shape.sensor == 0 else 0
    group = shape.group if shape.sensor == 0 else 0
    same = filter.body == shape.body and filter.moves == moves
    same = same and filter.category == category and filter.mask == shape.mask and filter.group == group
    filter.body = shape.body
    filter.moves = moves
    filter.may_stop = 0
    filter.category = category
    filter.mask = shape.mask
    filter.group = group
    fixed = FIXED if body.type == STATIC else 0
    proxy.body = shape.body
    proxy.traits = shape.traits | moves | fixed | (BULLET if body.bullet == 1 else 0)
    proxy.margin = shape_margin(body.extent, unit)
    proxy.extent = body.extent
    proxy.vertex_start = shape.vertex_start
    proxy.vertex_count = shape.vertex_count
    proxy.radius = shape.radius
    proxy.friction = shape.friction
    proxy.restitution = shape.restitution
    proxy.rolling_resistance = shape.rolling_resistance
    proxy.surface_speed = shape.surface_speed
    return not same


@inlined_kernel
def _follow_body(body: Records, spin: float, proxy: Records) -> None:
    """What the narrow phase asks of a shape and its body that may change in a step."""
    proxy.center_x = body.center_x
    proxy.center_y = body.center_y
    proxy.velocity_x = body.velocity_x
    proxy.velocity_y = body.velocity_y
    proxy.speed = math.sqrt(body.velocity_x * body.velocity_x + body.velocity_y * body.velocity_y)
    proxy.swing = spin * (proxy.extent - proxy.radius)
    proxy.traits &= ~MAY_STOP
