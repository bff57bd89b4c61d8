"""Closest vertices against exact arithmetic and against brute force over all features."""

from __future__ import annotations

import math
import random

import pytest
from hypothesis import assume, given

from sandbox._jit import kernel_argument
from sandbox.geometry import closest, closest_vertices, sat
from sandbox.geometry.sat import FAR
from tests.examples import examples
from tests.geometry.convex_cases import Case, cases, random_cases
from tests.kernels import called_from_python
from tests.naive import convex

face_separation = called_from_python(sat.face_separation)
closest_points = called_from_python(closest.closest_points)
vertices_of = called_from_python(closest_vertices.closest_vertices)
SLIGHTLY = 1e-9


def best_face(case: Case):
    """(separation, whether it is one of b, face), as the separating-axis test finds it; None for two points."""
    a, b = case.cores()
    (dx, dy), table = case.way, kernel_argument(case.table())
    of_a, face_a = face_separation(table, a, b, dx, dy, FAR)
    of_b, face_b = face_separation(table, b, a, -dx, -dy, FAR)
    if face_a < 0 and face_b < 0:
        return None
    flip = face_a < 0 or (face_b >= 0 and of_b > of_a)
    return (of_b, True, face_b) if flip else (of_a, False, face_a)


@given(random_cases)
def test_closest_vertices_are_the_closest_features_or_none(case):
    a, b = convex.exact(case.a), convex.exact(case.b, *case.way)
    square = convex.square_distance(a, b)
    assume(square > 1e-12)
    best = best_face(case)
    assume(best is not None)
    table = kernel_argument(case.table())
    least = max(best[0], 0.0) + 1e-12
    yes, i, j, nx, ny, distance = vertices_of(table, *case.cores(), *case.way, best[1], best[2], least)
    apart = min(convex.square_between(p, q) for p in a for q in b)
    if apart > square * (1 + convex.Fraction(1, 10**9)):
        assert not yes, "an edge is clearly nearer than any pair of vertices"
        return
    if convex.root(square) > least + SLIGHTLY:
        assert yes, "no face is as near"
    if yes:
        assert distance == pytest.approx(convex.root(square), rel=1e-9)
        assert convex.square_between(a[i], b[j]) <= square * (1 + convex.Fraction(1, 10**9))
        way = float(b[j][0] - a[i][0]), float(b[j][1] - a[i][1])
        assert (nx * distance, ny * distance) == pytest.approx(way, abs=1e-12)
        assert math.hypot(nx, ny) == pytest.approx(1.0, abs=1e-15)


@given(random_cases | cases)
@examples(400)
def test_the_same_vertices_as_of_all_features(case):
    assert_as_brute_force(case)


def test_the_same_vertices_as_of_all_features_of_boxes_that_lie_flat():
    """Their faces are parallel, so that many features are as close."""
    chance = random.Random(3)
    box = ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))
    seen = 0
    for _ in range(500):
        way = chance.choice((1.0, 1.01, 1.5)), chance.choice((-1.2, -1.0, -0.5, 0.0, 0.5, 1.0, 1.2))
        seen += assert_as_brute_force(Case(box, box, way if chance.random() < 0.5 else way[::-1]))
    assert seen > 50


def assert_as_brute_force(case: Case) -> bool:
    """With the best face and with any other. Returns whether the case has closest vertices."""
    best = best_face(case)
    if best is None or best[0] < 0.0:
        return False
    table = kernel_argument(case.table())
    square, _ax, _ay, _bx, _by, both, i, j = closest_points(table, *case.cores(), *case.way)
    distance = math.sqrt(square)
    least = best[0] + SLIGHTLY
    expected = both and distance > least
    for flip, core in ((False, case.a), (True, case.b)):
        for face in range(len(core) if len(core) > 1 else 0):
            found = vertices_of(table, *case.cores(), *case.way, flip, face, least)
            assert found[0] == expected or distance == pytest.approx(least, rel=1e-12)
            if not (found[0] and expected):
                continue
            assert found[5] == pytest.approx(distance, rel=1e-12)
            way = case.b[found[2]][0] + case.way[0], case.b[found[2]][1] + case.way[1]
            as_near = math.dist(case.a[found[1]], way) == pytest.approx(distance, rel=1e-12)
            assert as_near or (found[1], found[2]) == (i, j)
    return expected
