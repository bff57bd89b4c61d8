"""Shapes as values: what they hold, and what they refuse."""

from __future__ import annotations

import math
from dataclasses import FrozenInstanceError
from random import Random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import (
    Box,
    Capsule,
    Circle,
    Polygon,
    SandboxError,
    Segment,
    Shape,
    ShapeError,
    collide,
    contains,
    distance,
    sat_table,
)
from sandbox.geometry.polygon import PolygonError
from tests.geometry.shape_families import pairs, randoms

SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
EXAMPLES = [
    Circle((1, 2), 3),
    Capsule((0, 0), (1, 0), 0.5),
    Segment((0, 0), (1, 1)),
    Polygon(SQUARE[::-1], 0.25),
    Box(2, 1, at=(3, 4), angle=0.5),
]


@pytest.mark.parametrize("shape", EXAMPLES, ids=lambda shape: type(shape).__name__)
def test_a_shape_is_a_value(shape: Shape) -> None:
    assert eval(repr(shape)) == shape
    assert hash(eval(repr(shape))) == hash(shape)
    assert shape != Circle((9, 9), 9)
    with pytest.raises(FrozenInstanceError):
        shape.radius = 2.0  # type: ignore[misc]
    moved = shape.moved((1, -2))
    assert type(moved) is type(shape)
    assert moved.vertices == tuple((x + 1, y - 2) for x, y in shape.vertices)
    assert moved.moved((-1, 2)) == shape


def test_cores_and_radii() -> None:
    assert (Circle((1, 2), 3).vertices, Circle((1, 2), 3).radius) == (((1.0, 2.0),), 3.0)
    assert Capsule((0, 0), (1, 0), 0.5).vertices == ((0.0, 0.0), (1.0, 0.0))
    assert Segment((0, 0), (1, 0)).radius == 0.0
    assert Box(2, 1, at=(1, 1)).vertices == ((0.0, 0.5), (2.0, 0.5), (2.0, 1.5), (0.0, 1.5))


def test_the_angle_of_a_box_is_in_radians() -> None:
    turned = Box(2, 1, angle=math.pi / 2).vertices
    assert turned == tuple(pytest.approx(p, abs=1e-15) for p in ((0.5, -1), (0.5, 1), (-0.5, 1), (-0.5, -1)))


@pytest.mark.parametrize(
    "points", [SQUARE, SQUARE[::-1], np.array(SQUARE), [np.float32(1) * np.array(p) for p in SQUARE]]
)
def test_any_winding_and_any_numbers(points) -> None:
    polygon = Polygon(points)
    assert polygon.vertices[0] == tuple(points[0])
    assert set(polygon.vertices) == {(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)}
    assert Box(2, 2, at=(1, 1)).vertices == Polygon(SQUARE).vertices
    assert all(type(part) is float for vertex in polygon.vertices for part in vertex)


def test_repeated_and_straight_vertices_are_dropped_and_edges_keep_their_numbers() -> None:
    polygon = Polygon([(0, 0), (0, 0), (1, 0), (2, 0), (2, 2), (0, 2), (0, 0)])
    assert polygon.vertices == ((0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0))
    assert polygon.edge_numbers == (1, 3, 4, 5)
    backwards = Polygon([(0, 0), (0, 2), (2, 2), (2, 0)])
    assert backwards.vertices == ((0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0))
    assert backwards.edge_numbers == (3, 2, 1, 0)


@given(randoms)
def test_an_edge_number_names_an_edge_that_lies_on_the_face(rng: Random) -> None:
    count, size = rng.randint(3, 9), 10.0 ** rng.uniform(-2, 3)
    ring = [(size * math.cos(t), size * math.sin(t)) for t in sorted(rng.uniform(0, 6.28) for _ in range(count))]
    given_ = [p for p in ring for _ in range(rng.choice([1, 1, 2]))][:: rng.choice([1, -1])]
    try:
        polygon = Polygon(given_)
    except ShapeError:
        return
    assert polygon.given == tuple(given_)
    for i, number in enumerate(polygon.edge_numbers):
        face = polygon.vertices[i], polygon.vertices[(i + 1) % len(polygon.vertices)]
        edge = polygon.given[number], polygon.given[(number + 1) % len(given_)]
        assert math.dist(*edge) >= 0.3 * math.dist(*face)
        assert all(math.dist(face[0], end) + math.dist(end, face[1]) <= (1 + 1e-6) * math.dist(*face) for end in edge)


def test_a_nearly_straight_corner_is_kept_and_a_shallow_dent_is_filled() -> None:
    assert len(Polygon([(0, 0), (1, -1e-11), (2, 0), (1, 1)]).vertices) == 4
    assert len(Polygon([(0, 0), (1, 1e-11), (2, 0), (1, 1)]).vertices) == 3
    with pytest.raises(PolygonError, match="concave") as caught:
        Polygon([(0, 0), (1, 1e-3), (2, 0), (1, 1)])
    assert caught.value.index == 1


@given(pairs)
def test_a_core_turns_left_everywhere(pair) -> None:
    for shape in pair:
        v = shape.vertices
        if len(v) > 2:
            assert Polygon(v, shape.radius).vertices == v


WRONG = [
    (lambda: Circle((0, 0), 0), "Circle: the radius must be 1e-06 to 1e"),
    (lambda: Circle((0, 0), -1), "not -1.0"),
    (lambda: Circle((0, math.nan), 1), "y of the centre must be a finite number"),
    (lambda: Circle((0, "1"), 1), "must be a finite number, not '1'"),
    (lambda: Circle((0, 0, 0), 1), "the centre must be a pair"),
    (lambda: Circle(7, 1), "the centre must be a pair"),
    (lambda: Circle((2e9, 0), 1), "within"),
    (lambda: Capsule((1, 1), (1, 1), 1), "the same point; a point with a radius is a Circle"),
    (lambda: Capsule((1, 1), (2, 1), 0), "the radius"),
    (lambda: Segment((1, 1), (1 + 1e-7, 1)), "the same point"),
    (lambda: Box(0, 1), "the width"),
    (lambda: Box(1, math.inf), "the height must be a finite number"),
    (lambda: Box(1, 1, angle=1e7), "the angle must be within"),
    (lambda: Box(1e-6, 1e-6, at=(1e9, 0.3), angle=0.4), "too small for its place"),
    (lambda: Polygon([]), "needs 3 to 64 vertices, not 0"),
    (lambda: Polygon([(0, 0)] * 65), "needs 3 to 64 vertices, not 65"),
    (lambda: Polygon([(0, 0), (1, 1), (2, 2)]), "no area"),
    (lambda: Polygon([(0, 0), (1, 0), (1, 1), (0, 1), (0.5, 0.5)]), r"concave.*\(vertex 4"),
    (lambda: Polygon([(0, 0), (1, 1), (1, 0), (0, 1)]), "intersects itself"),
    (lambda: Polygon([(0, 0), (1e-7, 0), (0, 1)]), "less than 1e-06 m apart"),
    (lambda: Polygon([(0, 0), (1e7, 0), (5e6, 1.5e-6)]), "thinner than 1e-06 m"),
    (lambda: Polygon(SQUARE, radius=-1), "the radius must be 0 or 1e-06 to"),
    (lambda: Polygon("abc"), "the vertices must be a list"),
    (lambda: Polygon([1, 2, 3]), "vertex 0 must be a pair"),
    (lambda: Circle((0, 0), 1).moved((1, None)), "y of the translation must be a number"),
]


@pytest.mark.parametrize(("make", "message"), WRONG, ids=[message for _, message in WRONG])
def test_what_is_no_shape_is_refused_with_a_clear_message(make, message) -> None:
    with pytest.raises(ShapeError, match=message) as caught:
        make()
    assert isinstance(caught.value, SandboxError)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("wrong", [None, 1, "disc", (0.0, 0.0), Circle])
def test_what_is_no_shape_cannot_be_asked_about(wrong) -> None:
    disc = Circle((0, 0), 1)
    for ask in (collide, distance, sat_table):
        for pair in ((disc, wrong), (wrong, disc)):
            with pytest.raises(ShapeError, match=f"{ask.__name__}: takes a Circle, Capsule, Segment, Polygon or Box"):
                ask(*pair)
    with pytest.raises(ShapeError, match="contains: takes"):
        contains(wrong, (0, 0))


extremes = st.floats(allow_nan=True, allow_infinity=True) | st.sampled_from([0.0, 1e-6, 1e7, 1e9, -1e9, 5e-324])


@given(st.lists(st.tuples(extremes, extremes), min_size=3, max_size=6), extremes)
def test_any_numbers_make_a_shape_or_a_clear_error(vertices, radius) -> None:
    for make in (
        lambda: Polygon(vertices, radius),
        lambda: Circle(vertices[0], radius),
        lambda: Capsule(*vertices[:2], radius),
    ):
        try:
            shape = make()
        except ShapeError:
            continue
        contact = collide(shape, shape)
        assert contact is not None
        assert contact.depth > 0.0
