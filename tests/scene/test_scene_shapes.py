"""From the shapes of a file to convex cores and radii."""

from __future__ import annotations

import math

import pytest

from sandbox.errors import SceneError
from sandbox.scene import FlatShape, Scene


def flat(**shape) -> FlatShape:
    body = {"id": "it", "type": "static", "shapes": [shape]}
    return Scene(bodies=[body]).flatten().bodies[0].shapes[0]


def test_a_rounded_box_keeps_its_outer_size():
    shape = flat(box=[4, 2], radius=0.25)
    assert shape.vertices == ((-1.75, -0.75), (1.75, -0.75), (1.75, 0.75), (-1.75, 0.75))
    assert shape.radius == 0.25


def test_a_rounded_polygon_grows():
    shape = flat(polygon=[[0, 0], [1, 0], [0, 1]], radius=0.25)
    assert shape.vertices == ((0, 0), (1, 0), (0, 1))
    assert shape.radius == 0.25


def test_a_circle_is_one_vertex():
    assert flat(circle=2, at=[1, 3]) == FlatShape(kind="circle", vertices=((1, 3),), radius=2)


def test_capsules_and_segments_are_two_vertices():
    assert flat(capsule=[[0, 0], [2, 0]], radius=0.5).vertices == ((0, 0), (2, 0))
    assert flat(segment=[[0, 0], [2, 0]]) == FlatShape(kind="segment", vertices=((0, 0), (2, 0)))


@pytest.mark.parametrize("points", [[[0, 0], [2, 0], [2, 1], [0, 1]], [[0, 0], [0, 1], [2, 1], [2, 0]]])
def test_either_winding_is_counter_clockwise_when_flat(points):
    assert flat(polygon=points).vertices == ((0, 0), (2, 0), (2, 1), (0, 1))


def test_turning_by_a_quarter_is_exact_and_comes_before_moving():
    shape = flat(segment=[[0, 0], [2, 0]], angle=90, at=[5, 1])
    assert shape.vertices == ((5, 1), (5, 3))


def test_turning_is_counter_clockwise_in_degrees():
    (_, (x, y)) = flat(segment=[[0, 0], [2, 0]], angle=30).vertices
    assert (x, y) == (pytest.approx(math.sqrt(3)), pytest.approx(1))


def test_no_vertex_is_a_negative_zero():
    shape = flat(box=[2, 2], angle=180, at=[1, 1])
    assert all(math.copysign(1, value) == 1 for vertex in shape.vertices for value in vertex)


@pytest.mark.parametrize("shape", [{"segment": [[0, 0], [1, 0]]}, {"circle": 1, "density": 0}])
def test_a_dynamic_body_needs_mass(shape):
    with pytest.raises(SceneError, match="a dynamic body without mass"):
        Scene(bodies=[{"id": "it", "shapes": [shape]}])
    with pytest.raises(SceneError, match="needs an inertia"):
        Scene(bodies=[{"id": "it", "mass": 1, "shapes": [shape]}])
    Scene(bodies=[{"id": "it", "mass": 1, "inertia": 1, "shapes": [shape]}])
    Scene(bodies=[{"id": "it", "mass": 1, "fixed_rotation": True, "shapes": [shape]}])
    Scene(bodies=[{"id": "it", "type": "static", "shapes": [shape]}])


def test_a_static_body_has_no_velocity():
    with pytest.raises(SceneError, match="a static body cannot have a velocity"):
        Scene(bodies=[{"id": "it", "type": "static", "velocity": [1, 0], "shapes": [{"circle": 1}]}])
