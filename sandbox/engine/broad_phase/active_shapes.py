"""Stage: the order of shapes. Those that may move come first, so that a step bounds these alone."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.active.active_set import AWAKE
from sandbox.engine.records.active_set import ActiveSet
from sandbox.tables import Records

LOOSE, ALL = 1, 2
"""What `order_shapes` has put in order: the shapes that may move or sleep, or all."""


@kernel
def order_shapes(shapes: Records, active: ActiveSet) -> int:
    """Put the rows of the shapes that may move first into `active.shapes`, then the other loose ones, then the others.

    Returns what had to be put in order: 0, `LOOSE` or `ALL`. `active.info` then knows how many move.
    """
    info = active.info[0]
    if info.shapes_generation == info.generation:
        return 0
    found = LOOSE
    if info.fixed_generation > info.shapes_generation:
        found = ALL
        _put_loose_aside(shapes, active)
        info.shapes = shapes.shape[0]
    info.shapes_generation = info.generation
    _add_shapes(shapes, active)
    moving = 0
    for i in active.loose_shapes[: info.loose]:
        if active.activity[shapes[i].body] == AWAKE:
            active.shapes[moving] = i
            moving += 1
    resting = moving
    for i in active.loose_shapes[: info.loose]:
        if active.activity[shapes[i].body] != AWAKE:
            active.shapes[resting] = i
            resting += 1
    info.moving = moving
    return found


@kernel
def _put_loose_aside(shapes: Records, active: ActiveSet) -> None:
    """List the loose shapes, and put the others last into `active.shapes`."""
    loose = 0
    for i in range(shapes.shape[0]):
        if active.activity[shapes[i].body] != 0:
            active.loose_shapes[loose] = i
            loose += 1
    active.info[0].loose = loose
    last = loose
    for i in range(shapes.shape[0]):
        if active.activity[shapes[i].body] == 0:
            active.shapes[last] = i
            last += 1


@kernel
def _add_shapes(shapes: Records, active: ActiveSet) -> None:
    """List the shapes that have come, which are loose, behind the others of these. For each, one that is not makes
    room."""
    info = active.info[0]
    for i in range(info.shapes, shapes.shape[0]):
        active.loose_shapes[info.loose] = i
        active.shapes[i] = active.shapes[info.loose]
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
