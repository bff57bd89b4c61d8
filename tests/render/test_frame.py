from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.render.frame import blend, capture, interesting_bounds
from sandbox.scene.flat import FlatBody, FlatScene
from sandbox.world.build import build_state
from tests.render.stages import box, ground, pyramid, zoo


def turned(angle: float, x: float) -> object:
    state = build_state(FlatScene((FlatBody("a", "dynamic", (box(1, 1),), (x, 0.0), angle),)))
    state.bodies.angle = angle
    state.bodies.rotation_cos, state.bodies.rotation_sin = np.cos(angle), np.sin(angle)
    return capture(state)


@given(st.floats(-50, 50), st.floats(-50, 50), st.floats(0, 1))
def test_blend_lies_on_the_way(before: float, after: float, alpha: float) -> None:
    frame = blend(turned(before, 2.0), turned(after, 4.0), alpha)
    assert frame.center[0, 0] == pytest.approx(2.0 + 2.0 * alpha)
    angle = before + (after - before) * alpha
    assert frame.rotation[0] == pytest.approx([np.cos(angle), np.sin(angle)], abs=1e-9)


def test_blend_ends_are_the_frames_themselves() -> None:
    before, after = turned(0.0, 1.0), turned(7.0, 2.0)
    assert blend(before, after, 1.0) is after
    assert np.array_equal(blend(before, after, 0.0).center, before.center)


def test_a_frame_does_not_follow_the_world_and_cannot_be_written() -> None:
    state = zoo()
    frame, before = capture(state), state.bodies.center_x.copy()
    state.bodies.center_x += 1.0
    assert np.array_equal(frame.center[:, 0], before)
    with pytest.raises(ValueError, match="read-only"):
        frame.center[0, 0] = 1.0


def test_the_mesh_is_shared_between_frames() -> None:
    state = zoo()
    first = capture(state)
    assert capture(state, first.mesh).mesh is first.mesh


def test_the_view_holds_what_moves_and_what_will_catch_it() -> None:
    state = pyramid(10)
    state.bodies.center_y[1:] += 6.0
    x0, y0, x1, y1 = interesting_bounds(capture(state))
    assert x0 < -5.0
    assert x1 > 5.0
    assert y0 < 0.0
    assert y1 > 16.0


def test_the_view_does_not_shrink_bodies_to_show_all_of_a_huge_ground() -> None:
    scene = FlatScene((ground(1e6), FlatBody("a", "dynamic", (box(1, 1),), (0.0, 0.5))))
    x0, y0, x1, y1 = interesting_bounds(capture(build_state(scene)))
    assert x1 - x0 < 10.0
    assert y1 - y0 < 10.0


@pytest.mark.parametrize(("height", "is_shown"), [(1.0, True), (5.0, True), (39.0, True), (200.0, False)])
def test_a_lone_body_is_shown_with_the_floor_it_falls_on(height: float, is_shown: bool) -> None:
    """As long as it is not a speck in that picture; and of another floor, far below, nothing."""
    cellar = FlatBody("cellar", "static", (box(40.0, 1.0),), (0.0, -30.0))
    aside = FlatBody("aside", "static", (box(1.0, 1.0),), (25.0, -10.0))
    scene = FlatScene((ground(), cellar, aside, FlatBody("a", "dynamic", (box(1, 1),), (0.0, height))))
    _, y0, _, y1 = interesting_bounds(capture(build_state(scene)))
    assert (y0 < 0.0) == is_shown
    assert y0 > -5.0
    assert height + 0.5 < y1 < height + 3.0


def test_an_empty_world_has_a_view() -> None:
    x0, y0, x1, y1 = interesting_bounds(capture(build_state(FlatScene(()))))
    assert x0 < x1
    assert y0 < y1
