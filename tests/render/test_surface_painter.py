from __future__ import annotations

import numpy as np
import pytest

from sandbox.render.body_colors import choose_colors
from sandbox.render.camera import Camera, fit
from sandbox.render.draw_list import build_draw_list
from sandbox.render.frame import capture, interesting_bounds
from sandbox.render.line import Line
from sandbox.render.surface_painter import SurfacePainter
from sandbox.render.theme import DARK
from sandbox.scene.flat import FlatBody, FlatScene
from sandbox.world.build import build_state
from sandbox.world.state import State
from tests.render.naive import distance
from tests.render.stages import box, circle, ground, rod, zoo

SIZE = (480, 300)
RIM = 2.0
"""Pixels: half the least width of a segment, half the diagonal of a pixel, and a sample."""
SHEET = np.array([DARK.background, DARK.grid_minor, DARK.grid_major, DARK.grid_axis]) * 255


def paint(state: State, camera: Camera, above: tuple[Line, ...] = ()) -> np.ndarray:
    body_colors = choose_colors(state.names, state.bodies.type, DARK)
    picture = build_draw_list(capture(state), camera, body_colors, above, depth=False)
    return np.asarray(SurfacePainter().paint(picture)).astype(float)


def is_sheet(pixel: np.ndarray) -> bool:
    """Whether a pixel shows the empty background: the background or a grid line."""
    return bool((np.abs(SHEET - pixel).max(axis=1) <= 1.0).any())


def check_pixels(state: State, camera: Camera) -> None:
    """Every seventh pixel: painted where a shape is, background where none is, either near the rim."""
    picture = paint(state, camera)
    seen = {True: 0, False: 0}
    pixels = [(column, row) for row in range(0, camera.size[1], 7) for column in range(0, camera.size[0], 7)]
    x, y = np.array([camera.point((column + 0.5, row + 0.5)) for column, row in pixels]).T
    gaps = np.min([distance(state, i, x, y) for i in range(len(state.shapes))], axis=0) * camera.scale
    for (column, row), gap in zip(pixels, gaps.tolist(), strict=True):
        if abs(gap) > RIM:
            seen[gap < 0] += 1
            assert is_sheet(picture[row, column]) == (gap > 0), (column, row, gap)
    assert min(seen.values()) > 50


def test_pixels_are_painted_where_shapes_are() -> None:
    state = zoo()
    check_pixels(state, fit(interesting_bounds(capture(state)), SIZE))


def test_shapes_far_from_the_origin_are_as_crisp() -> None:
    state = zoo()
    state.bodies.center_x += 1e8
    check_pixels(state, fit(interesting_bounds(capture(state)), SIZE))


def test_a_ground_of_a_million_metres_is_cut_to_the_window() -> None:
    state = build_state(FlatScene((ground(2e6), FlatBody("a", "dynamic", (box(1, 1),), (0.0, 0.5)))))
    check_pixels(state, Camera((0.0, 0.0), 100.0, SIZE))


@pytest.mark.parametrize("shape", [circle(0.001), box(0.001, 0.001), rod(0.5, 0.0)])
def test_what_is_thinner_than_a_pixel_stays_visible(shape: object) -> None:
    state = build_state(FlatScene((FlatBody("dust", "dynamic", (shape,), (0.2, 0.2)),)))
    picture = paint(state, Camera((0.0, 0.0), 20.0, (64, 64)))
    assert not is_sheet(picture[28, 36]) or not is_sheet(picture[27, 36])


def test_the_drag_line_lies_on_top() -> None:
    state = zoo()
    camera = fit(interesting_bounds(capture(state)), SIZE)
    line = Line((100.0, 150.5), (380.0, 150.5), 3.0, DARK.drag)
    picture = paint(state, camera, (line,))
    assert picture[150, 110:370] == pytest.approx(np.tile(np.round(np.array(DARK.drag) * 255), (260, 1)), abs=3)


def test_static_bodies_lie_below_moving_ones() -> None:
    shapes = (box(1, 1),)
    scene = FlatScene((FlatBody("a", "dynamic", shapes), FlatBody("wall", "static", (box(3, 3),))))
    state = build_state(scene)
    camera = Camera((0.0, 0.0), 50.0, (200, 200))
    color = choose_colors(state.names, state.bodies.type, DARK).base[0] * 255
    assert paint(state, camera)[90, 90] == pytest.approx(color, abs=2)
