"""The separating-axis test of one pair in whole numbers: what decides where floats cannot tell a touch from an overlap.

All coordinates are times one power of two, so every number here is exact. An axis is not normalised: an interval gap
is (min of b) - (max of a) along it, and real lengths are that divided by the axis' length.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from math import isqrt, nextafter

from sandbox.geometry.exact import Point, scaled
from sandbox.geometry.shapes import Core

Vec = tuple[float, float]

FACE_OF_A, FACE_OF_B, CORNERS = 0, 1, 2
"""Who gave an axis, as in a manifold."""

_BITS = 128
"""Extra bits of a square root."""


@dataclass(frozen=True)
class Axis:
    """One axis of the test: (x, y) points from a to b; `edge` is the face of its owner.

    For corners it is the vertex of a, and `corner` that of b.
    """

    owner: int
    edge: int
    corner: int
    x: int
    y: int
    gap: int

    @property
    def square(self) -> int:
        """Length of the axis squared."""
        return self.x * self.x + self.y * self.y

    @property
    def normal(self) -> Vec:
        """Unit normal."""
        length = isqrt(self.square << (2 * _BITS))
        return (self.x << _BITS) / length, (self.y << _BITS) / length


class ExactPair:
    """Two shapes in whole numbers."""

    def __init__(self, a: Core, b: Core) -> None:
        numbers, self.unit = scaled([*a.vertices, *b.vertices, (a.radius, b.radius)])
        self.a, self.b = numbers[: len(a.vertices)], numbers[len(a.vertices) : -1]
        self.radii = sum(numbers[-1])

    def axis(self, owner: int, edge: int, corner: int) -> Axis:
        """The axis a manifold names: of a face, or from vertex `edge` of a to vertex `corner` of b."""
        if owner == CORNERS:
            return self._corner_axis(edge, corner)
        return self._face_axis(owner, edge)

    def best(self) -> Axis:
        """The axis of largest gap, or least overlap; of equal ones the first: faces of a, faces of b, corners."""
        axes = [self._face_axis(FACE_OF_A, i) for i in _faces(self.a)]
        axes += [self._face_axis(FACE_OF_B, i) for i in _faces(self.b)]
        axes.append(self._corner_axis(*self._closest_corners()))
        found = axes[0]
        for axis in axes[1:]:
            if axis.gap * abs(axis.gap) * found.square > found.gap * abs(found.gap) * axis.square:
                found = axis
        return found

    def compare(self, axis: Axis, shift: Point = (0, 0), per: int = 1) -> int:
        """Sign of the gap along an axis, radii included, with b moved by `shift` / `per`: 1 apart, 0 touching, -1."""
        gap = axis.gap * per + axis.x * shift[0] + axis.y * shift[1]
        needed = self.radii * per
        difference = gap * abs(gap) - needed * needed * axis.square
        return (difference > 0) - (difference < 0)

    def separation(self, axis: Axis) -> float:
        """Signed gap along an axis in metres, radii included; right to the last bits, however small."""
        length = isqrt(axis.square << (2 * _BITS))  # the real one, times 2^_BITS
        if axis.gap <= 0:
            return ((axis.gap << _BITS) - self.radii * length) / (length * self.unit)
        # gap - radii * length would cancel where the two are nearly equal: their squares are whole numbers.
        squares = axis.gap * axis.gap - self.radii * self.radii * axis.square
        summed = (axis.gap << _BITS) + self.radii * length
        return (squares << (2 * _BITS)) / (summed * length * self.unit)

    def way_out(self, axis: Axis) -> tuple[float, Vec]:
        """(depth, mtv) in metres: the least depth in floats for which depth * normal parts the pair exactly."""
        nx, ny = axis.normal
        depth = -self.separation(axis)
        while True:
            mtv = depth * nx, depth * ny
            (shift,), per = scaled([mtv])
            if self.compare(axis, (shift[0] * self.unit, shift[1] * self.unit), per) >= 0:
                return depth, mtv
            depth = nextafter(depth, float("inf"))

    def _face_axis(self, owner: int, edge: int) -> Axis:
        core = self.a if owner == FACE_OF_A else self.b
        (x0, y0), (x1, y1) = core[edge], core[(edge + 1) % len(core)]
        return (
            self._along(owner, edge, 0, y1 - y0, x0 - x1)
            if owner == FACE_OF_A
            else self._along(owner, edge, 0, y0 - y1, x1 - x0)
        )

    def _corner_axis(self, i: int, j: int) -> Axis:
        x, y = self.b[j][0] - self.a[i][0], self.b[j][1] - self.a[i][1]
        return self._along(CORNERS, i, j, x, y) if x or y else self._along(CORNERS, i, j, 0, 1)

    def _along(self, owner: int, edge: int, corner: int, x: int, y: int) -> Axis:
        gap = min(x * p[0] + y * p[1] for p in self.b) - max(x * p[0] + y * p[1] for p in self.a)
        return Axis(owner, edge, corner, x, y, gap)

    def _closest_corners(self) -> tuple[int, int]:
        def square(pair: tuple[int, int]) -> int:
            (ax, ay), (bx, by) = self.a[pair[0]], self.b[pair[1]]
            return (bx - ax) ** 2 + (by - ay) ** 2

        return min(product(range(len(self.a)), range(len(self.b))), key=square)


def _faces(core: list[Point]) -> range:
    return range(len(core) if len(core) > 1 else 0)
