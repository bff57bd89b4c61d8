"""Cores for tests: random ones, and those whose features tie."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st

from sandbox._jit import kernel_argument
from sandbox.geometry import manifold
from sandbox.geometry.core import CoreRows
from sandbox.geometry.manifold import MANIFOLD
from sandbox.geometry.mass import edge_normals
from sandbox.world.records import VERTEX
from tests.kernels import called_from_python

collide_cores = called_from_python(manifold.collide_cores)
Core = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class Case:
    """Two cores, each about its own centre, the way from a to b, and the radii."""

    a: Core
    b: Core
    way: tuple[float, float]
    radius_a: float = 0.0
    radius_b: float = 0.0

    def swapped(self) -> Case:
        """The same two shapes in the other order."""
        return Case(self.b, self.a, (-self.way[0], -self.way[1]), self.radius_b, self.radius_a)

    def table(self):
        """Both cores in one vertex table: a first, then b."""
        rows = VERTEX.zeros(len(self.a) + len(self.b))
        for i, core in ((0, self.a), (len(self.a), self.b)):
            for k, (vertex, normal) in enumerate(zip(core, edge_normals(core), strict=True)):
                rows[i + k] = (*vertex, *normal)
        return rows

    def cores(self) -> tuple[CoreRows, CoreRows]:
        """Where both lie in the table."""
        na, nb = len(self.a), len(self.b)
        return CoreRows(0, na, self.radius_a), CoreRows(na, nb, self.radius_b)

    def collide(self, margin: float, face_bias: float = 0.0):
        """The kernel's manifold row, and the number of points it returned."""
        out = MANIFOLD.zeros(1)
        table = kernel_argument(self.table())
        count = collide_cores(table, *self.cores(), *self.way, margin, face_bias, kernel_argument(out))
        return out[0], count


numbers = st.floats(-3.0, 3.0, allow_nan=False, width=32)
angles = st.floats(-math.pi, math.pi)


def turned(core: Core, angle: float) -> Core:
    """A core turned about its centre."""
    c, s = math.cos(angle), math.sin(angle)
    return tuple((c * x - s * y, s * x + c * y) for x, y in core)


def box(width: float, height: float) -> Core:
    """A box about its middle."""
    x, y = 0.5 * width, 0.5 * height
    return ((-x, -y), (x, -y), (x, y), (-x, y))


def is_solid(core: Core) -> bool:
    """Whether a polygon has no tiny edge and turns left everywhere."""
    p = np.array(core)
    e = np.roll(p, -1, axis=0) - p
    turn = e[:, 0] * np.roll(e[:, 1], -1) - e[:, 1] * np.roll(e[:, 0], -1)
    return bool(np.hypot(e[:, 0], e[:, 1]).min() > 1e-3 and turn.min() > 1e-5)


@st.composite
def polygons(draw: st.DrawFn) -> Core:
    """Convex polygons: points of an ellipse, turned."""
    around = sorted(draw(st.lists(st.floats(0.0, 2 * math.pi), min_size=3, max_size=8)))
    width, height = draw(st.floats(0.1, 2.0)), draw(st.floats(0.1, 2.0))
    core = tuple((width * math.cos(t), height * math.sin(t)) for t in around)
    assume(is_solid(core))
    return turned(core, draw(angles))


@st.composite
def lines(draw: st.DrawFn) -> Core:
    """Cores of capsules and segments."""
    half = draw(st.floats(0.05, 2.0))
    return turned(((-half, 0.0), (half, 0.0)), draw(st.just(0.0) | angles))


points = st.tuples(st.tuples(numbers, numbers))
boxes = st.builds(turned, st.builds(box, st.floats(0.1, 3.0), st.floats(0.1, 3.0)), st.just(0.0) | angles)
cores = points | lines() | polygons() | boxes
radii = st.just(0.0) | st.floats(0.01, 1.0)
ways = st.tuples(numbers, numbers)


def solid(case: Case) -> Case:
    """The case with a radius around every single point: a disc without one is no shape."""
    radius_a = case.radius_a or (0.5 if len(case.a) == 1 else 0.0)
    radius_b = case.radius_b or (0.5 if len(case.b) == 1 else 0.0)
    return Case(case.a, case.b, case.way, radius_a, radius_b)


random_cases = st.builds(Case, cores, cores, ways, radii, radii).map(solid)

halves = st.integers(-6, 6).map(lambda k: 0.5 * k)
grid_boxes = st.builds(box, st.integers(1, 4).map(float), st.integers(1, 4).map(float))
LYING, STANDING, POINT = ((-1.0, 0.0), (1.0, 0.0)), ((0.0, -1.0), (0.0, 1.0)), ((0.0, 0.0),)
grid_cores = grid_boxes | st.sampled_from([LYING, STANDING, POINT])
grid_radii = st.sampled_from([0.0, 0.25, 0.5])
tied_cases = st.builds(Case, grid_cores, grid_cores, st.tuples(halves, halves), grid_radii, grid_radii).map(solid)
"""Cores on a coarse grid: aligned faces, corners on corners, equal depths, the same pose."""

cases = random_cases | tied_cases
