"""Stage: the order of shapes. Those that may move come first, so that a step bounds these and what was touched."""

from __future__ import annotations

from typing import Any

from sandbox._jit import inlined_kernel, kernel
from sandbox.engine.active.active_set import ASLEEP, AWAKE, first_from
from sandbox.engine.records.active_set import ActiveSet
from sandbox.tables import Integers, Records

TOUCHED, ALL = 1, 2
"""Whose shapes `order_shapes` has put behind those that may move: of the bodies that were touched, or of all others."""


@kernel
def order_shapes(shapes: Records, active: ActiveSet) -> int:
    """Put the rows of the shapes that may move first into `active.shapes`, then those that were touched.

    Returns what had to be put in order: 0, `TOUCHED` or `ALL`. `active.info` then knows how many move, and how many are
    listed.
    """
    info = active.info[0]
    if info.shapes_generation == info.generation:
        info.listed = info.moving
        return 0
    found = ALL if info.anew > info.shapes_generation else TOUCHED
    info.shapes_generation = info.generation
    if found == ALL:
        info.moving = _list_shapes(shapes, active, 0, True)
        info.listed = _list_shapes(shapes, active, info.moving, False)
    else:
        info.moving = _list_shapes_of(shapes, active.bodies[1 : 1 + active.bodies[0]], active, 0, AWAKE)
        touched: Any = active.touched[1 : 1 + active.touched[0]]
        info.listed = _list_shapes_of(shapes, touched, active, info.moving, 0)
        info.listed = _list_shapes_of(shapes, touched, active, info.listed, ASLEEP)
    active.touched[0] = 0
    return found


@kernel
def _list_shapes(shapes: Records, active: ActiveSet, count: int, moving: bool) -> int:
    """List of all shapes those that may move, or the others, behind the first `count`; return the new count."""
    for i in range(shapes.shape[0]):
        if (active.activity[shapes[i].body] == AWAKE) == moving:
            active.shapes[count] = i
            count += 1
    return count


@kernel
def _list_shapes_of(shapes: Records, bodies: Integers, active: ActiveSet, count: int, activity: int) -> int:
    """The same for the shapes of some bodies, in the order of rows, as far as `activity` says that of them."""
    owners: Any = shapes.body
    i = 0
    for body in bodies:
        if active.activity[body] != activity:
            continue
        i = first_shape_from(owners, i, body)
        while i < owners.shape[0] and owners[i] == body:
            active.shapes[count] = i
            count += 1
            i += 1
    return count


@inlined_kernel
def first_shape_from(owners: Integers, i: int, body: int) -> int:
    """The first shape of a body, from shape i on, which is often the one: shapes lie in the order of bodies."""
    return first_from(owners, body) if i < owners.shape[0] and owners[i] < body else i


@kernel
def list_woken_shapes(shapes: Records, active: ActiveSet) -> None:
    """List the shapes of the bodies that have woken since shapes were put in order behind those that move."""
    info = active.info[0]
    owners: Any = shapes.body
    known = 0
    i = 0
    info.listed = info.moving
    for body in active.bodies[1 : 1 + active.bodies[0]]:
        while known < info.moving and owners[active.shapes[known]] < body:
            known += 1
        if known < info.moving and owners[active.shapes[known]] == body:
            continue
        i = first_shape_from(owners, i, body)
        while i < owners.shape[0] and owners[i] == body:
            active.shapes[info.listed] = i
            info.listed += 1
            i += 1
