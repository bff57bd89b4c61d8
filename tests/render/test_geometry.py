from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.render.frame import capture, shape_bounds
from sandbox.render.pick import shape_distance
from tests.render.naive import distance
from tests.render.stages import zoo

STATE = zoo()
FRAME = capture(STATE)
SHAPES = range(len(STATE.shapes))


def world_corners(shape: int) -> np.ndarray:
    """The core's vertices in the world, straight from the records."""
    row = STATE.shapes[shape]
    body = STATE.bodies[row.body]
    local = STATE.vertices[row.vertex_start : row.vertex_start + row.vertex_count]
    c, s = body.rotation_cos, body.rotation_sin
    return np.column_stack([body.center_x + c * local.x - s * local.y, body.center_y + s * local.x + c * local.y])


def mesh_corners(shape: int) -> np.ndarray:
    """The same by way of the mesh."""
    origin, axis = FRAME.shape_poses()
    (c, s), core = axis[shape], FRAME.mesh.core(shape)
    return origin[shape] + np.column_stack([c * core[:, 0] - s * core[:, 1], s * core[:, 0] + c * core[:, 1]])


@pytest.mark.parametrize("shape", SHAPES)
def test_the_mesh_has_the_vertices_of_the_records(shape: int) -> None:
    expected, got = world_corners(shape), mesh_corners(shape)
    assert len(got) == len(expected)
    gaps = np.hypot(*(got[:, None] - expected[None]).transpose(2, 0, 1))
    assert gaps.min(axis=0).max() < 1e-12


@pytest.mark.parametrize("shape", SHAPES)
def test_bounds_and_reach_hold_the_shape(shape: int) -> None:
    corners, radius = world_corners(shape), STATE.shapes[shape].radius
    x0, y0, x1, y1 = shape_bounds(FRAME)[shape]
    assert x0 <= corners[:, 0].min() - radius + 1e-12
    assert y0 <= corners[:, 1].min() - radius + 1e-12
    assert x1 >= corners[:, 0].max() + radius - 1e-12
    assert y1 >= corners[:, 1].max() + radius - 1e-12
    origin, _ = FRAME.shape_poses()
    assert np.hypot(*(corners - origin[shape]).T).max() + radius <= FRAME.mesh.reach[shape] + 1e-12


@given(st.sampled_from(SHAPES), st.floats(-10, 10), st.floats(-3, 7))
def test_distances_equal_the_naive_ones(shape: int, x: float, y: float) -> None:
    origin, axis = FRAME.shape_poses()
    dx, dy = np.array([x, y]) - origin[shape]
    c, s = axis[shape]
    local = np.array([c * dx + s * dy, c * dy - s * dx])
    assert shape_distance(FRAME, shape, local) == pytest.approx(distance(STATE, shape, x, y), abs=1e-9)


def test_thickness_is_half_the_smallest_width() -> None:
    by_name = {STATE.names[body]: i for i, body in enumerate(STATE.shapes.body)}
    thickness = FRAME.mesh.thickness
    assert thickness[by_name["plank"]] == pytest.approx(0.15)
    assert thickness[by_name["ball"]] == pytest.approx(0.8)
    assert thickness[by_name["pill"]] == pytest.approx(0.35)
    assert thickness[by_name["wire"]] == 0.0
    # The height over the longest edge of the right-angled wedge with legs 2.4 and 1.2.
    assert thickness[by_name["wedge"]] == pytest.approx(2.4 * 1.2 / np.hypot(2.4, 1.2) / 2)
