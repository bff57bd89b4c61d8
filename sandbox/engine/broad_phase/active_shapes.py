"""Stage: the order of shapes. Those that may move come first, so that a step bounds these alone."""

from __future__ import annotations

from typing import Any

from sandbox._jit import kernel
from sandbox.engine.active.active_set import AWAKE, first_from
from sandbox.engine.records.active_set import ActiveSet
from sandbox.tables import Records

LOOSE, ALL = 1, 2
"""What `order_shapes` has put in order: the shapes that may move or sleep, or all."""


@kernel
def order_shapes(shapes: Records, active: ActiveSet) -> int:
    """Put the rows of the shapes that may move first into `active.shapes`, then the other loose ones.

    Returns what had to be put in order: 0, `LOOSE` or `ALL`, where the others follow. `active.info` then knows how many
    move.
    """
    info = active.info[0]
    if info.shapes_generation == info.generation:
        return 0
    found = ALL if info.fixed_generation > info.shapes_generation else LOOSE
    if found == ALL:
        _list_loose_shapes(shapes, active)
    else:
        _list_touched_shapes(shapes, active)
        _add_shapes(shapes, active)
    info.shapes_generation = info.generation
    loose: Any = active.loose_shapes[: info.loose]
    moving = 0
    for i in loose:
        if active.activity[shapes[i].body] == AWAKE:
            active.shapes[moving] = i
            moving += 1
    resting = moving
    for i in loose:
        if active.activity[shapes[i].body] != AWAKE:
            active.shapes[resting] = i
            resting += 1
    info.moving = moving
    return found


@kernel
def _list_loose_shapes(shapes: Records, active: ActiveSet) -> None:
    """List the loose shapes of all, and put the others last into `active.shapes`."""
    loose = 0
    for i in range(shapes.shape[0]):
        if active.activity[shapes[i].body] != 0:
            active.loose_shapes[loose] = i
            loose += 1
    active.info[0].loose = loose
    active.info[0].shapes = shapes.shape[0]
    last = loose
    for i in range(shapes.shape[0]):
        if active.activity[shapes[i].body] == 0:
            active.shapes[last] = i
            last += 1


@kernel
def _list_touched_shapes(shapes: Records, active: ActiveSet) -> None:
    """List the shapes of the bodies that have become loose by being touched: from the end, as there is room behind."""
    info = active.info[0]
    touched: Any = active.touched[1 : 1 + active.touched[0]]
    owners: Any = shapes.body
    more = 0
    for i in touched:
        more += first_from(owners, i + 1) - first_from(owners, i)
    n = info.loose - 1
    info.loose += more
    last = info.loose
    for k in range(touched.shape[0] - 1, -1, -1):
        first = first_from(owners, touched[k])
        while n >= 0 and active.loose_shapes[n] > first:
            last -= 1
            active.loose_shapes[last] = active.loose_shapes[n]
            n -= 1
        for i in range(first_from(owners, touched[k] + 1) - 1, first - 1, -1):
            last -= 1
            active.loose_shapes[last] = i
    active.touched[0] = 0


@kernel
def _add_shapes(shapes: Records, active: ActiveSet) -> None:
    """List the shapes that have come, which are loose, behind the others of these."""
    info = active.info[0]
    for i in range(info.shapes, shapes.shape[0]):
        active.loose_shapes[info.loose] = i
        info.loose += 1
    info.shapes = shapes.shape[0]


@kernel
def outdated_shapes(info: Records, changed: int, shapes: int) -> int:
    """How many of `active.shapes`, from the first one on, may have other boxes than when they were bounded last, if
    `order_shapes` has returned `changed`."""
    if changed == ALL:
        return shapes
    moving: int = info.moving
    loose: int = info.loose
    return moving if changed == 0 else loose
