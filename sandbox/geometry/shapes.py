"""Shapes as plain values, in metres and world coordinates: to ask about geometry without a world.

They are immutable and checked when they are made: what exists can be asked about.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from math import ulp
from typing import Self

from sandbox._jit import interpreted
from sandbox.errors import ShapeError
from sandbox.geometry.checks import Vec, checked_number, checked_point, checked_points, checked_size
from sandbox.geometry.polygon import MAX_VERTICES, PolygonError, convex_corners
from sandbox.geometry.shape import Core, Shape, edge_numbers
from sandbox.geometry.trig import cos_sin

__all__ = ["Box", "Capsule", "Circle", "Core", "Polygon", "Segment", "Shape"]

_cos_sin = interpreted(cos_sin)
_STRAIGHT = 10**13
"""A corner of a `Polygon` flatter than its size divided by this is dropped: it is below what the test can tell."""


@dataclass(frozen=True)
class Circle(Shape):
    """A disc: its centre (x, y) and its radius, metres. Raises `ShapeError`."""

    center: Vec
    radius: float

    def __post_init__(self) -> None:
        center = checked_point("Circle", "the centre", self.center)
        radius = checked_size("Circle", "the radius", self.radius)
        self._set(center=center, radius=radius, vertices=(center,), given=(center,), edge_numbers=())

    def moved(self, translation: Sequence[float]) -> Self:
        """The disc about a centre moved by `translation` (m)."""
        return replace(self, center=_plus(self.center, translation))


@dataclass(frozen=True)
class Capsule(Shape):
    """All points within `radius` of the line from p to q, metres. Raises `ShapeError`."""

    p: Vec
    q: Vec
    radius: float

    def __post_init__(self) -> None:
        ends = _checked_ends("Capsule", self.p, self.q)
        radius = checked_size("Capsule", "the radius", self.radius)
        self._set(p=ends[0], q=ends[1], radius=radius, vertices=ends, given=ends, edge_numbers=(0, 0))

    def moved(self, translation: Sequence[float]) -> Self:
        """The capsule with both ends moved by `translation` (m)."""
        return replace(self, p=_plus(self.p, translation), q=_plus(self.q, translation))


@dataclass(frozen=True)
class Segment(Shape):
    """The line from p to q, metres: it has two sides but no thickness. Raises `ShapeError`."""

    p: Vec
    q: Vec

    def __post_init__(self) -> None:
        ends = _checked_ends("Segment", self.p, self.q)
        self._set(p=ends[0], q=ends[1], vertices=ends, given=ends, edge_numbers=(0, 0))

    def moved(self, translation: Sequence[float]) -> Self:
        """The segment with both ends moved by `translation` (m)."""
        return replace(self, p=_plus(self.p, translation), q=_plus(self.q, translation))


@dataclass(frozen=True, repr=False)
class Polygon(Shape):
    """A convex polygon of 3 to 64 vertices in either winding, metres; `radius` rounds it outwards: it grows by that.

    Repeated vertices and ones on a straight side are dropped, and a dent of less than a billionth of the size is
    filled: `vertices` holds the corners that are left, counter-clockwise, beginning with the first of them given.
    Raises `PolygonError` (a `ShapeError`) with the `index` of the vertex to look at.
    """

    vertices: tuple[Vec, ...]
    radius: float = 0.0
    given: tuple[Vec, ...] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        given = checked_points("Polygon", self.vertices)
        if not 3 <= len(given) <= MAX_VERTICES:
            raise PolygonError(f"Polygon: needs 3 to {MAX_VERTICES} vertices, not {len(given)}")
        radius = checked_size("Polygon", "the radius", self.radius, zero=True)
        try:
            corners = convex_corners(given, _STRAIGHT)
        except PolygonError as error:
            raise PolygonError(_placed(error), error.index) from None
        vertices = tuple(given[i] for i in corners)
        self._set(given=given, radius=radius, vertices=vertices, edge_numbers=edge_numbers(given, corners))

    def __repr__(self) -> str:
        rounded = f", radius={self.radius!r}" if self.radius else ""
        return f"Polygon({self.given!r}{rounded})"

    def moved(self, translation: Sequence[float]) -> Self:
        """The polygon with every vertex moved by `translation` (m)."""
        return replace(self, vertices=tuple(_plus(point, translation) for point in self.given))


@dataclass(frozen=True)
class Box(Shape):
    """A rectangle of `width` by `height` metres about `at`, turned counter-clockwise by `angle` radians.

    Its corners are numbered counter-clockwise from the lower left one, as seen before turning. Raises `ShapeError`.
    """

    width: float
    height: float
    at: Vec = (0.0, 0.0)
    angle: float = 0.0

    def __post_init__(self) -> None:
        width = checked_size("Box", "the width", self.width)
        height = checked_size("Box", "the height", self.height)
        at = checked_point("Box", "its place", self.at)
        angle = checked_number("Box", "the angle", self.angle, "rad", 1e6)
        corners = _box_corners(width, height, at, angle)
        grain = ulp(max(abs(part) for corner in corners for part in corner))
        if 100.0 * grain > min(width, height):
            raise ShapeError(
                f"Box: {width:g} by {height:g} m is too small for its place: floats are {grain:g} m apart there"
            )
        self._set(width=width, height=height, at=at, angle=angle)
        self._set(vertices=corners, given=corners, edge_numbers=(0, 1, 2, 3))

    def moved(self, translation: Sequence[float]) -> Self:
        """The box about a middle moved by `translation` (m)."""
        return replace(self, at=_plus(self.at, translation))


def _plus(point: Vec, translation: Sequence[float]) -> Vec:
    x, y = checked_point("moved", "the translation", translation)
    return point[0] + x, point[1] + y


def _checked_ends(kind: str, p: Vec, q: Vec) -> tuple[Vec, Vec]:
    """Both ends of a line, at least a micrometre apart along one of the axes."""
    p, q = checked_point(kind, "the first end", p), checked_point(kind, "the second end", q)
    if max(abs(q[0] - p[0]), abs(q[1] - p[1])) < 1e-6:
        raise ShapeError(f"{kind}: the two ends are the same point; a point with a radius is a Circle")
    return p, q


def _placed(error: PolygonError) -> str:
    place = "" if error.index is None else f" (vertex {error.index}, counted from 0)"
    return f"Polygon: {error}{place}"


def _box_corners(width: float, height: float, at: Vec, angle: float) -> tuple[Vec, ...]:
    cos, sin = _cos_sin(angle)
    x, y = width / 2, height / 2
    around = [(-x, -y), (x, -y), (x, y), (-x, y)]
    return tuple((at[0] + (cos * u - sin * v) + 0.0, at[1] + (sin * u + cos * v) + 0.0) for u, v in around)
