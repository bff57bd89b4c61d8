"""The rows of the separating-axis table: one axis each, with the two intervals that the shapes cast on it.

Axes are not normalised and vertices are those of the author, so whole numbers stay whole. Every number is exact
(`fractions`) and rounded once at the end: the rows are the definition of the test, written as a person would do it
on paper. What the engine runs is `geometry/sat.py`; tests hold the two against each other.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal, NamedTuple

from sandbox.geometry.shapes import Shape

Vec = tuple[float, float]
Exact = tuple[Fraction, Fraction]
Owner = Literal["a", "b", "corners"]


@dataclass(frozen=True)
class SatRow:
    """One axis of the test.

    `owner` is whose edge gave the axis, or `corners` for the axis between the two nearest vertices of rounded shapes.
    `edge` is the author's number of the edge from 1, or of the vertex of a; `other` that of the vertex of b, else 0.
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

    @property
    def length(self) -> float:
        """Length of the axis in metres: divide a projection by it to get metres."""
        return math.hypot(*self.axis)


class _Axis(NamedTuple):
    """Where an axis comes from, and its exact direction."""

    owner: Owner
    edge: int
    other: int
    x: Fraction
    y: Fraction


def sat_rows(a: Shape, b: Shape) -> Iterator[SatRow]:
    """The rows of all axes: edges of a, edges of b, then the one between the nearest vertices if a shape is round."""
    for number, axis in enumerate(_axes(a, b), start=1):
        yield _row(number, axis, a, b)


def count_axes(a: Shape, b: Shape) -> int:
    """How many rows there are."""
    return len(_axes(a, b))


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
    pairs = [(i, j) for i in range(len(a.vertices)) for j in range(len(b.vertices))]

    def square(pair: tuple[int, int]) -> Fraction:
        (px, py), (qx, qy) = _exact(a.vertices[pair[0]]), _exact(b.vertices[pair[1]])
        return (qx - px) ** 2 + (qy - py) ** 2

    return min(pairs, key=square)


def _axes(a: Shape, b: Shape) -> list[_Axis]:
    axes = [_perpendicular("a", *edge) for edge in author_edges(a)]
    axes += [_perpendicular("b", *edge) for edge in author_edges(b)]
    if a.radius > 0.0 or b.radius > 0.0:
        i, j = nearest_vertices(a, b)
        (px, py), (qx, qy) = _exact(a.vertices[i]), _exact(b.vertices[j])
        numbers = _vertex_number(a, i), _vertex_number(b, j)
        if (px, py) != (qx, qy):
            axes.append(_Axis("corners", *numbers, qx - px, qy - py))
        elif not axes:
            # Concentric discs: any axis will do, and the engine takes this one.
            axes.append(_Axis("corners", *numbers, Fraction(0), Fraction(1)))
    return axes


def _perpendicular(owner: Owner, number: int, start: Vec, end: Vec) -> _Axis:
    (px, py), (qx, qy) = _exact(start), _exact(end)
    return _Axis(owner, number, 0, -(qy - py), qx - px)


def _row(number: int, axis: _Axis, a: Shape, b: Shape) -> SatRow:
    alow, ahigh = _core_interval(a, axis)
    blow, bhigh = _core_interval(b, axis)
    square = axis.x * axis.x + axis.y * axis.y
    length = _root(square)
    core_gap, way = max((blow - ahigh, 1), (alow - bhigh, -1))
    radii = Fraction(a.radius) + Fraction(b.radius)
    # Intervals that only touch have nothing in common: a gap of 0 is a gap.
    gap = core_gap >= 0 and core_gap * core_gap >= radii * radii * square
    return SatRow(
        number, axis.owner, axis.edge, axis.other, (float(axis.x), float(axis.y)),
        _grown(alow, -a.radius, length), _grown(ahigh, a.radius, length),
        _grown(blow, -b.radius, length), _grown(bhigh, b.radius, length),
        gap, math.copysign(_root(core_gap * core_gap / square), core_gap) - float(radii), way,
    )  # fmt: skip


def _core_interval(shape: Shape, axis: _Axis) -> tuple[Fraction, Fraction]:
    """Least and greatest dot product of a core vertex and the axis."""
    dots = [x * axis.x + y * axis.y for x, y in map(_exact, shape.vertices)]
    return min(dots), max(dots)


def _grown(projection: Fraction, radius: float, length: float) -> float:
    """The end of an interval once the shape is rounded: a radius reaches as far as the axis is long."""
    return float(projection) if radius == 0.0 else float(projection) + radius * length


def _vertex_number(shape: Shape, index: int) -> int:
    return shape.given.index(shape.vertices[index]) + 1


def _is_backwards(numbers: Sequence[int]) -> bool:
    """Whether the author went clockwise: then the numbers fall along the core, which goes the other way."""
    return sum(numbers[i] < numbers[i - 1] for i in range(len(numbers))) > 1


def _exact(point: Vec) -> Exact:
    return Fraction(point[0]), Fraction(point[1])


def _root(square: Fraction) -> float:
    """Square root of a rational, without under- or overflow on the way."""
    if square == 0:
        return 0.0
    shift = (square.numerator.bit_length() - square.denominator.bit_length()) // 2
    return math.ldexp(math.sqrt(square / Fraction(4) ** shift), shift)
