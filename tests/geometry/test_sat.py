"""The separating-axis kernels against the definition in exact arithmetic."""

from __future__ import annotations

import math

import pytest
from hypothesis import assume, given

from sandbox._jit import kernel_argument
from sandbox.geometry import closest, sat
from sandbox.geometry.core import CoreRows
from sandbox.geometry.sat import FAR
from tests.geometry.convex_cases import Case, angles, cases, cores, numbers
from tests.kernels import called_from_python
from tests.naive import convex

face_separation = called_from_python(sat.face_separation)
facing_edge = called_from_python(sat.facing_edge)
support_vertex = called_from_python(sat.support_vertex)
nearest_on_edges = called_from_python(closest.nearest_on_edges)


def exact_pair(case: Case):
    """Both cores as rationals in the frame of a."""
    return convex.exact(case.a), convex.exact(case.b, *case.way)


@given(cases)
def test_face_separation_is_the_best_face_normal(case):
    got, face = face_separation(kernel_argument(case.table()), *case.cores(), *case.way, FAR)
    axes = convex.face_axes(*exact_pair(case))
    if not axes:
        assert (got, face) == (-FAR, -1)
        return
    assert got == pytest.approx(convex.best_axis(axes).length(), abs=1e-12)
    assert axes[face].length() == pytest.approx(got, abs=1e-12)


@given(cases)
def test_face_separation_stops_at_an_axis_that_separates_enough(case):
    full, _ = face_separation(kernel_argument(case.table()), *case.cores(), *case.way, FAR)
    got, face = face_separation(kernel_argument(case.table()), *case.cores(), *case.way, 0.1)
    assert (got > 0.1) == (full > 0.1)
    if face >= 0:
        assert convex.face_axes(*exact_pair(case))[face].length() == pytest.approx(got, abs=1e-12)


@given(cores, angles)
def test_support_vertex_is_the_deepest_one(core, angle):
    n = math.cos(angle), math.sin(angle)
    table = kernel_argument(Case(core, ((0.0, 0.0),), (0.0, 0.0)).table())
    along = [n[0] * x + n[1] * y for x, y in core]
    assert along[support_vertex(table, CoreRows(0, len(core), 0.0), *n)] == pytest.approx(min(along), abs=1e-15)


@given(cores, angles)
def test_facing_edge_looks_most_against_the_direction(core, angle):
    assume(len(core) > 1)
    n = math.cos(angle), math.sin(angle)
    table = kernel_argument(Case(core, ((0.0, 0.0),), (0.0, 0.0)).table())
    against = []
    for (x0, y0), (x1, y1) in zip(core, [*core[1:], core[0]], strict=True):
        against.append((n[0] * (y1 - y0) + n[1] * (x0 - x1)) / math.hypot(x1 - x0, y1 - y0))
    assert against[facing_edge(table, CoreRows(0, len(core), 0.0), *n)] == pytest.approx(min(against), abs=1e-12)


@given(cores, numbers, numbers)
def test_nearest_on_edges_is_the_nearest_boundary_point(core, x, y):
    table = kernel_argument(Case(core, ((0.0, 0.0),), (0.0, 0.0)).table())
    square, qx, qy, feature, is_vertex = nearest_on_edges(table, CoreRows(0, len(core), 0.0), x, y)
    p, shape = convex.exact([(x, y)])[0], convex.exact(core)
    assert square == pytest.approx(float(convex.square_to_boundary(p, shape)), abs=1e-12)
    assert convex.square_to_boundary(convex.exact([(qx, qy)])[0], shape) < 1e-24
    assert math.hypot(qx - x, qy - y) == pytest.approx(math.sqrt(square), abs=1e-12)
    assert 0 <= feature < len(core)
    if is_vertex:
        assert (qx, qy) == core[feature]
    else:
        nearest = convex.nearest_on_segment(p, convex.edges(shape)[feature])
        assert convex.square_between(nearest, convex.exact([(qx, qy)])[0]) < 1e-24
