"""What the inspector of separating axes works out before anything is drawn."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox.errors import SandboxError
from sandbox.geometry.nearest_pair import nearest_pair
from sandbox.geometry.sat_table import sat_table
from sandbox.geometry.shape_box import box_of
from sandbox.geometry.shapes import Box, Capsule, Circle, Polygon, Segment, Shape
from sandbox.render.camera import Camera, fit
from sandbox.render.shape_outline import outline_of
from sandbox.window.sat.focus import Focus
from sandbox.window.sat.inspection import Inspection, Inspector
from sandbox.window.sat.overlap_curve import axis_angle, axis_at, overlap_at, overlap_curve
from sandbox.window.sat.rail import interval, rail_of
from sandbox.window.sat.regression import regression_scene
from sandbox.window.sat.second_opinion import opinion_on
from sandbox.window.sat.shape_drawing import edge_near
from sandbox.window.sat.table_view import narrow
from sandbox.window.sat.tour import tour_of

SQUARE = Polygon(((11, 10), (11, 3), (4, 3), (4, 10)))
TRIANGLE = Polygon(((13, 13), (8, 9), (7, 15)))
CAMERA = fit((2.0, 2.0, 15.0, 16.0), (900, 700))
places = st.floats(-3.0, 3.0)
groups = st.lists(st.tuples(places, places), min_size=1, max_size=5)
Vec = tuple[float, float]


def inspection(a: Shape, b: Shape) -> Inspection:
    return Inspection(("a", "b"), (0, 0), (1, 1), sat_table(a, b, all_axes=True))


@pytest.mark.parametrize("number", range(1, 8))
def test_a_rail_has_the_intervals_of_its_row_and_lies_beside_the_shapes(number: int) -> None:
    table = sat_table(SQUARE, TRIANGLE, all_axes=True)
    row = table.rows[number - 1]
    rail = rail_of(table, row.axis, CAMERA)
    assert rail.a == pytest.approx((row.amin / row.length, row.amax / row.length))
    assert rail.b == pytest.approx((row.bmin / row.length, row.bmax / row.length))
    assert rail.separation == pytest.approx(row.separation)
    assert rail.way == row.way
    left = -rail.unit[1], rail.unit[0]
    for shape in (SQUARE, TRIANGLE):
        low, high = interval(shape, left)
        assert rail.aside < low if rail.outwards < 0.0 else rail.aside > high
    x, y = rail.at(rail.a[0], 0.5)
    assert x * rail.unit[0] + y * rail.unit[1] == pytest.approx(rail.a[0])
    assert x * left[0] + y * left[1] == pytest.approx(rail.aside + 0.5 * rail.outwards)


def test_a_rail_comes_into_sight_beside_the_smaller_shape() -> None:
    ground, crate = Box(400.0, 100.0, (0.0, -50.0)), Box(1.0, 1.0, (0.0, 0.5))
    camera = Camera((0.0, 0.5), 100.0, (800, 600))
    rail = rail_of(sat_table(ground, crate, all_axes=True), (0.0, 1.0), camera)
    x, y = camera.to_screen(rail.at(0.5))
    assert 0 < x < 800
    assert 0 < y < 600
    assert abs(rail.aside) > 0.5  # and not across the crate


@given(places, places, st.floats(0.0, 3.0), st.floats(0.0, 179.9))
def test_the_curve_is_what_projections_give_and_its_minimum_is_the_way_out(
    x: float, y: float, turn: float, angle: float
) -> None:
    a, b = Box(2.0, 1.0), Polygon(tuple((x + px, y + py) for px, py in Box(1.0, 1.5, angle=turn).vertices))
    table = sat_table(a, b, all_axes=True)
    unit = axis_at(angle)
    (alow, ahigh), (blow, bhigh) = interval(a, unit), interval(b, unit)
    overlap = float(overlap_at(a, b, np.array([angle]))[0])
    assert overlap == pytest.approx(min(ahigh - blow, bhigh - alow), abs=1e-12)
    curve = overlap_curve(table)
    for row in table.rows:
        at = float(np.interp(axis_angle(row.axis), curve.angles, curve.overlap))
        assert at == pytest.approx(-row.separation, abs=1e-9)
    if table.contact is not None:
        assert curve.limits[0] == pytest.approx(table.contact.depth, abs=1e-9)


def test_a_free_axis_clicks_into_place_only_near_an_edge() -> None:
    seen, focus = inspection(SQUARE, TRIANGLE), Focus()
    focus.turn(seen, 91.7)
    assert focus.free == 90.0
    assert focus.row(seen) is None
    focus.turn(seen, 91.7, snap=False)
    assert focus.free == 91.7
    focus.turn(seen, 268.9)
    assert focus.free == 270.0
    focus.turn(seen, 359.4)
    assert focus.free == 0.0
    focus.turn(seen, 60.0)
    assert focus.free == 60.0


def test_a_row_that_is_pointed_at_wins_over_the_chosen_one_and_that_over_the_deciding_one() -> None:
    seen, focus = inspection(SQUARE, TRIANGLE), Focus()
    assert focus.row(seen) is seen.deciding
    focus.chosen = 3
    assert focus.row(seen) is seen.table.rows[2]
    focus.lit = 5
    assert focus.row(seen) is seen.table.rows[4]
    focus.pointed = 6
    assert focus.row(seen) is seen.table.rows[5]


def test_the_ghost_just_touches() -> None:
    table = sat_table(SQUARE, TRIANGLE, all_axes=True)
    assert table.mtv is not None
    moved = TRIANGLE.moved(table.mtv)
    contact = sandbox.collide(SQUARE, moved)
    assert contact is None or contact.depth < 1e-12
    assert sandbox.distance(SQUARE, moved).value < 1e-12


@pytest.mark.parametrize(
    "shape",
    [
        SQUARE,
        Circle((1, 2), 0.5),
        Capsule((0, 0), (2, 1), 0.3),
        Capsule((3, 0), (0, 0), 1.0),
        Polygon(TRIANGLE.given, 0.4),
    ],
)
def test_an_outline_lies_on_the_surface(shape: Shape) -> None:
    points = outline_of(shape)
    assert len(points) >= 3
    area = sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(points, [*points[1:], points[0]], strict=True))
    assert area > 0.0  # counter-clockwise
    xs, ys = [x for x, _ in points], [y for _, y in points]
    assert (min(xs), min(ys), max(xs), max(ys)) == pytest.approx(box_of(shape), abs=0.01 * (1 + shape.radius))
    for point in points:
        assert sandbox.distance(shape, Circle(point, 1e-6)).value < 1e-9


def test_an_edge_is_found_on_the_surface_of_a_rounded_shape() -> None:
    seen = inspection(Polygon(SQUARE.given, 0.5), TRIANGLE)
    start, end, out = seen.edges["a", 3]
    assert {start[0], end[0]} == {3.5}
    assert out == (-1.0, 0.0)
    row = edge_near(seen, (3.45, 6.0), 0.1)
    assert row is not None
    assert (row.owner, row.edge) == ("a", 3)
    assert edge_near(seen, (2.0, 6.0), 0.1) is None


@given(
    st.lists(st.tuples(places, places), min_size=1, max_size=5),
    st.lists(st.tuples(places, places), min_size=1, max_size=5),
)
def test_the_pair_of_shapes_is_the_deepest_of_all(
    first: list[tuple[float, float]], second: list[tuple[float, float]]
) -> None:
    def apart(a: Shape, b: Shape) -> float:
        contact = sandbox.collide(a, b)
        return sandbox.distance(a, b).value if contact is None else -contact.depth

    boxes = [Box(1.0, 0.5, at) for at in first]
    discs = [Circle(at, 0.4) for at in second]
    i, j = nearest_pair(boxes, discs)
    assert apart(boxes[i], discs[j]) == min(apart(a, b) for a in boxes for b in discs)


def test_the_tour_says_what_the_table_says() -> None:
    seen = inspection(SQUARE, TRIANGLE)
    steps = tour_of(seen)
    told = [step.row for step in steps if step.kind == "project"]
    assert told == list(range(1, 8))
    minimum = next(step for step in steps if step.kind == "minimum")
    assert seen.table.runner_up is not None
    assert f"Next is axis {seen.table.runner_up.number}" in minimum.text
    discs = tour_of(inspection(Circle((0, 0), 1.0), Circle((1, 0), 1.0)))
    assert [step.kind for step in discs] == ["axes", "project", "minimum", "orientation", "points"]


@pytest.mark.parametrize(
    ("a", "b"),
    [(SQUARE, TRIANGLE), (SQUARE, TRIANGLE.moved((20, 0))), (Circle((0, 0), 1), Box(2, 2, (1.5, 0)))],
)
def test_pymunk_is_asked_and_says_the_same(a: Shape, b: Shape) -> None:
    contact = sandbox.collide(a, b)
    opinion = opinion_on(a, b, contact)
    assert opinion.asked
    assert opinion.same
    assert (opinion.depth is None) == (contact is None)


def test_where_pymunk_is_trapped_exact_arithmetic_says_who_is_right() -> None:
    a, b = Circle((0.0, 0.0), 1.0), Circle((0.0, 0.0), 0.5)
    opinion = opinion_on(a, b, sandbox.collide(a, b))
    assert not opinion.same
    assert opinion.remark


@pytest.mark.parametrize(
    ("a", "b", "verdict"),
    [
        (Segment((-2.0, 0.0), (2.0, 0.1)), Circle((0.3, 0.4), 0.5), "touches"),
        (Circle((0.3, 0.4), 0.5), Segment((-2.0, 0.0), (2.0, 0.1)), "touches"),
        (Capsule((0, 0), (1, 0), 0.2), Polygon(((0, 1), (1, 1), (0.5, 2)), 0.1), "apart"),
        (Box(1, 1), Box(1, 1, (1.0, 0.0)), "touches"),
        (Polygon(tuple((1e4 + x, y) for x, y in SQUARE.given)), Circle((1e4 + 7, 5.0), 0.1), "touches"),
    ],
)
def test_a_pair_becomes_a_scene_that_holds(a: Shape, b: Shape, verdict: str) -> None:
    scene = regression_scene(inspection(a, b), "here")
    assert verdict in scene.expect[0].to_data()
    world = sandbox.World(scene)
    for name, shape in (("a", a), ("b", b)):
        again = world.body(name).shapes[0]
        assert again.radius == shape.radius
        assert again.given == pytest.approx(np.array(shape.given), abs=1e-11)


def test_two_lines_are_no_regression_test() -> None:
    with pytest.raises(SandboxError, match="never collide"):
        regression_scene(inspection(Segment((0, 0), (1, 0)), Segment((0.5, -1), (0.5, 1))), "here")


def test_a_pair_that_is_none_says_so_and_one_that_is_gone_is_waited_for() -> None:
    world = sandbox.World(
        sandbox.Scene(bodies=[{"id": "one", "shapes": [{"circle": 1}]}, {"id": "two", "shapes": [{"circle": 1}]}])
    )
    inspector = Inspector()
    for pair, words in ((("one", "one"), "one with itself is no pair: pick two bodies"), (("one", "nobody"), "")):
        assert inspector.look(world, pair) is None
        assert inspector.trouble == words
    assert inspector.look(world, ("one", "two")) is not None
    assert inspector.look(world, None) is None
    assert inspector.trouble == ""


@given(st.floats(-1e9, 1e9))
def test_a_narrow_number_fits_and_is_near(value: float) -> None:
    word = narrow(value)
    assert len(word) <= 7
    assert float(word) == pytest.approx(value, rel=0.51) or math.isclose(value, 0.0, abs_tol=1e-99)
