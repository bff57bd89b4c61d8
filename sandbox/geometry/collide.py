"""Do two shapes overlap, how far apart are they, and does one hold a point?

The kernels are those of the engine's narrow phase. Where they come close enough to a touch for rounding to matter,
whole numbers decide (`exact_axes.py`), so every verdict is right for the floats given.

Touching is not colliding: the intervals of two shapes overlap on an axis when `amin < bmax and bmin < amax`. Both
inequalities are strict and compare a minimum with the other's maximum. A test of `amin < bmax and amin > bmin or
bmin < amax and bmin > amin` is wrong for equal minima: it would call a polygon separated from itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

from sandbox.geometry.checks import check_shapes, checked_point
from sandbox.geometry.exact_axes import Axis, ExactPair
from sandbox.geometry.pair import Pair, pair_of
from sandbox.geometry.shapes import Core, Shape

Vec = tuple[float, float]
Owner = Literal["a", "b", "corners"]

_TOUCH = 1e-13
"""Share of the pair's size by which the kernels' separation may be off; below it whole numbers decide."""
_SHALLOW = 1e-4
"""Share of the pair's size below which a depth is so small that rounding could favour a wrong axis by 1e-10 of it."""
_PARALLEL = 1e-9
"""Sine of an angle below which the kernel's axis is the one that whole numbers chose."""
_OWNERS: tuple[Owner, Owner, Owner] = ("a", "b", "corners")


@dataclass(frozen=True)
class Contact:
    """How two shapes overlap, in metres.

    `normal` is the unit axis of least overlap, from a to b; `depth` > 0 the overlap along it. Moving b by `mtv`, which
    is depth * normal, parts the two: they are left touching, or apart by no more than rounding. `points` (one or two)
    lie half way between the surfaces. `axis_owner` says which face gave the axis, of "a" or of "b", and `axis_edge`
    its number, from 0, as the author numbered the edges (`Shape.given`); where it leads from one rounded corner or
    centre to another, they are "corners" and None.
    """

    normal: Vec
    depth: float
    mtv: Vec
    points: tuple[Vec, ...]
    axis_owner: Owner
    axis_edge: int | None


@dataclass(frozen=True)
class Distance:
    """How far apart two shapes are (`value`, metres) and the closest `points` of a and of b.

    Shapes that touch have distance 0 and points; shapes that overlap have distance 0 and no points.
    """

    value: float
    points: tuple[Vec, Vec] | None


def collide(a: Shape, b: Shape) -> Contact | None:
    """The contact of two shapes, or None when some axis separates them. Touching is not colliding.

    One shape inside another gives the shortest way out. Among equal ways the first is taken: faces of a in order, then
    faces of b. Concentric discs part along +y. Raises `ShapeError` if one of them is no shape.
    """
    check_shapes("collide", a, b)
    pair = pair_of(a, b)
    separation, size, manifold = pair.manifold(_TOUCH)
    if separation > _TOUCH * size:
        return None
    exact = ExactPair(a, b)
    if separation > -_SHALLOW * size:
        axis = exact.best()
        if exact.compare(axis) >= 0:
            return None
        manifold = manifold if _agree(manifold, axis) else pair.manifold_on(axis)
    else:
        axis = exact.axis(int(manifold.axis_owner), int(manifold.axis_edge), int(manifold.feature1) % 64)
    depth, mtv = exact.way_out(axis)
    points = _points(pair, manifold)
    return Contact(axis.normal, depth, mtv, points, _OWNERS[axis.owner], _edge_number(a, b, axis))


def distance(a: Shape, b: Shape) -> Distance:
    """Distance of two shapes and their closest points; right to rounding, and 0 only if they touch or overlap."""
    check_shapes("distance", a, b)
    pair = pair_of(a, b)
    separation, size, _row = pair.manifold(_SHALLOW)
    if separation < -_TOUCH * size:
        return Distance(0.0, None)
    apart, (ax, ay), (bx, by) = pair.nearest()
    value = apart - sum(pair.radii)
    nx, ny = ((bx - ax) / apart, (by - ay) / apart) if apart > 0.0 else (0.0, 0.0)
    if value < _SHALLOW * size:
        exact = ExactPair(a, b)
        axis = exact.best()
        if exact.compare(axis) < 0:
            return Distance(0.0, None)
        value, (nx, ny) = exact.separation(axis), axis.normal
    on_a = pair.in_world(ax + nx * a.radius, ay + ny * a.radius)
    return Distance(value, (on_a, pair.in_world(bx - nx * b.radius, by - ny * b.radius)))


def contains(shape: Shape, point: Sequence[float]) -> bool:
    """Whether a point (x, y) in metres lies in a shape or on its outline; exact for the floats given."""
    check_shapes("contains", shape)
    spot = checked_point("contains", "the point", point)
    separation, size, _row = pair_of(shape, _Spot((spot,))).manifold(_TOUCH)
    return separation < 0.0 if abs(separation) > _TOUCH * size else holds(shape, spot)


def holds(core: Core, point: Vec) -> bool:
    """`contains` in whole numbers alone, for a core that has been checked."""
    exact = ExactPair(core, _Spot((point,)))
    return exact.compare(exact.best()) <= 0


class _Spot(NamedTuple):
    """A point as a core."""

    vertices: tuple[Vec, ...]
    radius: float = 0.0


def _points(pair: Pair, manifold: Any) -> tuple[Vec, ...]:
    """The points in world coordinates; two that are the same are one."""
    both = (manifold.x1, manifold.y1), (manifold.x2, manifold.y2)
    return tuple(dict.fromkeys(pair.in_world(x, y) for x, y in both[: int(manifold.point_count)]))


def _agree(manifold: Any, axis: Axis) -> bool:
    """Whether the kernel's points are those of an axis: faces flat on each other are as near at their corners."""
    (x, y), nx, ny = axis.normal, float(manifold.normal_x), float(manifold.normal_y)
    return bool(manifold.point_count > 0 and nx * x + ny * y > 0.0 and abs(nx * y - ny * x) < _PARALLEL)


def _edge_number(a: Shape, b: Shape, axis: Axis) -> int | None:
    return None if axis.owner == 2 else (a, b)[axis.owner].edge_numbers[axis.edge]
