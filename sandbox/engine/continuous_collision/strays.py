"""Strays: fast shapes that have left the box which the grid knew. Their pairs lack some of what may hold them.

Only static shapes hold them: those that rest are asked of their grid, where there is one; the boxes of all others are
laid side by side once a step, if there is a stray, and gone through.
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import kernel
from sandbox.engine.broad_phase.grid import boxes_overlap
from sandbox.engine.broad_phase.pairs import insert_in_order, propose
from sandbox.engine.broad_phase.proxies import ACTIVE, SLEEPS
from sandbox.engine.broad_phase.resting_grid import pairs_with_resting
from sandbox.engine.continuous_collision.hit import list_hit
from sandbox.engine.continuous_collision.relative_sweep import SweepTables
from sandbox.engine.continuous_collision.static_impact import stop_at_static
from sandbox.engine.joints.pair_filter import JointFilter, are_joined
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.colliders import Colliders, Grid
from sandbox.geometry.bounds import core_bounds
from sandbox.geometry.core import core_of
from sandbox.tables import Integers, Records
from sandbox.world.records import STATIC


@kernel
def stop_strays(
    tables: SweepTables,
    active: ActiveSet,
    colliders: Colliders,
    grid: Grid,
    count: int,
    joint_filter: JointFilter,
    static_count: int,
    round: int,
) -> int:
    """Stop the strays at what is not among their pairs. `grid.sorted_pairs` is scratch from row `count` on.

    Return how many static shapes the grid of the resting ones lacks, if they had to be gathered, else -1. With that as
    `static_count` the strays that slide are held against them again: their boxes hold their displacements by now.
    """
    filters = colliders.filters
    info = active.info[0]
    shapes = tables.shapes.shape[0]
    known = info.shapes_generation == info.generation  # otherwise somebody has woken in this step
    if info.static == 0:
        return static_count
    again = static_count >= 0
    for k in range(info.moving if known else shapes):
        i = active.shapes[k]
        body = filters[i].body
        if tables.ccd_bodies[body].fast == 0 or tables.ccd.impacts[body].round != round:
            continue
        woke = filters[i].moves == SLEEPS  # the grid has asked for no pairs of sleepers with what does not move
        filters[i].moves = ACTIVE
        impact = tables.ccd.impacts[body]
        strays = impact.stray == 1 if again else _strays(tables, colliders.boxes, i) or woke
        if strays:
            list_hit(tables.ccd, body)
            impact.stray = 1
            if static_count < 0:
                rows = active.shapes[: info.moving if info.split == 1 else shapes]
                static_count = _gather_static(tables, colliders.boxes, rows, grid.spare_boxes)
            near = _list_near(active, colliders, grid, static_count, shapes, count, i)
            _stop_stray(tables, colliders, grid, joint_filter, count, near, i, round)
            filters[i].confined = 0  # by what is near in this step, not in the next
    return static_count


@kernel
def _gather_static(tables: SweepTables, boxes: Records, rows: Integers, static_boxes: Records) -> int:
    """Copy the boxes of the static shapes among some; return how many."""
    count = 0
    for j in rows:
        if tables.bodies[tables.shapes[j].body].type == STATIC:
            static_boxes[count] = boxes[j]
            count += 1
    return count


@kernel
def _list_near(
    active: ActiveSet, colliders: Colliders, grid: Grid, static_count: int, shapes: int, count: int, i: int
) -> int:
    """Write the pairs of a stray with what may hold it behind the first `count` of `grid.sorted_pairs`, sorted; return
    how many there are then, also those for which there is no room."""
    info = active.info[0]
    filters = colliders.filters
    pairs = grid.sorted_pairs
    box = colliders.boxes[i]
    first = count
    for k in range(static_count):
        if boxes_overlap(box, grid.spare_boxes[k]):
            count = propose(filters, i, grid.spare_boxes[k].shape_index, pairs, count)
    if info.split == 1:
        count = pairs_with_resting(box, filters, info, grid, shapes, pairs, count)
    if count <= pairs.shape[0]:
        found: Any = pairs[first:count]
        insert_in_order(found, count - first)
    return count


@kernel
def _stop_stray(
    tables: SweepTables,
    colliders: Colliders,
    grid: Grid,
    joint_filter: JointFilter,
    count: int,
    near: int,
    i: int,
    round: int,
) -> None:
    """Stop a stray at the static shapes near it, in their order: of those it touches at once, the first holds it."""
    fast = grid.sorted_pairs
    filters = colliders.filters
    listed = near <= fast.shape[0]
    for k in range(near - count if listed else tables.shapes.shape[0]):
        j = k
        if listed:
            j = fast[count + k].shape_a + fast[count + k].shape_b - i
        elif not boxes_overlap(colliders.boxes[i], colliders.boxes[j]) or propose(filters, i, j, fast, count) == count:
            continue
        static = tables.bodies[filters[j].body].type == STATIC
        if static and not are_joined(joint_filter, filters[i].body, filters[j].body):
            stop_at_static(tables, fast[count + k if listed else count], round)


@kernel
def _strays(tables: SweepTables, boxes: Records, i: int) -> bool:
    """Whether a shape has left the box that the grid knew: its box becomes that of its true displacement then."""
    shape = tables.shapes[i]
    body = tables.bodies[shape.body]
    motion = tables.motions[shape.body]
    swing = abs(motion.delta_angle)
    grow = shape.radius + body.extent * (swing if swing < 2.0 else 2.0)
    lower_x, lower_y, upper_x, upper_y = core_bounds(tables.cores, core_of(shape))
    dx = motion.delta_x
    dy = motion.delta_y
    lower_x = body.center_x + lower_x - grow - (dx if dx > 0.0 else 0.0)
    lower_y = body.center_y + lower_y - grow - (dy if dy > 0.0 else 0.0)
    upper_x = body.center_x + upper_x + grow - (dx if dx < 0.0 else 0.0)
    upper_y = body.center_y + upper_y + grow - (dy if dy < 0.0 else 0.0)
    box = boxes[i]
    inside_x = lower_x >= box.lower_x and upper_x <= box.upper_x
    if inside_x and lower_y >= box.lower_y and upper_y <= box.upper_y:
        return False
    box.lower_x = lower_x
    box.lower_y = lower_y
    box.upper_x = upper_x
    box.upper_y = upper_y
    return True
