"""`sandbox render` as a user calls it."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from xml.etree import ElementTree

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
        ("a.jpg", (), ".gif, .html, .mp4, .png, .svg or .webm"),
        ("a", (), ".gif, .html, .mp4, .png, .svg or .webm"),
        ("nowhere/a.png", (), "does not exist"),
        ("a.png", ("--size", "12"), "1280x800"),
        ("a.html", ("--size", "640x400"), "fits itself"),
        ("a.html", ("--overlay", "contacts"), "controls of its own"),
        ("a.html", ("--theme", "lihgt"), 'did you mean "light"'),
        ("a.html", ("--flat",), "nothing casts a shadow"),
        ("a.png", ("--theme", "lihgt"), 'did you mean "light"'),
        ("a.png", ("--overlay", "boxes,contcats"), 'did you mean "contacts"'),
        ("a.png", ("--overlay", "sat:crate:gruond"), 'did you mean "ground"'),
        ("a.png", ("--overlay", "sat:crate"), "two bodies: sat:A:B"),
        ("a.png", ("--overlay", "sat:crate:crate"), "does not collide with itself"),
        ("a.png", ("--follow", "crat"), 'did you mean "crate"'),
        ("a.png", ("--center", "3"), "--center=-2.5,4"),
        ("a.png", ("--height", "-1"), "--height"),
        ("a.png", ("--range", "10:20"), "are for films"),
        ("a.gif", ("--range", "20:10"), "comes after the first"),
        ("a.gif", ("--range", "ten"), "60:240"),
        ("a.gif", ("--range", "1:9", "--step", "3"), "leave --step"),
        ("a.gif", ("--fps", "60"), "at most 50"),
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


def orange(path: Path) -> np.ndarray:
    """The middle (row, column) of the crate, in shares of the picture."""
    with Image.open(path) as image:
        pixels = np.asarray(image.convert("RGB")).astype(int)
    rows, columns = np.nonzero((pixels[:, :, 0] > 200) & (pixels[:, :, 2] < 100))
    return np.array([rows.mean() / pixels.shape[0], columns.mean() / pixels.shape[1]])


def test_center_and_height_say_what_is_seen(scene: str, tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    assert call(scene, "-o", str(path), "--size", "160x100", "--center=2,3", "--height", "8") == 0
    assert orange(path) == pytest.approx([0.5, 0.5 - 2 / 12.8], abs=0.02)


def test_follow_keeps_a_body_in_the_middle(scene: str, tmp_path: Path) -> None:
    for who in ("crate", "moving"):
        path = tmp_path / f"{who}.png"
        assert call(scene, "-o", str(path), "--size", "160x100", "--step", "30", "--follow", who) == 0
        assert orange(path) == pytest.approx([0.5, 0.5], abs=0.02)


def test_a_scene_may_say_whom_to_follow(tmp_path: Path) -> None:
    path = tmp_path / "b.scene.json"
    path.write_text(json.dumps({**SCENE, "view": {"follow": "crate", "height": 5}}))
    assert call(str(path), "-o", str(tmp_path / "b.png"), "--size", "160x100", "--step", "40") == 0
    assert orange(tmp_path / "b.png") == pytest.approx([0.5, 0.5], abs=0.02)


def test_recordings_are_filmed_with_their_commands(
    scene: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    replay = tmp_path / "fall.replay.json"
    commands = [(5, sandbox.SetPose("crate", (6.0, 2.0), 0.0))]
    recording = sandbox.record(scene, 30, commands)
    recording.save(replay)
    assert call(str(replay), "-o", str(tmp_path / "a.png"), "--step", "30", "--size", "160x100", "--json") == 0
    assert json.loads(capsys.readouterr().out)["digest"] == recording.digest
    assert call(str(replay), "-o", str(tmp_path / "a.gif"), "--size", "64x40", "--json") == 0
    facts = json.loads(capsys.readouterr().out)
    assert (facts["step"], facts["digest"]) == (30, recording.digest)
    for options, words in ((["--range", "0:40"], "has 30 steps"), (["--step", "30"], "ends there")):
        assert call(str(replay), "-o", str(tmp_path / "b.gif"), *options) == 2
        assert words in capsys.readouterr().err
    assert not (tmp_path / "b.gif").exists()


def test_overlays_and_themes_change_the_picture(scene: str, tmp_path: Path) -> None:
    files = []
    for k, options in enumerate(([], ["--overlay", "boxes"], ["--overlay", "sat:crate:ground"], ["--theme", "light"])):
        path = tmp_path / f"{k}.png"
        assert call(scene, "-o", str(path), "--step", "20", "--size", "320x200", *options) == 0
        files.append(path.read_bytes())
    assert len(set(files)) == 4


def test_a_range_is_step_and_steps(scene: str, tmp_path: Path) -> None:
    assert call(scene, "-o", str(tmp_path / "a.gif"), "--range", "10:40", "--size", "64x40") == 0
    assert call(scene, "-o", str(tmp_path / "b.gif"), "--step", "10", "--steps", "30", "--size", "64x40") == 0
    assert (tmp_path / "a.gif").read_bytes() == (tmp_path / "b.gif").read_bytes()


def test_a_vector_picture_has_what_the_scene_has(scene: str, tmp_path: Path) -> None:
    path = tmp_path / "a.svg"
    assert call(scene, "-o", str(path), "--step", "90", "--overlay", "contacts") == 0
    root = ElementTree.parse(path).getroot()
    assert (root.get("width"), root.get("height")) == ("1280", "800")
    fills = [node.get("fill") for node in root.iter("{http://www.w3.org/2000/svg}polygon")]
    assert len(fills) >= 2
    assert any("touching: 2" in (node.text or "") for node in root.iter("{http://www.w3.org/2000/svg}text"))


def test_a_video_of_a_scene(scene: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    av = pytest.importorskip("av")
    path = tmp_path / "a.mp4"
    assert call(scene, "-o", str(path), "--steps", "60", "--fps", "30", "--size", "160x100", "--json") == 0
    assert json.loads(capsys.readouterr().out)["pictures"] == 31
    with av.open(str(path)) as video:
        assert sum(1 for _ in video.decode(video=0)) == 31


def test_a_video_without_av_is_refused_before_anything_runs(
    scene: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "av", None)
    assert call(scene, "-o", str(tmp_path / "a.webm")) == 2
    assert 'pip install "av' in capsys.readouterr().err
    assert not (tmp_path / "a.webm").exists()
