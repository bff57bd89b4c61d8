"""Stage: pairs that persist. The grid is built of fat boxes, so that what it finds holds for several steps.

A fat box is the box of a shape with room to move in. As long as all boxes lie in their fat boxes, those that overlap
are among the pairs of fat boxes, and a step looks at these alone. Shapes that have outgrown theirs, or are others than
before, get new ones and are looked up alone; where they are many, the grid is rebuilt. The same pairs come out as if
it were in every step.

Source: L. Verlet, Computer "Experiments" on Classical Fluids (Physical Review 159, 1967), where it is a list of
neighbours; fat boxes as in the trees of Bullet and Box2D.
"""

from __future__ import annotations

import math
from typing import Any

from sandbox._jit import kernel
from sandbox.engine.broad_phase.fat_boxes import adapt_fat, fatten, look_less_far
from sandbox.engine.broad_phase.grid import boxes_overlap
from sandbox.engine.broad_phase.margins import SLOW_SHARE, meet_hard
from sandbox.engine.broad_phase.moved_boxes import ABSENT, forget_moved, insert_box, query_pairs, remove_box
from sandbox.engine.broad_phase.pairs import comes_before, find_pairs, sort_pairs
from sandbox.engine.broad_phase.proxies import ACTIVE
from sandbox.engine.joints.pair_filter import JointFilter, are_joined
from sandbox.engine.records.colliders import Colliders, Grid, PairCache
from sandbox.tables import Integers, Records

_MANY = 4
"""The grid is rebuilt when the fat boxes of more than one in so many shapes have to be enlarged,"""
_MOVED = 2
"""when more than one in so many has been since it was built,"""
_OTHERS = 32
"""or when so many of these have got sizes of which there were few."""


@kernel
def update_pair_cache(
    colliders: Colliders, bounded: Integers, shapes: int, seconds: float, slack: float, grid: Grid
) -> int:
    """Bring the pairs of `grid.cache` up to date for so many shapes, of which some have been `bounded` in this step.
    Fat boxes leave room on all sides, `slack` (m) at most.

    Returns 0, or for how many pairs there has to be room.
    """
    info = grid.info[0]
    cache = grid.cache.info[0]
    if cache.valid == 1:
        cache.age += 1
        same = info.known == info.shapes
        count = _list_outgrown(bounded, shapes, grid)
        if count == 0 and same:
            return 0
        few = _MANY * count <= shapes and _MOVED * info.moved <= shapes and info.others <= _OTHERS
        if few and _enlarge(colliders, count, shapes, seconds, slack, grid):
            return 0
    return _rebuild(colliders, shapes, seconds, slack, grid)


@kernel
def _list_outgrown(bounded: Integers, shapes: int, grid: Grid) -> int:
    """List in `grid.enlarged` the shapes that have outgrown their fat boxes or are new; return how many. The boxes of
    those that have gone or have other rows are taken out of the grid."""
    info = grid.info[0]
    for i in range(info.known, info.shapes):
        remove_box(i, grid)
        grid.outgrown[i] = 1
    for i in range(info.known, shapes):
        grid.outgrown[i] = 1
        grid.moved_next[i] = ABSENT
    info.shapes = info.known = shapes
    count = 0
    for i in bounded:
        if grid.outgrown[i] != 0:
            grid.enlarged[count] = i
            count += 1
    return count


@kernel
def _rebuild(colliders: Colliders, shapes: int, seconds: float, slack: float, grid: Grid) -> int:
    """Build the grid and find all pairs; returns 0, or for how many there has to be room.

    Where there is no room for the pairs of fat boxes, they look less far ahead; at last, boxes get no fat.
    """
    cache = grid.cache.info[0]
    room = grid.cache.pairs.shape[0]
    if cache.valid == 1:
        adapt_fat(grid.cache.info, shapes)
    cache.age = 0
    boxes: Any = grid.fat_boxes[:shapes]
    ordered: Any = grid.ordered[:shapes]
    found = 0
    while True:
        for i in range(shapes):
            fatten(colliders, i, seconds * cache.ahead, slack, boxes[i])
        found = find_pairs(boxes, colliders.filters, ordered, grid.heads, grid.levels, grid.info, grid.cache.pairs)
        if found <= room:
            break
        cache.valid = 0
        if cache.ahead == 0.0:
            return found
        look_less_far(cache)
    forget_moved(shapes, grid)
    _bound_all(boxes, grid.info)
    sort_pairs(grid.cache.pairs, found, grid.cache.spare, grid.counts, shapes)
    cache.count = found
    cache.valid = 1
    return 0


@kernel
def _bound_all(boxes: Records, info: Records) -> None:
    """Note the bounds of all boxes."""
    lower_x = lower_y = math.inf
    upper_x = upper_y = -math.inf
    for box in boxes:
        lower_x = box.lower_x if box.lower_x < lower_x else lower_x
        lower_y = box.lower_y if box.lower_y < lower_y else lower_y
        upper_x = box.upper_x if box.upper_x > upper_x else upper_x
        upper_y = box.upper_y if box.upper_y > upper_y else upper_y
    info[0].lower_x = lower_x
    info[0].lower_y = lower_y
    info[0].upper_x = upper_x
    info[0].upper_y = upper_y


@kernel
def _enlarge(colliders: Colliders, enlarged: int, shapes: int, seconds: float, slack: float, grid: Grid) -> bool:
    """Give the first shapes of `grid.enlarged` new fat boxes and find their pairs anew; False if there is no room for
    them."""
    cache = grid.cache.info[0]
    rows = grid.enlarged[:enlarged]
    for i in rows:
        remove_box(i, grid)
        fatten(colliders, i, seconds * cache.ahead, slack, grid.fat_boxes[i])
        insert_box(i, grid)
    fresh: Any = grid.pairs  # they are written in this step after all others
    count = 0
    for i in rows:
        count = query_pairs(grid.fat_boxes[i], colliders.filters, grid, fresh, count)
    if count > fresh.shape[0]:
        return False
    sort_pairs(fresh, count, grid.cache.spare, grid.counts, shapes)
    count = _drop_doubles(fresh, count)
    kept = _drop_outgrown(grid.cache.pairs, cache.count, grid.outgrown)
    if kept + count > grid.cache.pairs.shape[0]:
        return False
    _merge(grid.cache.pairs, kept, fresh, count)
    cache.count = kept + count
    for i in rows:
        grid.outgrown[i] = 0
    return True


@kernel
def _drop_doubles(pairs: Records, count: int) -> int:
    """Take out of the sorted `pairs[:count]` what is there twice, found by both; return how many are left."""
    kept = 0
    for n in range(count):
        if kept == 0 or comes_before(pairs[kept - 1], pairs[n].shape_a, pairs[n].shape_b):
            pairs[kept] = pairs[n]
            kept += 1
    return kept


@kernel
def _drop_outgrown(pairs: Records, count: int, outgrown: Integers) -> int:
    """Take out of `pairs[:count]` those of shapes that are enlarged; return how many are left."""
    kept = 0
    for n in range(count):
        pair = pairs[n]
        if outgrown[pair.shape_a] | outgrown[pair.shape_b] == 0:
            pairs[kept] = pair
            kept += 1
    return kept


@kernel
def _merge(pairs: Records, count: int, fresh: Records, more: int) -> None:
    """Put so many fresh pairs among the first `count` ones, both sorted: from the end, as there is room behind."""
    n = count - 1
    k = more - 1
    while k >= 0:
        if n >= 0 and comes_before(fresh[k], pairs[n].shape_a, pairs[n].shape_b):
            pairs[n + k + 1] = pairs[n]
            n -= 1
        else:
            pairs[n + k + 1] = fresh[k]
            k -= 1


@kernel
def select_pairs(colliders: Colliders, seconds: float, joint_filter: JointFilter, grid: Grid) -> int:
    """Write the cached pairs whose boxes overlap in this step to `grid.pairs`, but for those that joints keep from
    colliding; return how many, also those for which there is no room. Marks the shapes that something may stop in a
    step of so many seconds: what is immovable, or what they run into."""
    filters = colliders.filters
    proxies = colliders.proxies
    pairs = grid.pairs
    bonds = joint_filter.bonds.shape[0] > 0
    cache = grid.cache.info[0]
    overlapping: Any = grid.cache.pairs[: cache.count]
    if cache.ahead > 0.0 or cache.age > 0:  # else these are the pairs of the boxes themselves
        overlapping = grid.cache.spare[: _select_overlapping(colliders.boxes, grid.cache)]
    cache.selected = overlapping.shape[0]
    count = 0
    for n in range(overlapping.shape[0]):
        pair = overlapping[n]
        a = filters[pair.shape_a]
        b = filters[pair.shape_b]
        joined = bonds and are_joined(joint_filter, a.body, b.body)
        if a.moves & b.moves & ACTIVE == 0:  # something immovable may also stop what it is joined to
            a.may_stop = 1
            b.may_stop = 1
        elif not joined and meet_hard(proxies[pair.shape_a], proxies[pair.shape_b], seconds):
            speed_a = proxies[pair.shape_a].speed
            speed_b = proxies[pair.shape_b].speed
            a.may_stop |= speed_b < SLOW_SHARE * speed_a
            b.may_stop |= speed_a < SLOW_SHARE * speed_b
        if joined:
            continue
        if count < pairs.shape[0]:
            pairs[count] = pair
        count += 1
    return count


@kernel
def _select_overlapping(boxes: Records, cache: PairCache) -> int:
    """Write the pairs whose boxes overlap to `cache.spare`; return how many. No branch, which would be a coin toss to
    the processor: what does not overlap is overwritten by the next one."""
    count = 0
    for n in range(cache.info[0].count):
        pair = cache.pairs[n]
        cache.spare[count] = pair
        count += 1 if boxes_overlap(boxes[pair.shape_a], boxes[pair.shape_b]) else 0
    return count
