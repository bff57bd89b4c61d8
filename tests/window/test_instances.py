from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

sys.path.append(str(Path(__file__).parents[1] / "render"))
from sandbox.render.body_colors import choose_colors
from sandbox.render.camera import Camera
from sandbox.render.draw_list import build_draw_list
from sandbox.render.frame import capture
from sandbox.render.theme import DARK
from sandbox.scene.flat import FlatBody, FlatScene
from sandbox.window.instances import MOST_PARTS, TRIM_PIXELS, pack, pack_shapes
from sandbox.world.build import build_state
from sandbox.world.state import State
from tests.render.stages import box, ngon, zoo


def packed(state: State, camera: Camera) -> np.ndarray:
    body_colors = choose_colors(state.names, state.bodies.type, DARK)
    picture = build_draw_list(capture(state), camera, body_colors)
    return pack_shapes(picture)


def test_each_visible_shape_is_one_quad() -> None:
    state = zoo()
    assert len(packed(state, Camera((0.0, 2.0), 50.0, (1280, 800)))) == len(state.shapes)
    assert len(packed(state, Camera((500.0, 2.0), 50.0, (1280, 800)))) == 0


@given(st.floats(-1e6, 1e6), st.floats(0.0, 3.2), st.floats(1.0, 100.0))
def test_cutting_a_huge_box_changes_nothing_in_the_window(x: float, angle: float, scale: float) -> None:
    ground = FlatBody("ground", "static", (box(4e6, 2.0),), (0.0, 0.0), angle)
    state = build_state(FlatScene((ground,)))
    middle = (x * np.cos(angle), x * np.sin(angle))
    camera = Camera(middle, scale, (1280, 800))
    quad = packed(state, camera)[0]
    assert quad["extent"][0] <= TRIM_PIXELS
    # The window's middle lies on the box's axis; its ends lie beyond the window; its width is unchanged.
    a, b = quad["axis"]
    to = np.array([640.0, 400.0]) - quad["origin"]
    assert abs(to[0] * b - to[1] * a) < 0.05
    assert abs(to[0] * a + to[1] * b) + 760.0 < quad["extent"][0]
    assert quad["extent"][1] == pytest.approx(scale, rel=1e-6)


@given(st.lists(st.booleans(), min_size=1, max_size=60))
def test_runs_keep_the_order_and_polygons_are_drawn_by_the_shader_that_knows_them(polygons: list[bool]) -> None:
    shapes = [ngon(5, 0.5) if one else box(1.0, 1.0) for one in polygons]
    bodies = [FlatBody(f"b{k}", "static", (shape,), (1.5 * k, 0.0)) for k, shape in enumerate(shapes)]
    state = build_state(FlatScene(tuple(bodies)))
    camera = Camera((45.0, 0.0), 10.0, (1280, 800))
    picture = build_draw_list(capture(state), camera, choose_colors(state.names, state.bodies.type, DARK))
    runs = pack(picture)
    places = [quad.tobytes() for run in runs for quad in run.instances]
    shown = [places.index(quad.tobytes()) for quad in pack_shapes(picture)]
    assert shown == sorted(shown)
    assert all(run.kind.outlined for run in runs if (run.instances["detail"][:, 3] != 0.0).any())
    assert len(runs) <= MOST_PARTS + 2
