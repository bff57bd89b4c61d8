"""Cleaning and refusing polygons: every decision against its definition, on random polygons too."""

from __future__ import annotations

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sandbox.geometry.polygon import PolygonError, convex_polygon

SQUARE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]


@st.composite
def convex(draw: st.DrawFn) -> list[tuple[float, float]]:
    """Corners on an ellipse, counter-clockwise, no two of them close."""
    count = draw(st.integers(3, 64))
    width, height = draw(st.floats(0.1, 1000)), draw(st.floats(0.1, 1000))
    shift = draw(st.floats(0, 1)), draw(st.floats(-1e5, 1e5)), draw(st.floats(-1e5, 1e5))
    turns = [(k + 0.3 * draw(st.floats(0, 1)) + shift[0]) * 2 * math.pi / count for k in range(count)]
    return [(shift[1] + width * math.cos(t), shift[2] + height * math.sin(t)) for t in turns]


def doubled_area(points) -> float:
    pairs = zip(points, [*points[1:], points[0]], strict=True)
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in pairs)


def rotated(points, by):
    by %= len(points)
    return [*points[by:], *points[:by]]


@given(convex())
def test_a_convex_polygon_is_kept_as_it_is(points):
    assert convex_polygon(points) == tuple(points)


@given(convex(), st.integers(0, 63))
def test_winding_is_turned_and_the_first_corner_stays_first(points, start):
    points = rotated(points, start)
    other_way = [points[0], *reversed(points[1:])]
    assert convex_polygon(other_way) == tuple(points)


@given(convex(), st.integers(0, 63))
def test_repeated_corners_are_dropped(points, place):
    place %= len(points)
    assert convex_polygon([*points[: place + 1], *points[place:]]) == tuple(points)
    assert convex_polygon([*points, points[0]]) == tuple(points)


@given(convex(), st.integers(0, 63), st.floats(0.1, 0.9))
def test_vertices_on_a_side_are_dropped(points, place, part):
    place %= len(points)
    (ax, ay), (bx, by) = points[place], points[(place + 1) % len(points)]
    on_side = (ax + part * (bx - ax), ay + part * (by - ay))
    assert convex_polygon([*points[: place + 1], on_side, *points[place + 1 :]]) == tuple(points)


@given(convex(), st.integers(0, 63), st.floats(0.1, 0.9))
def test_a_corner_pushed_to_the_middle_is_a_dent(points, place, part):
    assume(len(points) >= 8)
    place %= len(points)
    x, y = (sum(p[k] for p in points) / len(points) for k in (0, 1))
    corner = points[place]
    points[place] = (x + 0.1 * part * (corner[0] - x), y + 0.1 * part * (corner[1] - y))
    with pytest.raises(PolygonError, match="concave") as caught:
        convex_polygon(points)
    assert caught.value.index == place


@given(convex(), st.integers(0, 63))
def test_two_corners_exchanged_cross_sides(points, place):
    assume(len(points) > 3)
    place %= len(points)
    after = (place + 1) % len(points)
    points[place], points[after] = points[after], points[place]
    with pytest.raises(PolygonError, match="intersects itself"):
        convex_polygon(points)


@given(st.lists(st.tuples(st.integers(-4, 4), st.integers(-4, 4)), min_size=3, max_size=7))
def test_a_result_is_always_strictly_convex_with_the_input_area(points):
    try:
        corners = convex_polygon(points)
    except PolygonError:
        return
    ring = [*corners, *corners[:2]]
    for a, b, c in zip(ring, ring[1:], ring[2:], strict=False):
        assert (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) > 0
    assert doubled_area(corners) == abs(doubled_area(points))
    assert set(corners) <= set(points)


def crosses_itself(points) -> bool:
    """The naive twin: some two sides that are not neighbours share a point, in whole numbers."""

    def side(p, q, r):
        value = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
        return (value > 0) - (value < 0)

    def on(p, q, r):
        return side(p, q, r) == 0 and all(min(p[k], q[k]) <= r[k] <= max(p[k], q[k]) for k in (0, 1))

    def meet(a, b, c, d):
        proper = side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0
        return proper or on(a, b, c) or on(a, b, d) or on(c, d, a) or on(c, d, b)

    sides = list(zip(points, [*points[1:], points[0]], strict=True))
    count = len(sides)
    return any(
        meet(*sides[i], *sides[j])
        for i in range(count)
        for j in range(i + 2, count - (i == 0))
    )  # fmt: skip


@given(st.lists(st.tuples(st.integers(-4, 4), st.integers(-4, 4)), min_size=4, max_size=7, unique=True))
def test_only_polygons_that_cross_are_called_so(points):
    try:
        convex_polygon(points)
        told = ""
    except PolygonError as error:
        told = str(error)
    if told.startswith("the polygon is concave"):
        assert not crosses_itself(points)
    if "intersects" in told:
        assert crosses_itself(points) or folds_back(points)


def folds_back(points) -> bool:
    """Whether some corner turns by half a turn: its two sides lie on each other."""
    ring = [*points, *points[:2]]
    for a, b, c in zip(ring, ring[1:], ring[2:], strict=False):
        cross = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
        along = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1])
        if cross == 0 and along < 0:
            return True
    return False


@pytest.mark.parametrize(
    ("points", "told", "index"),
    [
        ([(0, 0), (1, 0), (2, 0)], "no area", None),
        ([(0, 0), (2, 0), (1, 0), (3, 0)], "no area", None),
        ([(5, 5)] * 4, "no area", None),
        ([(0, 0), (1, 0), (0, 0), (1, 0)], "no area", None),
        ([(0, 0), (1, 0), (1, 1e-7)], "less than 1e-06 m apart", 2),
        ([(0, 0), (1000, 0), (500, 1e-7)], "no area", None),
        ([(0, 0), (1, 0), (0.5, 5e-7)], "thinner than 1e-06 m", None),
        ([(0, 0), (1, 1), (1, 0), (0, 1)], "intersects itself", 0),
        ([(0, 0), (1, 0), (1, 1), (1, -1), (1, 0)], "intersects itself", None),
        ([(math.cos(k * 0.8 * math.pi), math.sin(k * 0.8 * math.pi)) for k in range(5)], "intersects itself", 0),
        ([(0, 0), (4, 0), (4, 4), (2, 1)], "concave", 3),
        ([(0, 0), (2, 1), (4, 4), (4, 0)], "concave", 1),
    ],
)  # fmt: skip
def test_what_is_no_convex_polygon_is_refused(points, told, index):
    with pytest.raises(PolygonError, match=told) as caught:
        convex_polygon(points)
    if index is not None:
        assert caught.value.index == index


def test_tiny_dents_of_rounding_are_straight():
    third = 1 / 3
    points = [(0, 0), (0.1, 0.3 - 1e-17), (third, 1.0), (-1, 1)]
    assert len(convex_polygon(points)) == 3


def test_far_from_the_origin_nothing_changes():
    far = [(x + 1e7, y - 1e7) for x, y in SQUARE]
    assert convex_polygon(far) == tuple(far)


def test_tiny_and_huge_numbers_are_exact():
    points = [(0.0, 0.0), (1e7, 5e-324), (1e7, 1e7)]
    assert convex_polygon(points) == tuple(points)
