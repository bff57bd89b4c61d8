"""The third referee against closed forms and against an independent exact definition."""

from __future__ import annotations

import math
from fractions import Fraction
from random import Random

import pytest
from hypothesis import given

from sandbox.reference.exact_referee import convex_hull, judge, nearest_line, overlap_along
from sandbox.reference.pair import Core, Pair
from tests.geometry.shape_families import FAMILIES
from tests.naive import convex, minkowski
from tests.reference.pairs import any_pairs, at, box, circle, line


@given(any_pairs)
def test_it_agrees_with_a_definition_over_points_and_edges(pair: Pair) -> None:
    a = convex.exact(pair.a.points, *pair.center_a)
    b = convex.exact(pair.b.points, *pair.center_b)
    radii = Fraction(pair.a.radius) + Fraction(pair.b.radius)
    square = convex.square_distance(a, b)
    truth = judge(pair)
    # Cores that cross have an inside in common, and then radii only add to the depth.
    crossing = square == 0 and convex.separation(a, b) < 0.0
    assert truth.overlap == (crossing or square < radii * radii)
    expected = convex.separation(a, b) - float(radii)
    assert truth.separation == pytest.approx(expected, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("family", FAMILIES)
def test_it_agrees_with_another_exact_referee(family: str) -> None:
    for k in range(60):
        a, b = FAMILIES[family](Random(f"compare/{family}/{k}"))
        pair = Pair(Core(a.vertices, a.radius), Core(b.vertices, b.radius))
        expected, truth = minkowski.separation(a, b), judge(pair)
        assert truth.overlap == (expected.sign < 0)
        assert truth.separation == pytest.approx(float(expected.value), rel=1e-15, abs=1e-300)


@pytest.mark.parametrize("gap", [0.0, 2.0**-52, -(2.0**-52)])
def test_a_last_bit_decides(gap: float) -> None:
    for pair in (at(circle(0.25), circle(0.75), (1.0 + gap, 0.0)), at(box(1, 1), box(1, 1), (1.0 + gap, 0.25))):
        assert judge(pair).overlap == (gap < 0.0)
        assert judge(pair).separation == gap


def test_shapes_that_touch_do_not_overlap() -> None:
    assert not judge(at(box(1, 1), box(1, 1), (1.0, 1.0))).overlap
    assert not judge(at(line((-1, 0), (1, 0)), line((0, 0), (0, 1)), (0.0, 0.0))).overlap
    assert not judge(at(line((-1, 0), (1, 0)), line((-1, 0), (1, 0)), (0.5, 0.0))).overlap
    assert judge(at(line((-1, 0), (1, 0)), line((0, -1), (0, 1)), (0.0, 0.0))).overlap


def test_the_depth_of_contained_and_equal_shapes_is_the_shortest_way_out() -> None:
    assert judge(at(box(4, 4), box(1, 1), (0.25, 0.0))).depth == 2.25
    assert judge(at(box(2, 1), box(2, 1), (0.0, 0.0))).depth == 1.0
    assert judge(at(circle(2), circle(0.5), (0.0, 0.0))).depth == 2.5
    assert judge(at(box(2, 2, 0.5), circle(0.25), (0.0, 0.5))).depth == 1.25


def test_rounded_corners_are_measured_between_corners() -> None:
    pair = at(box(1, 1, 0.5), box(1, 1, 0.25), (3.0, 4.0))
    assert judge(pair).separation == pytest.approx(math.hypot(2.0, 3.0) - 0.75, rel=1e-15)


@given(any_pairs)
def test_swapping_the_shapes_changes_nothing(pair: Pair) -> None:
    assert judge(Pair(pair.b, pair.a, pair.center_b, pair.center_a)) == judge(pair)


@given(any_pairs)
def test_no_direction_needs_less_than_the_depth(pair: Pair) -> None:
    truth = judge(pair)
    for k in range(12):
        direction = (math.cos(0.5 * k), math.sin(0.5 * k))
        assert overlap_along(pair, direction) >= -truth.separation - 1e-12


def test_nearest_line_is_zero_where_features_are_in_line() -> None:
    assert nearest_line(at(circle(0.1), box(1, 1), (-7.0, 0.5))) == 0.0
    assert nearest_line(at(circle(0.1), box(1, 1), (-7.0, 0.625))) == 0.125
    assert nearest_line(at(circle(0.1), circle(0.1), (1.0, 0.0))) == math.inf


def test_a_hull_leaves_out_what_is_inside_in_line_or_repeated() -> None:
    points = [(Fraction(x), Fraction(y)) for x, y in [(0, 0), (2, 0), (1, 0), (2, 2), (0, 2), (1, 1), (0, 0), (0, 1)]]
    assert convex_hull(points) == [(0, 0), (2, 0), (2, 2), (0, 2)]
    assert convex_hull(points[:1] * 3) == [(0, 0)]
    assert convex_hull(points[:3]) == [(0, 0), (2, 0)]
