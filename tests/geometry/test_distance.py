"""Distances, closest points and points in shapes: cases one can check by hand, and exact arithmetic."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import Box, Capsule, Circle, Distance, Polygon, Segment, ShapeError, contains, distance
from tests.geometry.judged import Spot
from tests.geometry.shape_families import pairs
from tests.naive.minkowski import separation

UNIT = Box(1, 1)


def test_distance_and_closest_points():
    found = distance(UNIT, Box(1, 1, at=(4, 5)))
    assert (found.value, found.points) == (5.0, ((0.5, 0.5), (3.5, 4.5)))  # 3-4-5
    found = distance(Circle((0, 0), 1), Capsule((3, -1), (3, 1), 0.5))
    assert (found.value, found.points) == (1.5, ((1.0, 0.0), (2.5, 0.0)))
    assert distance(UNIT, Box(0.1, 0.1)) == Distance(0.0, None)
    assert distance(Box(0.1, 0.1), UNIT) == Distance(0.0, None)


@pytest.mark.parametrize("aside", [1e-9, 1e-30, 1e-100, 1e-150])
def test_a_distance_is_right_however_small(aside):
    """A disc that touches another, moved along it: they part by the square of that."""
    found = distance(Circle((0, 0), 2), Circle((aside, 5), 3))
    assert found.value == pytest.approx(aside * aside / 10, rel=1e-15)


def test_contains_takes_the_outline_in():
    assert contains(UNIT, (0.5, 0.5))
    assert not contains(UNIT, (0.5, 0.5000000000000001))
    assert contains(Circle((0, 0), 5), (3, 4))
    assert not contains(Circle((0, 0), 5), (3, 4.000000000000001))
    assert contains(Segment((0, 0), (2, 4)), (1, 2))
    assert not contains(Segment((0, 0), (2, 4)), (1, 2.0000000000000004))
    assert contains(Polygon([(0, 0), (1, 0), (0, 1)], 0.625), (-0.375, -0.5))


@given(pairs, st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))
def test_contains_agrees_with_exact_arithmetic(pair, u, v):
    shape, other = pair
    (x, y), size = other.vertices[0], max(abs(part) for vertex in shape.vertices for part in vertex)
    for point in ((x, y), shape.vertices[-1], (x + u * size, y + v * size)):
        if max(abs(point[0]), abs(point[1])) <= 1e9:
            assert contains(shape, point) == (separation(shape, Spot((point,))).sign <= 0)


@pytest.mark.parametrize("point", [(1,), "ab", (1, None), (math.nan, 0), 3, (1e10, 0)])
def test_contains_refuses_what_is_no_point(point):
    with pytest.raises(ShapeError):
        contains(UNIT, point)
