from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox.render.camera import Camera
from sandbox.render.follow import CATCH_UP_SECONDS, WIDEST, followed, moving_bounds
from sandbox.render.frame import Frame, capture
from tests.examples import examples

HOME = Camera((0.0, 0.0), 40.0, (640, 400))


def frame(*moving: tuple[float, float], at_rest: int = 3) -> Frame:
    """Balls that move, and some that stay where they are."""
    bodies = [
        {"id": f"m{k}", "shapes": [{"circle": 0.5}], "position": list(p), "velocity": [3, 0]}
        for k, p in enumerate(moving)
    ]
    bodies += [{"id": f"r{k}", "shapes": [{"circle": 0.5}], "position": [50 + 2 * k, 0]} for k in range(at_rest)]
    return capture(sandbox.World(sandbox.Scene(bodies=bodies)).state)


@examples(100)
@given(st.floats(-100, 100), st.floats(-100, 100))
def test_a_body_is_in_the_middle_at_the_height_of_home(x: float, y: float) -> None:
    camera = followed(Camera((5.0, 5.0), 10.0, HOME.size), frame((x, y)), "m0", HOME)
    assert camera.center == pytest.approx((x, y))
    assert camera.scale == pytest.approx(HOME.scale)


def test_the_camera_catches_up_smoothly_however_many_pictures_that_takes() -> None:
    seen = frame((10.0, 0.0))
    once = followed(HOME, seen, "m0", HOME, CATCH_UP_SECONDS)
    assert once.center[0] == pytest.approx(10.0 * (1 - math.exp(-1)))
    camera = HOME
    for _ in range(7):
        camera = followed(camera, seen, "m0", HOME, CATCH_UP_SECONDS / 7)
    assert camera.center == pytest.approx(once.center)
    assert followed(HOME, seen, "m0", HOME, 0.0) == HOME


@examples(100)
@given(st.lists(st.tuples(st.floats(-8, 8), st.floats(-5, 5)), min_size=1, max_size=8))
def test_all_that_moves_is_seen(places: list[tuple[float, float]]) -> None:
    seen = frame(*places)
    camera = followed(HOME, seen, "moving", HOME)
    assert HOME.scale / WIDEST <= camera.scale <= HOME.scale
    pixels = camera.to_screen(np.array(places))
    assert (pixels > 0).all()
    assert (pixels < camera.size).all()


def test_where_nothing_moves_or_nobody_has_the_name_the_camera_stays() -> None:
    still = frame()
    away = Camera((1.0, 2.0), 30.0, HOME.size)
    assert moving_bounds(still, HOME.scale) is None
    assert followed(away, still, "moving", HOME) == away
    assert followed(away, still, "gone", HOME) == away


def test_what_flies_far_away_does_not_make_the_rest_a_dot() -> None:
    camera = followed(HOME, frame((0.0, 0.0), (1e6, 0.0)), "moving", HOME)
    assert camera.scale == pytest.approx(HOME.scale / WIDEST)


def test_a_body_named_moving_is_followed_itself() -> None:
    bodies = [
        {"id": "moving", "shapes": [{"circle": 1}], "position": [7, 1]},
        {"id": "b", "shapes": [{"circle": 1}], "velocity": [9, 0]},
    ]
    seen = capture(sandbox.World(sandbox.Scene(bodies=bodies)).state)
    assert followed(HOME, seen, "moving", HOME).center == pytest.approx((7.0, 1.0))


@pytest.mark.parametrize(("follow", "words"), [("crat", 'did you mean "crate"'), ("", "1 to 100"), (3, "text")])
def test_a_scene_that_follows_nobody_is_told(follow: object, words: str) -> None:
    bodies = [{"id": "crate", "shapes": [{"box": [1, 1]}]}]
    with pytest.raises(sandbox.SceneError, match=words):
        sandbox.Scene(bodies=bodies, view={"follow": follow})
    for right in ("crate", "moving"):
        assert sandbox.Scene(bodies=bodies, view={"follow": right}).view.follow == right
