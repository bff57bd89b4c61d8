"""`sandbox render` as a user calls it."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageSequence

import sandbox
from sandbox.cli import main

SCENE = {
    "format": 1,
    "bodies": [
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 3], "color": "#ff8000"},
    ],
}


@pytest.fixture
def scene(tmp_path: Path) -> str:
    path = tmp_path / "fall.scene.json"
    path.write_text(json.dumps(SCENE))
    return str(path)


def call(*arguments: str) -> int:
    with pytest.raises(SystemExit) as stop:
        main(["render", *arguments])
    return int(stop.value.code or 0)


def height_of_the_crate(path: Path) -> float:
    """Mean row of the orange pixels, from the top."""
    with Image.open(path) as image:
        pixels = np.asarray(image.convert("RGB")).astype(int)
    return float(np.nonzero((pixels[:, :, 0] > 200) & (pixels[:, :, 2] < 100))[0].mean())


def test_a_still_shows_the_step_that_was_asked_for(scene: str, tmp_path: Path) -> None:
    rows = []
    for step in (0, 20, 200):
        path = tmp_path / f"{step}.png"
        assert call(scene, "-o", str(path), "--step", str(step), "--size", "320x200") == 0
        with Image.open(path) as image:
            assert image.size == (320, 200)
        rows.append(height_of_the_crate(path))
    assert rows[0] + 5 < rows[1] < rows[2] - 5


def test_the_same_scene_gives_the_same_file(scene: str, tmp_path: Path) -> None:
    for name in ("a.png", "b.png"):
        assert call(scene, "-o", str(tmp_path / name), "--step", "30", "--size", "160x100") == 0
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()


def test_a_film_and_what_json_says_of_it(scene: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "fall.GIF"
    assert call(scene, "-o", str(path), "--steps", "60", "--fps", "20", "--size", "160x100", "--json") == 0
    facts = json.loads(capsys.readouterr().out)
    world = sandbox.World(sandbox.load_scene(scene))
    world.step(60)
    with Image.open(path) as image:
        assert image.size == (160, 100)
        durations = [frame.info["duration"] for frame in ImageSequence.Iterator(image)]
    # Pictures in which nothing moves only lengthen the one before.
    assert sum(durations) == 21 * 50
    assert {duration % 50 for duration in durations} == {0}
    assert facts["pictures"] == 21
    assert facts["step"] == 60
    assert facts["digest"] == world.digest()
    assert facts["bytes"] == path.stat().st_size


@pytest.mark.parametrize(
    ("output", "options", "words"),
    [
        ("a.jpg", (), ".gif, .html or .png"),
        ("a", (), ".gif, .html or .png"),
        ("nowhere/a.png", (), "does not exist"),
        ("a.png", ("--size", "12"), "1280x800"),
        ("a.html", ("--size", "640x400"), "fits itself"),
        ("a.html", ("--step", "1200"), "the run has"),
        ("a.png", ("--size", "100000x2"), "8192"),
    ],
)
def test_bad_options_are_told_with_the_mend(
    scene: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    output: str,
    options: tuple[str, ...],
    words: str,
) -> None:
    assert call(scene, "-o", str(tmp_path / output), *options) == 2
    captured = capsys.readouterr()
    assert words in captured.err
    assert captured.out == ""
    assert [path.name for path in tmp_path.iterdir()] == ["fall.scene.json"]


def test_a_page_of_a_scene_and_of_a_recording(scene: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    replay, page = tmp_path / "fall.replay.json", tmp_path / "fall.html"
    sandbox.record(scene, 30).save(replay)
    for source, last in ((scene, 25), (replay, 25)):
        assert call(str(source), "-o", str(page), "--step", "5", "--steps", "20", "--json") == 0
        facts = json.loads(capsys.readouterr().out)
        assert (facts["first_step"], facts["last_step"], facts["bodies"]) == (5, last, 2)
        assert facts["bytes"] == page.stat().st_size
    assert call(str(replay), "-o", str(page)) == 0
    assert "steps 0 to 30" in capsys.readouterr().out


def test_a_scene_that_is_not_there(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert call(str(tmp_path / "none.json"), "-o", str(tmp_path / "a.png")) == 2
    assert "none.json" in capsys.readouterr().err
