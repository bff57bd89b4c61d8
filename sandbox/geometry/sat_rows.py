"""The rows of the separating-axis table: one axis each, with the two intervals that the shapes cast on it.

Axes are not normalised and vertices are those of the author, so whole numbers stay whole. Every number is exact (whole
numbers of a unit that is a power of two) and rounded once at the end: the rows are the definition of the test, written
as a person would do it on paper. What the engine runs is `geometry/sat.py`; tests hold the two against each other.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import Literal, NamedTuple

from sandbox.geometry.exact import Point, distance_squared, scaled
from sandbox.geometry.shapes import Shape

Vec = tuple[float, float]
Owner = Literal["a", "b", "corners"]
_OWNERS: tuple[Owner, Owner] = ("a", "b")


@dataclass(frozen=True)
class SatRow:
    """One axis of the test.

    `owner` is whose edge gave the axis, or `corners` for the axis between the two nearest vertices of rounded shapes.
    `edge` is the author's number of the edge from 1, or of the vertex of a; `other` that of the vertex of b, else 0.
    `centers` tells of these two vertices, of a and of b, whether they are the centre of a disc.
    `axis` is (-y, x) of the edge, in metres and not normalised; `amin` .. `bmax` are projections on it (m^2).
    `gap` tells whether the open intervals have nothing in common, `stopped` whether the test ended here.
    `separation` is the gap along the axis in metres; negative, it is the shortest way out along the axis,
    and b leaves along `way` times the axis (1 or -1).
    """

    number: int
    owner: Owner
    edge: int
    other: int
    axis: Vec
    amin: float
    amax: float
    bmin: float
    bmax: float
    gap: bool
    separation: float
    way: int
    stopped: bool = False
    centers: tuple[bool, bool] = (False, False)

    @property
    def length(self) -> float:
        """Length of the axis in metres: divide a projection by it to get metres."""
        return math.hypot(*self.axis)


def sat_rows(a: Shape, b: Shape) -> Iterator[SatRow]:
    """The rows of all axes: edges of a, edges of b, then the one between the nearest vertices if a shape is round."""
    whole = _Whole(a, b)
    for number, axis in enumerate(whole.axes(), start=1):
        yield whole.row(number, axis)


def count_axes(a: Shape, b: Shape) -> int:
    """How many rows there are."""
    return len(_Whole(a, b).axes())


def author_edges(shape: Shape) -> list[tuple[int, Vec, Vec]]:
    """(number from 1, start, end) of each edge, in the author's order and direction; a line has one edge."""
    core = shape.vertices
    if len(core) < 3:
        return [(1, core[0], core[1])] if len(core) == 2 else []
    edges = [(number + 1, core[i], core[(i + 1) % len(core)]) for i, number in enumerate(shape.edge_numbers)]
    if _is_backwards(shape.edge_numbers):
        edges = [(number, end, start) for number, start, end in edges]
    return sorted(edges, key=lambda edge: edge[0])


def corners_in_order(shape: Shape) -> tuple[Vec, ...]:
    """The core's vertices in the author's order."""
    edges = author_edges(shape)
    return tuple(start for _, start, _ in edges) if len(edges) > 2 else shape.vertices


def nearest_vertices(a: Shape, b: Shape) -> tuple[int, int]:
    """Indices into the cores of a and b of the two vertices that are nearest to each other; the first of equals."""
    return _Whole(a, b).nearest()


class _Axis(NamedTuple):
    """Where an axis comes from, and its direction in whole numbers."""

    owner: Owner
    edge: int
    other: int
    x: int
    y: int


class _Whole:
    """Both shapes in whole numbers: all coordinates and radii times one power of two, `unit`."""

    def __init__(self, a: Shape, b: Shape) -> None:
        self.shapes = a, b
        edges = [(owner, *edge) for owner, shape in zip(_OWNERS, (a, b), strict=True) for edge in author_edges(shape)]
        ends = [end for _, _, start, last in edges for end in (start, last)]
        points, self.unit = scaled([*a.vertices, *b.vertices, (a.radius, b.radius), *ends])
        count, before = len(a.vertices), len(a.vertices) + len(b.vertices)
        self.a, self.b, self.radii = points[:count], points[count:before], sum(points[before])
        self._edges = [(owner, number) for owner, number, _, _ in edges]
        self._ends = points[before + 1 :]

    def nearest(self) -> tuple[int, int]:
        pairs = product(range(len(self.a)), range(len(self.b)))
        return min(pairs, key=lambda pair: distance_squared(self.a[pair[0]], self.b[pair[1]]))

    def axes(self) -> list[_Axis]:
        axes = []
        for k, (owner, number) in enumerate(self._edges):
            (px, py), (qx, qy) = self._ends[2 * k], self._ends[2 * k + 1]
            axes.append(_Axis(owner, number, 0, py - qy, qx - px))
        if self.radii > 0:
            i, j = self.nearest()
            (px, py), (qx, qy) = self.a[i], self.b[j]
            numbers = _vertex_number(self.shapes[0], i), _vertex_number(self.shapes[1], j)
            if (px, py) != (qx, qy):
                axes.append(_Axis("corners", *numbers, qx - px, qy - py))
            elif not axes:
                # Concentric discs: any axis will do, and the engine takes this one.
                axes.append(_Axis("corners", *numbers, 0, self.unit))
        return axes

    def row(self, number: int, axis: _Axis) -> SatRow:
        alow, ahigh = _interval(self.a, axis)
        blow, bhigh = _interval(self.b, axis)
        square, unit = axis.x * axis.x + axis.y * axis.y, self.unit
        length = _root(Fraction(square, unit * unit))
        core_gap, way = max((blow - ahigh, 1), (alow - bhigh, -1))
        # Intervals that only touch have nothing in common: a gap of 0 is a gap.
        gap = core_gap >= 0 and core_gap * core_gap >= self.radii * self.radii * square
        apart = _root(Fraction(core_gap * core_gap, square * unit * unit))
        reach = self.shapes[0].radius, self.shapes[1].radius
        to_corners = axis.owner == "corners"
        return SatRow(
            number, axis.owner, axis.edge, axis.other, (axis.x / unit, axis.y / unit),
            self._end(alow, -reach[0], length), self._end(ahigh, reach[0], length),
            self._end(blow, -reach[1], length), self._end(bhigh, reach[1], length),
            gap, math.copysign(apart, 1 if core_gap >= 0 else -1) - self.radii / unit, way,
            centers=(to_corners and len(self.a) == 1, to_corners and len(self.b) == 1),
        )  # fmt: skip

    def _end(self, projection: int, radius: float, length: float) -> float:
        """The end of an interval once the shape is rounded: a radius reaches as far as the axis is long."""
        end = projection / (self.unit * self.unit)
        return end if radius == 0.0 else end + radius * length


def _interval(core: list[Point], axis: _Axis) -> tuple[int, int]:
    """Least and greatest dot product of a core vertex and the axis."""
    dots = [x * axis.x + y * axis.y for x, y in core]
    return min(dots), max(dots)


def _vertex_number(shape: Shape, index: int) -> int:
    return shape.given.index(shape.vertices[index]) + 1


def _is_backwards(numbers: Sequence[int]) -> bool:
    """Whether the author went clockwise: then the numbers fall along the core, which goes the other way."""
    return sum(numbers[i] < numbers[i - 1] for i in range(len(numbers))) > 1


def _root(square: Fraction) -> float:
    """Square root of a rational, without under- or overflow on the way."""
    if square == 0:
        return 0.0
    shift = (square.numerator.bit_length() - square.denominator.bit_length()) // 2
    return math.ldexp(math.sqrt(square / Fraction(4) ** shift), shift)
