"""Queries by definition: every shape of a world as exact rationals, one after the other.

What decides is `gap`: the signed separation of two rounded cores. A ray is a core of two points, a moving shape the
hull of where it begins and where it ends.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from sandbox.world.state import State
from tests.naive.convex import Point, dot, separation


@dataclass(frozen=True)
class Solid:
    """A shape in the world: its exact core, its radius, and the lengths that rounding works on."""

    index: int
    body: int
    core: list[Point]
    radius: float
    center: tuple[float, float]
    extent: float

    def behind(self, normal: tuple[float, float], point: tuple[float, float]) -> float:
        """How far the shape reaches beyond the line through `point` with that outward normal."""
        n = Fraction(normal[0]), Fraction(normal[1])
        p = Fraction(point[0]), Fraction(point[1])
        return float(max(dot(n, v) for v in self.core) - dot(n, p)) + self.radius


def solids(state: State) -> list[Solid]:
    """Every shape of a world where it lies now."""
    found = []
    for i, shape in enumerate(state.shapes):
        body = state.bodies[int(shape.body)]
        c, s = Fraction(float(body.rotation_cos)), Fraction(float(body.rotation_sin))
        x, y = float(body.center_x), float(body.center_y)
        core = []
        for row in state.vertices[int(shape.vertex_start) : int(shape.vertex_start + shape.vertex_count)]:
            u, v = Fraction(float(row.x)), Fraction(float(row.y))
            core.append((Fraction(x) + c * u - s * v, Fraction(y) + s * u + c * v))
        found.append(Solid(i, int(shape.body), core, float(shape.radius), (x, y), float(body.extent)))
    return found


def hull(points: list[Point]) -> list[Point]:
    """Convex hull, counter-clockwise, without points on its edges (A. Andrew 1979)."""
    order = sorted(set(points))
    if len(order) < 3:
        return order
    sides: list[list[Point]] = []
    for row in (order, order[::-1]):
        side: list[Point] = []
        for p in row:
            while len(side) > 1 and _turn(side[-2], side[-1], p) <= 0:
                side.pop()
            side.append(p)
        sides.append(side[:-1])
    return sides[0] + sides[1]


def _turn(p: Point, q: Point, r: Point) -> Fraction:
    return (q[0] - p[0]) * (r[1] - q[1]) - (q[1] - p[1]) * (r[0] - q[0])


def swept(core, way: tuple[float, float], fraction: float = 1.0) -> list[Point]:
    """What a core covers on the first `fraction` of its way."""
    x, y = Fraction(way[0]) * Fraction(fraction), Fraction(way[1]) * Fraction(fraction)
    start = [(Fraction(u), Fraction(v)) for u, v in core]
    return hull(start + [(u + x, v + y) for u, v in start])


def gap(a: list[Point], a_radius: float, b: list[Point], b_radius: float) -> float:
    """Signed separation of two rounded cores."""
    return separation(a, b) - (a_radius + b_radius)


def unit(solid: Solid, place: tuple[float, float], way: tuple[float, float] = (0.0, 0.0), size: float = 0.0) -> float:
    """What the rounding of floats may make of these lengths, all measured from the body's centre."""
    lengths = [place[0] - solid.center[0], place[1] - solid.center[1], *way, solid.extent, size]
    return 2.0**-52 * math.fsum(abs(value) for value in lengths)
