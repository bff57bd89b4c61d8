"""The window itself: what it draws, and the command that opens it. Skipped where no window can be opened."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import sandbox
from sandbox.render.body_colors import choose_colors
from sandbox.render.camera import fit
from sandbox.render.draw_list import DrawList, build_draw_list
from sandbox.render.frame import capture, interesting_bounds
from sandbox.render.line import Line
from sandbox.render.surface_painter import SurfacePainter
from sandbox.render.theme import DARK
from sandbox.world.state import State
from tests.render.stages import letters
from tests.window.test_instances import zoo
from tests.window.test_session import SCENE


def picture_of(state: State, size: tuple[int, int]) -> DrawList:
    camera = fit(interesting_bounds(capture(state)), size)
    rope = Line((100.0, 50.0), (200.0, 90.0), 4.0, DARK.drag)
    return build_draw_list(capture(state), camera, choose_colors(state.names, state.bodies.type, DARK), [rope])


@pytest.mark.parametrize("scene", [zoo, letters])
def test_opengl_draws_what_the_surface_painter_draws(scene: Any, display: Any, tmp_path: Path) -> None:
    from sandbox.window.gl_painter import GlPainter

    picture = picture_of(scene(), display.size)
    display.begin()
    GlPainter(display.context).paint(picture)
    display.save(tmp_path / "gl.png")
    with Image.open(tmp_path / "gl.png") as image:
        drawn = np.asarray(image).astype(int)
    expected = np.asarray(SurfacePainter().paint(picture)).astype(int)
    difference = np.abs(drawn - expected).max(axis=2)
    assert drawn.shape == expected.shape
    assert (difference > 60).mean() < 0.003  # the two smooth edges in ways of their own
    assert difference.mean() < 1.0


@pytest.mark.slow
def test_one_painter_draws_worlds_of_any_size_in_turn(display: Any, tmp_path: Path) -> None:
    from sandbox.window.gl_painter import GlPainter
    from tests.render.stages import pyramid

    painter = GlPainter(display.context)
    for state in (zoo(), pyramid(60), zoo()):
        frame = capture(state)
        body_colors = choose_colors(state.names, state.bodies.type, DARK)
        display.begin()
        painter.paint(build_draw_list(frame, fit(interesting_bounds(frame), display.size), body_colors))
        display.save(tmp_path / "last.png")
        with Image.open(tmp_path / "last.png") as image:
            assert len(image.getcolors(1 << 20)) > 100


CAPTION = 32
"""Pixels of the line above the scene where there are no panels."""


def run(tmp_path: Path, *arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """`sandbox run ARGUMENTS...` in a process of its own."""
    command = [sys.executable, "-m", "sandbox", "run", *arguments]
    return subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, env={**os.environ, **environment})


@pytest.fixture
def scene_file(tmp_path: Path) -> str:
    SCENE.save(tmp_path / "two.scene.json")
    return str(tmp_path / "two.scene.json")


def test_run_takes_one_step_a_picture_and_writes_the_last(display: Any, tmp_path: Path, scene_file: str) -> None:
    done = run(tmp_path, scene_file, "--frames", "40", "--screenshot", "shot.png", "--size", "640x400")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    with Image.open(tmp_path / "shot.png") as image:
        drawn = np.asarray(image.convert("RGB")).astype(int)
    assert drawn.shape == (400, 640, 3)
    scene, size = drawn[CAPTION:], (640, 400 - CAPTION)  # nothing lies over it
    difference = np.abs(scene - picture_after(40, size))
    assert difference.mean() < 1.0
    assert np.abs(scene - picture_after(60, size)).mean() > 2 * difference.mean()


def picture_after(steps: int, size: tuple[int, int]) -> np.ndarray:
    world = sandbox.World(SCENE)
    camera = fit(interesting_bounds(capture(world.state)), size)
    world.step(steps)
    state = world.state
    picture = build_draw_list(capture(state), camera, choose_colors(state.names, state.bodies.type, DARK))
    return np.asarray(SurfacePainter().paint(picture)).astype(int)


@pytest.mark.slow
def test_run_can_start_later(display: Any, tmp_path: Path, scene_file: str) -> None:
    options = ("--screenshot", "shot.png", "--size", "640x400")
    assert run(tmp_path, scene_file, "--frames", "30", *options).returncode == 0
    first = np.asarray(Image.open(tmp_path / "shot.png").convert("RGB")).astype(int)
    assert run(tmp_path, scene_file, "--step", "20", "--frames", "10", *options).returncode == 0
    second = np.asarray(Image.open(tmp_path / "shot.png").convert("RGB")).astype(int)
    # The view is that of the start in both.
    assert np.abs(first - second)[110:330].mean() < 0.1


@pytest.mark.slow
def test_run_without_a_scene_lists_the_scenes(display: Any, tmp_path: Path) -> None:
    done = run(tmp_path, "--frames", "2", "--screenshot", "list.png", "--size", "800x600")
    assert (done.returncode, done.stderr) == (0, "")
    with Image.open(tmp_path / "list.png") as image:
        assert len(image.getcolors(1 << 20)) > 30


@pytest.mark.slow
def test_run_leaves_nothing_behind(display: Any, tmp_path: Path, scene_file: str) -> None:
    assert run(tmp_path, scene_file, "--frames", "2").returncode == 0
    assert [path.name for path in tmp_path.iterdir()] == ["two.scene.json"]


def test_a_bad_scene_is_told_without_a_traceback(display: Any, tmp_path: Path) -> None:
    (tmp_path / "bad.scene.json").write_text('{"format": 1, "bodys": []}')
    done = run(tmp_path, "bad.scene.json", "--frames", "2")
    assert done.returncode == 2
    assert "bad.scene.json:1:15" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.slow
def test_without_opengl_it_says_what_to_install(tmp_path: Path, scene_file: str) -> None:
    done = run(tmp_path, scene_file, "--frames", "2", SDL_VIDEODRIVER="dummy")
    assert done.returncode == 2
    assert "apt install" in done.stderr
    assert "sandbox render" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="only Linux can be without a screen")
@pytest.mark.slow
def test_without_a_screen_it_says_so_at_once(tmp_path: Path, scene_file: str) -> None:
    done = run(tmp_path, scene_file, DISPLAY="", WAYLAND_DISPLAY="", SDL_VIDEODRIVER="")
    assert done.returncode == 2
    assert "no screen" in done.stderr
    assert "xvfb-run" in done.stderr


def test_without_the_extra_it_says_what_to_install(tmp_path: Path, scene_file: str) -> None:
    (tmp_path / "moderngl.py").write_text('raise ModuleNotFoundError("No module named moderngl", name="moderngl")')
    done = run(tmp_path, scene_file, "--frames", "2", PYTHONPATH=str(tmp_path))
    assert done.returncode == 2
    told = " ".join(done.stderr.split())
    project = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    wanted = {*project["optional-dependencies"]["window"], *(p for p in project["dependencies"] if "pygame" in p)}
    assert set(re.findall(r'"([^"]+)"', told.partition("python -m pip install ")[2])) == wanted
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--size", "huge"), "1280x800"),
        (("--size", "20x20"), "320x200"),
        (("--screenshot", "a.jpg"), ".png"),
        (("--screenshot", "nowhere/a.png"), "does not exist"),
    ],
)
@pytest.mark.slow
def test_bad_options_are_told_with_the_mend(
    tmp_path: Path, scene_file: str, options: tuple[str, ...], words: str
) -> None:
    done = run(tmp_path, scene_file, *options)
    assert done.returncode == 2
    assert words in done.stderr
    assert "Traceback" not in done.stderr
