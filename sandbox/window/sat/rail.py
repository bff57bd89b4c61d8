"""An axis laid beside two shapes that are seen through a camera: where it lies, and what is cast on it."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.geometry.sat_rows import Vec
from sandbox.geometry.sat_table import SatTable
from sandbox.geometry.shapes import Shape
from sandbox.render.camera import Camera
from sandbox.render.rail_geometry import extreme_point, rail_point
from sandbox.render.sat_page import in_sight

AWAY_PIXELS, EDGE_PIXELS = 52.0, 30.0
"""How far the rail lies from the shapes, and how near to the edge of the view it may come."""

LEAST_SEEN = 3
"""Of 9 places along a rail, how many must be in sight."""


@dataclass(frozen=True)
class Rail:
    """A rail. `unit` is the axis' unit vector; along it `a` and `b` are intervals in metres from the origin's foot.

    The rail lies `aside` metres to the left of the axis through the origin; `outwards` (1 or -1) leads from the shapes
    to it and on.
    """

    unit: Vec
    aside: float
    outwards: float
    a: tuple[float, float]
    b: tuple[float, float]

    @property
    def shared(self) -> tuple[float, float]:
        """What both intervals cover, or what lies between them (m): low, high."""
        low, high = sorted((max(self.a[0], self.b[0]), min(self.a[1], self.b[1])))
        return low, high

    @property
    def separation(self) -> float:
        """The gap (m); negative, the shortest way out along the axis."""
        return max(self.b[0] - self.a[1], self.a[0] - self.b[1])

    @property
    def way(self) -> int:
        """1 if b leaves along the unit vector, -1 if it leaves against it."""
        return 1 if self.b[0] - self.a[1] >= self.a[0] - self.b[1] else -1

    def at(self, along: float, off: float = 0.0) -> Vec:
        """The point of the rail `along` metres, `off` metres farther from the shapes."""
        return rail_point(self.unit, along, self.aside + self.outwards * off)


def rail_of(table: SatTable, axis: Vec, camera: Camera) -> Rail:
    """The rail of an axis where a camera sees it: beyond both shapes if there is room, else beyond the smaller one."""
    long = (axis[0] * axis[0] + axis[1] * axis[1]) ** 0.5
    unit = axis[0] / long, axis[1] / long
    a, b = interval(table.a, unit), interval(table.b, unit)
    aside, outwards = _place(table, unit, camera)
    return Rail(unit, aside, outwards, a, b)


def interval(shape: Shape, unit: Vec) -> tuple[float, float]:
    """Least and greatest place of a shape along a unit vector (m)."""
    along = [x * unit[0] + y * unit[1] for x, y in shape.vertices]
    return min(along) - shape.radius, max(along) + shape.radius


def drops(shape: Shape, unit: Vec) -> tuple[tuple[Vec, Vec], list[Vec]]:
    """The points that are cast on the two ends of its interval, and all corners."""
    return (extreme_point(shape, unit, False), extreme_point(shape, unit, True)), list(shape.vertices)


def _place(table: SatTable, unit: Vec, camera: Camera) -> tuple[float, float]:
    """(aside, outwards): beyond both shapes, or, if that is out of sight, beyond the smaller one.

    Of the two sides it is the one on which more of the rail is in sight; of equals, below the shapes or to the right.
    """
    left = -unit[1], unit[0]
    # A level rail reads best below the shapes, an upright one to the right of them.
    first = 1.0 if (unit[0] < 0.0 if abs(unit[0]) >= abs(unit[1]) else unit[1] < 0.0) else -1.0
    small = min((table.a, table.b), key=lambda shape: _size(interval(shape, left)))
    away = AWAY_PIXELS / camera.scale
    places = [
        (_edge(shapes, left, side) + side * away, side)
        for shapes in (in_sight(table), (small,))
        for side in (first, -first)
    ]
    ends = [interval(shape, unit) for shape in in_sight(table)]
    low, high = min(start for start, _ in ends), max(end for _, end in ends)
    along = [low + (high - low) * k / 8 for k in range(9)]

    def seen(place: tuple[float, float]) -> int:
        return sum(_sees(camera, rail_point(unit, at, place[0])) for at in along)

    best = max(places[:2], key=seen)
    return best if seen(best) >= LEAST_SEEN else max(places[2:], key=seen)


def _edge(shapes: tuple[Shape, ...], left: Vec, side: float) -> float:
    """How far shapes reach to the left (1) or to the right (-1) of the axis."""
    ends = [interval(shape, left) for shape in shapes]
    return max(high for _, high in ends) if side > 0.0 else min(low for low, _ in ends)


def _sees(camera: Camera, point: Vec) -> bool:
    x, y = camera.to_screen(point)
    width, height = camera.size
    return bool(EDGE_PIXELS <= x <= width - EDGE_PIXELS and EDGE_PIXELS <= y <= height - EDGE_PIXELS)


def _size(ends: tuple[float, float]) -> float:
    return ends[1] - ends[0]
