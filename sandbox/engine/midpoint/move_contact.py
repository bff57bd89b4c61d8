"""Contacts after their bodies have moved a little, for single numbers and vectors alike.

Where a contact lasts, the axis turns with the face that gave it, or joins the two vertices that it joined, and the
point stays at the vertex that touches the face: it moves over both bodies. Any other is stopped where it will touch
first, whatever its bodies do before: its axis stays, and its points move along with either of them.

The rounding of a shape does not turn: a disc touches below its middle, wherever it has turned to.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel
from sandbox._vectors import Number, root, select
from sandbox.engine.contact_solver.gather import PairPose
from sandbox.engine.contact_solver.law import Anchors

FACE_OF_A, FACE_OF_B, VERTICES = 0, 1, 2
"""What the axis of a contact that lasts is of: its `axis_owner`."""
STAYS = 3
"""The same of one that does not last."""


class Axis(NamedTuple):
    """A unit normal, from a to b, and the rounding (m) of their shapes."""

    x: Number
    y: Number
    radius_a: Number
    radius_b: Number


@inlined_kernel
def moved_axis(axis: Axis, r: Anchors, way: PairPose, owner: Number) -> Axis:
    """The axis of a contact whose first point has the anchors `r`, after its bodies have moved so far."""
    face_a_x, face_a_y = _turned(way.cos_a, way.sin_a, axis.x, axis.y)
    face_b_x, face_b_y = _turned(way.cos_b, way.sin_b, axis.x, axis.y)
    cores = _cores(r, axis, -1.0)
    moved = _turned_cores(cores, way)
    x = (r.ax - r.bx) + way.x + (moved.bx - moved.ax)
    y = (r.ay - r.by) + way.y + (moved.by - moved.ay)
    length = root(x * x + y * y)
    # Where cores overlap, the normal leads from b to a.
    gap = ((r.ax - r.bx) + (cores.bx - cores.ax)) * axis.x + ((r.ay - r.by) + (cores.by - cores.ay)) * axis.y
    length = select(gap < 0.0, -length, length)
    joins = (owner == VERTICES) & (length != 0.0)
    length = select(joins, length, 1.0)
    x = select(joins, x / length, axis.x)
    y = select(joins, y / length, axis.y)
    x = select(owner == FACE_OF_A, face_a_x, select(owner == FACE_OF_B, face_b_x, x))
    y = select(owner == FACE_OF_A, face_a_y, select(owner == FACE_OF_B, face_b_y, y))
    return Axis(x, y, axis.radius_a, axis.radius_b)


@inlined_kernel
def moved_point(
    r: Anchors, separation: Number, before: Axis, after: Axis, way: PairPose, owner: Number
) -> tuple[Anchors, Number]:
    """The anchors and the gap (m) of a point, after its bodies have moved so far."""
    # A face has no point that stays: its gap is to the vertex of the other body, whatever its own core does.
    of_a = select(owner == FACE_OF_A, 0.0, 1.0)
    of_b = select(owner == FACE_OF_B, 0.0, 1.0)
    cores = _cores(r, before, -1.0)
    moved = _turned_cores(cores, way)
    x = r.ax - r.bx
    y = r.ay - r.by
    gap_x = x + (of_b * cores.bx - of_a * cores.ax)
    gap_y = y + (of_b * cores.by - of_a * cores.ay)
    was = gap_x * before.x + gap_y * before.y
    x = x + way.x
    y = y + way.y
    gap_x = x + (of_b * moved.bx - of_a * moved.ax)
    gap_y = y + (of_b * moved.by - of_a * moved.ay)
    now = gap_x * after.x + gap_y * after.y
    on = _cores(moved, after, 1.0)
    lasts = owner != STAYS
    from_b = owner == FACE_OF_A
    ax = select(from_b, on.bx + x, on.ax)
    ay = select(from_b, on.by + y, on.ay)
    bx = select(lasts & (owner != FACE_OF_A), on.ax - x, on.bx)
    by = select(lasts & (owner != FACE_OF_A), on.ay - y, on.by)
    return Anchors(ax, ay, bx, by), separation + (now - was)


@inlined_kernel
def _turned(cos: Number, sin: Number, x: Number, y: Number) -> tuple[Number, Number]:
    return cos * x - sin * y, sin * x + cos * y


@inlined_kernel
def _cores(r: Anchors, axis: Axis, sign: float) -> Anchors:
    """Points of both cores without their rounding if `sign` is -1, with it if that is 1."""
    a = sign * axis.radius_a
    b = sign * axis.radius_b
    return Anchors(r.ax + a * axis.x, r.ay + a * axis.y, r.bx - b * axis.x, r.by - b * axis.y)


@inlined_kernel
def _turned_cores(r: Anchors, way: PairPose) -> Anchors:
    ax, ay = _turned(way.cos_a, way.sin_a, r.ax, r.ay)
    bx, by = _turned(way.cos_b, way.sin_b, r.bx, r.by)
    return Anchors(ax, ay, bx, by)
