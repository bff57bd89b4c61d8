from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import sandbox
from sandbox.render.film import film, gif_seconds
from sandbox.render.image import renderer_of, save_gif
from sandbox.scene.flat import FlatBody, FlatScene
from tests.render.stages import box, ground

SCENE = FlatScene((ground(), FlatBody("a", "dynamic", (box(1, 1),), (0.0, 3.0))))


@pytest.mark.parametrize(("fps", "expected"), [(25.0, 0.04), (30.0, 0.03), (50.0, 0.02), (60.0, 0.02), (10.0, 0.1)])
def test_gif_times_are_whole_hundredths(fps: float, expected: float) -> None:
    assert gif_seconds(fps) == expected


def test_a_film_shows_the_world_at_even_times() -> None:
    world = sandbox.World(SCENE)
    frames = list(film(world, range(30), 0.04))
    assert [frame.time for frame in frames] == pytest.approx([0.04 * k for k in range(13)])
    fall = [3.0 - float(frame.center[1, 1]) for frame in frames]
    expected = [9.81 / 2 * (0.04 * k) ** 2 for k in range(13)]
    assert fall == pytest.approx(expected, abs=9.81 / 8 / 60**2 + 1e-9)  # straight between two steps


def test_a_gif_holds_the_film(tmp_path: Path) -> None:
    world = sandbox.World(SCENE)
    renderer = renderer_of(world, (160, 100))
    frames = list(film(world, range(30), 0.04))
    path = tmp_path / "a.gif"
    save_gif(renderer.film(frames), path, 0.04)
    with Image.open(path) as picture:
        assert picture.size == (160, 100)
        assert picture.n_frames == len(frames)
        assert picture.info["duration"] == 40
        assert picture.info["loop"] == 0
        picture.seek(picture.n_frames - 1)
        last = np.asarray(picture.convert("RGB")).astype(int)
    difference = np.abs(last - np.asarray(renderer.picture(frames[-1])).astype(int))
    assert difference.max() < 40
    assert difference.mean() < 2


def test_a_png_is_the_picture(tmp_path: Path) -> None:
    world = sandbox.World(SCENE)
    renderer = renderer_of(world, (160, 100))
    frame = next(film(world, range(0), 0.04))
    renderer.save_png(frame, tmp_path / "a.png")
    with Image.open(tmp_path / "a.png") as picture:
        assert np.array_equal(np.asarray(picture), np.asarray(renderer.picture(frame)))
