from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from sandbox.errors import MissingDependencyError
from sandbox.render.draw_list import DrawList
from sandbox.render.image import gif_pictures, gif_seconds, save_gif
from sandbox.render.shots import Shooting, Style, shots
from sandbox.render.surface_painter import SurfacePainter
from sandbox.render.video import save_video
from sandbox.replay.golden.run import RunStepper
from sandbox.scene.flat import FlatBody, FlatScene
from tests.render.stages import box, ground

SCENE = FlatScene((ground(), FlatBody("a", "dynamic", (box(1, 1),), (0.0, 3.0))))


STYLE = Style((160, 100))


@pytest.mark.parametrize(("fps", "expected"), [(25.0, 0.04), (30.0, 0.03), (50.0, 0.02), (60.0, 0.02), (10.0, 0.1)])
def test_gif_times_are_whole_hundredths(fps: float, expected: float) -> None:
    assert gif_seconds(fps) == expected


def test_a_film_shows_the_world_at_even_times() -> None:
    stepper = RunStepper(SCENE, ())
    frames = [shot.frame for shot in shots(stepper, range(30), 0.04, Shooting(stepper.world, STYLE))]
    assert [frame.time for frame in frames] == pytest.approx([0.04 * k for k in range(13)])
    fall = [3.0 - float(frame.center[1, 1]) for frame in frames]
    expected = [9.81 / 2 * (0.04 * k) ** 2 for k in range(13)]
    assert fall == pytest.approx(expected, abs=9.81 / 8 / 60**2 + 1e-9)  # straight between two steps


def filmed() -> list[DrawList]:
    stepper = RunStepper(SCENE, ())
    shooting = Shooting(stepper.world, STYLE)
    return [shooting.draw_list(shot) for shot in shots(stepper, range(30), 0.04, shooting)]


def test_a_gif_holds_the_film(tmp_path: Path) -> None:
    pictures = filmed()
    path = tmp_path / "a.gif"
    save_gif(gif_pictures(pictures), path, 0.04)
    with Image.open(path) as picture:
        assert picture.size == (160, 100)
        assert picture.n_frames == len(pictures)
        assert picture.info["duration"] == 40
        assert picture.info["loop"] == 0
        picture.seek(picture.n_frames - 1)
        last = np.asarray(picture.convert("RGB")).astype(int)
    difference = np.abs(last - np.asarray(SurfacePainter().paint(pictures[-1])).astype(int))
    assert difference.max() < 40
    assert difference.mean() < 2


@pytest.mark.parametrize("suffix", [".mp4", ".webm"])
def test_a_video_holds_the_film(suffix: str, tmp_path: Path) -> None:
    av = pytest.importorskip("av")
    pictures = filmed()
    path = tmp_path / f"a{suffix}"
    painter = SurfacePainter()
    assert save_video((painter.paint(picture) for picture in pictures), path, 25.0) == len(pictures)
    with av.open(str(path)) as video:
        assert float(video.streams.video[0].average_rate) == 25.0
        seen = [np.asarray(image.to_image()).astype(int) for image in video.decode(video=0)]
    assert len(seen) == len(pictures)
    for k in (0, -1):
        difference = np.abs(seen[k] - np.asarray(painter.paint(pictures[k])).astype(int))
        assert difference.mean() < 5


def test_an_odd_size_loses_a_line_of_pixels(tmp_path: Path) -> None:
    av = pytest.importorskip("av")
    save_video([Image.new("RGB", (33, 21), "red")] * 3, tmp_path / "a.mp4", 10.0)
    with av.open(str(tmp_path / "a.mp4")) as video:
        assert next(video.decode(video=0)).to_image().size == (32, 20)


def test_without_av_the_message_says_what_to_install(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setitem(sys.modules, "av", None)
    with pytest.raises(MissingDependencyError, match=r'pip install "av'):
        save_video([], tmp_path / "a.mp4", 25.0)
    assert list(tmp_path.iterdir()) == []
