"""Strays: fast shapes that have left the box which the grid knew. Their pairs lack some of what may hold them.

Only static shapes hold them, which the grid is asked for.
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import kernel
from sandbox.engine.broad_phase.grid import boxes_overlap
from sandbox.engine.broad_phase.moved_boxes import query_pairs
from sandbox.engine.broad_phase.pairs import propose, sort_few_pairs
from sandbox.engine.broad_phase.proxies import ACTIVE, SLEEPS
from sandbox.engine.continuous_collision.hit import list_hit
from sandbox.engine.continuous_collision.relative_sweep import SweepTables
from sandbox.engine.continuous_collision.static_impact import stop_at_static
from sandbox.engine.joints.pair_filter import JointFilter, are_joined
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.colliders import Colliders, Grid
from sandbox.geometry.bounds import core_bounds
from sandbox.geometry.core import core_of
from sandbox.tables import Records
from sandbox.world.records import STATIC


@kernel
def stop_strays(
    tables: SweepTables,
    active: ActiveSet,
    colliders: Colliders,
    grid: Grid,
    count: int,
    joint_filter: JointFilter,
    round: int,
) -> None:
    """Stop the strays of a round at what is not among their pairs. `grid.cache.spare` is scratch from row `count` on.

    What has slid may stray where it did not before: a slide leads out of the box of the displacement that it shortens.
    """
    filters = colliders.filters
    info = active.info[0]
    if info.static == 0:
        return
    for k in range(info.listed):
        i = active.shapes[k]
        body = filters[i].body
        if tables.ccd_bodies[body].fast == 0 or tables.ccd.impacts[body].round != round:
            continue
        woke = filters[i].moves == SLEEPS  # the grid has asked for no pairs of sleepers with what does not move
        if _strays(tables, colliders.boxes, i) or woke:
            list_hit(tables.ccd, body)
            filters[i].moves = ACTIVE
            near = _list_near(filters, grid, tables.ccd.boxes[i], count)
            _stop_stray(tables, colliders, grid, joint_filter, count, near, i, round)
            filters[i].moves = SLEEPS if woke else ACTIVE


@kernel
def _list_near(filters: Records, grid: Grid, box: Records, count: int) -> int:
    """Write the pairs of a stray's box with what is near behind the first `count` of `grid.cache.spare`, sorted; return
    how many there are then, also those for which there is no room."""
    pairs = grid.cache.spare
    first = count
    count = query_pairs(box, filters, grid, pairs, count)
    if count <= pairs.shape[0]:
        found: Any = pairs[first:count]
        sort_few_pairs(found, count - first)
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
    fast = grid.cache.spare
    filters = colliders.filters
    listed = near <= fast.shape[0]
    for k in range(near - count if listed else tables.shapes.shape[0]):
        j = k
        if listed:
            j = fast[count + k].shape_a + fast[count + k].shape_b - i
        elif not boxes_overlap(tables.ccd.boxes[i], colliders.boxes[j]) or propose(filters, i, j, fast, count) == count:
            continue
        static = tables.bodies[filters[j].body].type == STATIC
        if static and not are_joined(joint_filter, filters[i].body, filters[j].body):
            stop_at_static(tables, fast[count + k if listed else count], round)


@kernel
def _strays(tables: SweepTables, boxes: Records, i: int) -> bool:
    """Whether a shape has left the box that the grid knew. `ccd.boxes` gets that box, or the one of its true
    displacement."""
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
    known = boxes[i]
    box = tables.ccd.boxes[i]
    box.lower_x = known.lower_x
    box.lower_y = known.lower_y
    box.upper_x = known.upper_x
    box.upper_y = known.upper_y
    box.shape_index = i
    inside_x = lower_x >= known.lower_x and upper_x <= known.upper_x
    if inside_x and lower_y >= known.lower_y and upper_y <= known.upper_y:
        return False
    box.lower_x = lower_x
    box.lower_y = lower_y
    box.upper_x = upper_x
    box.upper_y = upper_y
    return True
