"""Stage: pairs that persist. The grid is asked with fat boxes, so that what it has found holds for several steps.

A fat box is the box of a shape with room to move in. As long as all boxes lie in their fat boxes, those that overlap
are among the pairs of fat boxes, and a step looks at these alone. Shapes that have outgrown theirs, or are others than
before, ask anew; where they are many, the grid is laid anew. The same pairs come out as if it were in every step.

Source: L. Verlet, Computer "Experiments" on Classical Fluids (Physical Review 159, 1967), where it is a list of
neighbours; fat boxes as in the trees of Bullet and Box2D.
"""

from __future__ import annotations

from typing import Any

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.broad_phase.grid import boxes_overlap
from sandbox.engine.broad_phase.moved_boxes import ABSENT, forget_moved, pairs_near, put_in, take_out
from sandbox.engine.broad_phase.pairs import comes_after, find_pairs, sort_pairs
from sandbox.engine.broad_phase.proxies import ACTIVE, DRIVEN
from sandbox.engine.joints.pair_filter import JointFilter, are_joined
from sandbox.engine.records.colliders import Colliders, Grid, PairCache
from sandbox.tables import Integers, Records

SLACK = 0.1
"""Most room (m) that a fat box leaves on each side."""
SLACK_SHARE = 0.1
"""The same for small bodies, as a share of their extent."""
AHEAD = 8.0
"""For so many further steps at most (a power of two) a fat box covers what the velocity leads to: fewer where many
pairs come of it."""
_MANY = 4
"""The grid is laid anew when more than one in so many shapes would ask."""
_NEEDLESS = 0.5
"""Boxes look less far ahead when the cache has more needless pairs than so many for each shape and each pair that is
selected, and further again when it has a fourth of that."""
_LASTING = 3
"""Pairs of fat boxes are worth it if they hold for so many steps: to find them takes up to twice as long."""
_WAIT = 32
"""How often the grid is laid without fat boxes once they have not been worth it."""
_OTHERS = 32
"""The same when so many boxes have got sizes of which there were few."""


@kernel
def update_pair_cache(
    colliders: Colliders, bounded: Integers, shapes: int, seconds: float, joint_filter: JointFilter, grid: Grid
) -> int:
    """Bring the pairs of `grid.cache` up to date for so many shapes, of which some have been `bounded` in this step.

    Returns 0, or for how many pairs there has to be room.
    """
    if grid.cache.info[0].valid == 1:
        grid.cache.info[0].age += 1
        asking = _list_outgrown(bounded, shapes, grid)
        if asking == 0:
            return 0
        few = _MANY * asking <= shapes and 2 * grid.info[0].moved <= shapes and grid.info[0].others <= _OTHERS
        if few and _ask(colliders, asking, shapes, seconds, joint_filter, grid):
            return 0
    return _lay_anew(colliders, shapes, seconds, joint_filter, grid)


@kernel
def _list_outgrown(bounded: Integers, shapes: int, grid: Grid) -> int:
    """List in `grid.asking` the shapes that have outgrown their fat boxes or are new; return how many."""
    info = grid.info[0]
    for i in range(info.shapes, shapes):
        grid.outgrown[i] = 1
        grid.moved_next[i] = ABSENT
    info.shapes = shapes
    count = 0
    for i in bounded:
        if grid.outgrown[i] != 0:
            grid.asking[count] = i
            count += 1
    return count


@kernel
def _lay_anew(colliders: Colliders, shapes: int, seconds: float, joint_filter: JointFilter, grid: Grid) -> int:
    """Lay the grid and find all pairs; returns 0, or for how many there has to be room.

    Where there is no room for the pairs of fat boxes, they look less far ahead; at last, boxes get no fat.
    """
    cache = grid.cache.info[0]
    room = grid.cache.pairs.shape[0]
    if cache.valid == 1:
        _adapt(grid.cache.info, shapes)
    cache.age = 0
    boxes: Any = grid.fat_boxes[:shapes]
    ordered: Any = grid.ordered[:shapes]
    found = 0
    while True:
        for i in range(shapes):
            _fatten(colliders, i, seconds * cache.ahead, boxes[i])
        found = find_pairs(boxes, colliders.filters, ordered, grid.heads, grid.levels, grid.info, grid.cache.pairs)
        if found <= room:
            break
        cache.valid = 0
        if cache.ahead == 0.0:
            return found
        _look_less_far(cache)
    forget_moved(shapes, grid)
    sort_pairs(grid.cache.pairs, found, grid.cache.spare, grid.counts, shapes)
    cache.count = _drop_joined(joint_filter, colliders.filters, grid.cache.pairs, found)
    cache.valid = 1
    return 0


@inlined_kernel
def _adapt(info: Records, shapes: int) -> None:
    """Look less far ahead, or further: to pass over a needless pair costs a tenth of what it costs to ask anew. Where
    pairs hold for less than `_LASTING` steps, it is some time until that is tried again."""
    cache = info[0]
    needless = cache.count - cache.selected
    most = _NEEDLESS * (cache.selected + shapes)
    if cache.ahead == 0.0:
        cache.wait -= 1
        cache.ahead = 1.0 if cache.wait <= 0 else 0.0
        return
    if needless > most:
        _look_less_far(cache)
    elif 4 * needless < most and cache.ahead < AHEAD:
        cache.ahead *= 2.0
    elif cache.age < _LASTING:
        cache.ahead = 0.0
    if cache.ahead == 0.0:
        cache.wait = _WAIT


@inlined_kernel
def _look_less_far(cache: Records) -> None:
    cache.ahead = 0.5 * cache.ahead if cache.ahead > 1.0 else 0.0


@inlined_kernel
def _fatten(colliders: Colliders, i: int, ahead: float, fat: Records) -> None:
    """Write the fat box of a shape: what moves gets room where its velocity leads to within a time `ahead` (s), and a
    little on all sides; none if that is 0."""
    box = colliders.boxes[i]
    proxy = colliders.proxies[i]
    grow = x = y = 0.0
    if ahead > 0.0 and colliders.filters[i].moves & (ACTIVE | DRIVEN):
        extent = proxy.extent
        slack = SLACK_SHARE * extent
        swing = ahead * proxy.swing
        grow = (slack if slack < SLACK else SLACK) + (swing if swing < 2.0 * extent else 2.0 * extent)
        x = ahead * proxy.velocity_x
        y = ahead * proxy.velocity_y
    fat.lower_x = box.lower_x + (x if x < 0.0 else 0.0) - grow
    fat.lower_y = box.lower_y + (y if y < 0.0 else 0.0) - grow
    fat.upper_x = box.upper_x + (x if x > 0.0 else 0.0) + grow
    fat.upper_y = box.upper_y + (y if y > 0.0 else 0.0) + grow
    fat.shape_index = i


@kernel
def _ask(colliders: Colliders, asking: int, shapes: int, seconds: float, joint_filter: JointFilter, grid: Grid) -> bool:
    """Find the pairs of the first shapes of `grid.asking` anew; False if there is no room for them."""
    cache = grid.cache.info[0]
    rows = grid.asking[:asking]
    for i in rows:
        take_out(i, grid)
        _fatten(colliders, i, seconds * cache.ahead, grid.fat_boxes[i])
        put_in(i, grid)
    fresh: Any = grid.pairs  # they are written in this step after all others
    count = 0
    for i in rows:
        count = pairs_near(grid.fat_boxes[i], colliders.filters, grid, fresh, count)
    if count > fresh.shape[0]:
        return False
    sort_pairs(fresh, count, grid.cache.spare, grid.counts, shapes)
    count = _drop_joined(joint_filter, colliders.filters, fresh, _drop_doubles(fresh, count))
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
    """Take out of the sorted `pairs[:count]` what is there twice, as both have asked; return how many are left."""
    kept = 0
    for n in range(count):
        if kept == 0 or comes_after(pairs[n], pairs[kept - 1]):
            pairs[kept] = pairs[n]
            kept += 1
    return kept


@kernel
def _drop_joined(joint_filter: JointFilter, filters: Records, pairs: Records, count: int) -> int:
    """Take out of `pairs[:count]` those that both move and are kept from colliding by a joint; return how many are
    left. The others are looked at in every step, as something immovable may stop what it is joined to."""
    if joint_filter.bonds.shape[0] == 0:
        return count
    kept = 0
    for n in range(count):
        a = filters[pairs[n].shape_a]
        b = filters[pairs[n].shape_b]
        if a.moves & b.moves & ACTIVE == 0 or not are_joined(joint_filter, a.body, b.body):
            pairs[kept] = pairs[n]
            kept += 1
    return kept


@kernel
def _drop_outgrown(pairs: Records, count: int, outgrown: Integers) -> int:
    """Take out of `pairs[:count]` those of shapes that have asked anew; return how many are left."""
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
        if n >= 0 and comes_after(pairs[n], fresh[k]):
            pairs[n + k + 1] = pairs[n]
            n -= 1
        else:
            pairs[n + k + 1] = fresh[k]
            k -= 1


@kernel
def select_pairs(colliders: Colliders, joint_filter: JointFilter, grid: Grid) -> int:
    """Write the cached pairs whose boxes overlap in this step to `grid.pairs`; return how many, also those for which
    there is no room. Marks the shapes that something immovable may stop."""
    filters = colliders.filters
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
        if a.moves & b.moves & ACTIVE == 0:
            a.confined = 1
            b.confined = 1
            if bonds and are_joined(joint_filter, a.body, b.body):
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
