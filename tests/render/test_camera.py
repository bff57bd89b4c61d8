from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.render.camera import Camera, fit, look_at, scene_camera

coordinates = st.floats(-1e6, 1e6)
points = st.tuples(coordinates, coordinates)
pixels = st.tuples(st.floats(-2000, 4000), st.floats(-2000, 4000))
sizes = st.tuples(st.integers(16, 4000), st.integers(16, 4000))
cameras = st.builds(Camera, points, st.floats(1e-3, 1e3), sizes)


def tolerance(camera: Camera) -> float:
    """Metres that a point may be off: a thousandth of a pixel, or what doubles lose far from the origin."""
    return 1e-3 / camera.scale + 1e-9 * max(1.0, abs(camera.center[0]), abs(camera.center[1]))


@given(cameras, pixels)
def test_screen_and_world_are_inverse(camera: Camera, pixel: tuple[float, float]) -> None:
    there = camera.to_world(pixel)
    assert np.abs(camera.to_screen(there) - pixel).max() < 1e-3 + 1e-9 * camera.scale * 1e6


@given(cameras, st.floats(0.01, 100), pixels)
def test_zoom_keeps_the_point_under_the_cursor(camera: Camera, factor: float, pixel: tuple[float, float]) -> None:
    zoomed = camera.zoomed(factor, pixel)
    off = np.abs(zoomed.to_world(pixel) - camera.to_world(pixel)).max()
    assert zoomed.scale == pytest.approx(camera.scale * factor)
    assert off < tolerance(camera) + tolerance(zoomed)


@given(cameras, st.tuples(st.floats(-500, 500), st.floats(-500, 500)), pixels)
def test_pan_moves_the_picture(camera: Camera, by: tuple[float, float], pixel: tuple[float, float]) -> None:
    moved = (pixel[0] + by[0], pixel[1] + by[1])
    off = np.abs(camera.panned(*by).to_world(moved) - camera.to_world(pixel)).max()
    assert off < tolerance(camera)


@given(cameras, sizes)
def test_resizing_keeps_the_height_and_the_middle(camera: Camera, size: tuple[int, int]) -> None:
    resized = camera.resized(size)
    assert resized.center == camera.center
    assert size[1] / resized.scale == pytest.approx(camera.size[1] / camera.scale)


@given(points, st.floats(0.01, 1e4), st.floats(0.01, 1e4), sizes, st.floats(0.0, 0.4))
def test_fit_shows_everything(
    corner: tuple[float, float], width: float, height: float, size: tuple[int, int], margin: float
) -> None:
    bounds = (corner[0], corner[1], corner[0] + width, corner[1] + height)
    camera = fit(bounds, size, margin)
    seen = camera.bounds
    assert seen[0] - 1e-6 <= bounds[0]
    assert seen[1] - 1e-6 <= bounds[1]
    assert seen[2] + 1e-6 >= bounds[2]
    assert seen[3] + 1e-6 >= bounds[3]
    used = max(width * camera.scale / size[0], height * camera.scale / size[1])
    assert used == pytest.approx(1.0 - 2.0 * margin, rel=1e-6)


def test_y_points_up_in_the_world_and_down_on_screen() -> None:
    camera = look_at((10.0, 5.0), 8.0, (1200, 800))
    assert camera.scale == 100.0
    assert camera.to_screen((10.0, 5.0)).tolist() == [600.0, 400.0]
    assert camera.to_screen((11.0, 6.0)).tolist() == [700.0, 300.0]


def test_a_scene_may_choose_its_view_or_leave_it_to_the_bounds() -> None:
    bounds, size = (-1.0, -1.0, 3.0, 1.0), (400, 400)
    assert scene_camera(None, bounds, size) == fit(bounds, size)
    chosen = scene_camera(SimpleNamespace(center=(7.0, 8.0), height=20.0), bounds, size)
    assert chosen == look_at((7.0, 8.0), 20.0, size)
    partly = scene_camera(SimpleNamespace(center=(7.0, 8.0), height=None), bounds, size)
    assert partly.center == (7.0, 8.0)
    assert partly.scale == pytest.approx(fit(bounds, size).scale)
