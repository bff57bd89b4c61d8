"""`sandbox compare` as users call it."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from sandbox.reference import comparison
from sandbox.resources import scenes_dir, shipped_scenes
from tests.cli.conftest import CRATE, GROUND


@pytest.fixture
def lying_kernel(monkeypatch: pytest.MonkeyPatch) -> None:
    """The narrow phase seems to see every pair a millimetre deeper than it is."""
    decide = comparison.decide
    monkeypatch.setattr(comparison, "decide", lambda *given: (decide(*given)[0] - 1e-3, decide(*given)[1]))


def test_a_sound_scene_agrees(cli: Callable, write_scene: Callable) -> None:
    path = write_scene("a.scene.json")
    done = cli("compare", path)
    assert done.code == 0
    head, row, summary = done.out.splitlines()
    assert head.split()[:6] == ["scene", "steps", "pairs", "agreed", "touch", "trapped"]
    assert row.startswith(path.as_posix())
    assert row.endswith("agrees")
    assert re.match(r"1 scene: 1 agree; \d+ pairs at 20 steps in [\d.]+ s", summary)
    assert "\x1b" not in done.out + done.err


def test_json_is_one_document(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    write_scene("a.scene.json", {"within": [1, 30], "rests": "crate"})
    write_scene("bad.scene.json", bodies=3)
    done = cli("compare", "--json", tmp_path)
    document = json.loads(done.out)
    assert done.code == document["exit_code"] == 2
    assert {"format", "sandbox", "pymunk", "seconds"} < set(document)
    ran, bad = document["scenes"]
    assert ran["verdict"] == "agrees"
    assert ran["steps"] == 30
    assert ran["pairs"] == ran["agreed"] + ran["touching"] > 0
    assert ran["pymunk_wrong"] == {}
    assert ran["disagreed"] == ran["missed"] == 0
    assert ran["disagreements"] == ran["misses"] == ran["saved"] == []
    assert 0.0 <= ran["worst_depth_m"] < 1e-9
    assert 0.0 <= ran["worst_normal_degrees"] < 0.01
    assert bad["verdict"] == "unusable"
    assert bad["problems"][0]["pointer"] == "/bodies"


def test_steps_and_every_choose_what_is_compared(cli: Callable, write_scene: Callable) -> None:
    path = write_scene("a.scene.json", {"at": 30, "rests": "crate"})
    done = cli("compare", "--json", "--steps", 9, "--every", 4, path)
    assert json.loads(done.out)["scenes"][0]["steps"] == 3


def test_a_disagreement_is_told_saved_and_fails(
    cli: Callable, write_scene: Callable, tmp_path: Path, lying_kernel: None
) -> None:
    path = write_scene("a.scene.json", bodies=[GROUND, {**CRATE, "velocity": [6, 0]}], settings={"steps": 50})
    done = cli("compare", path, "--save", tmp_path / "found")
    assert done.code == 1
    assert "disagrees" in done.out
    assert "step 1: ground and crate (polygon-polygon), depth or axis: sandbox is wrong" in done.out
    told = done.out.count("sandbox is wrong")
    more = re.search(r"(\d+) more disagreements", done.out)
    assert more is not None
    files = sorted((tmp_path / "found").glob("test_*.py"))
    assert len(files) == told + int(more[1]) > 20
    assert all("faults_of(PAIR) == []" in file.read_text() for file in files)


def test_a_disagreement_comes_with_exact_poses_in_json(
    cli: Callable, write_scene: Callable, lying_kernel: None
) -> None:
    done = cli("compare", "--json", write_scene("a.scene.json"))
    assert done.code == 1
    first = json.loads(done.out)["scenes"][0]["disagreements"][0]
    assert first["names"] == ["ground", "crate"]
    assert first["wrong"] == "sandbox"
    assert first["pair"]["center_b"] == [0.0, 0.5]
    assert first["exact"] == {"overlap": False, "separation": 0.0}


def test_options_that_do_not_fit_are_refused(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    path = write_scene("a.scene.json")
    (tmp_path / "file").write_text("")
    for arguments, message in [
        (["--plot", "a.svg"], "--plot draws the curves of --twin"),
        (["--twin", "--save", tmp_path], "--save writes disagreements"),
        (["--save", tmp_path / "file"], "not a folder"),
        (["--twin", "simpel"], 'no twin of that name; did you mean "simple"?'),
        (["--twin=box2d"], "no twin of that name; pymunk or simple"),
        (["--twin", "--plot", tmp_path / "a.jpg"], "must end in .png or .svg"),
        (["--twin", "--plot", tmp_path / "no" / "a.svg"], "does not exist"),
        (["--twin", "--plot", "a.svg", write_scene("b.scene.json")], "draws one scene; 2 were given"),
        (["-k", "zebra"], "nothing to compare: no path contains 'zebra'"),
    ]:
        done = cli("compare", path, *arguments)
        assert done.code == (5 if "zebra" in arguments else 2)
        assert message in done.err
        assert done.out == ""


def test_a_missing_file_is_told_and_the_others_run(cli: Callable, write_scene: Callable) -> None:
    done = cli("compare", write_scene("a.scene.json"), "no-such.scene.json")
    assert done.code == 2
    assert "no-such.scene.json" in done.err
    assert "1 agree, 1 could not be used" in done.out


def test_a_twin_is_a_table(cli: Callable, write_scene: Callable) -> None:
    done = cli("compare", "--twin", write_scene("a.scene.json"))
    assert done.code == 0
    for word in ("energy", "overlap", "height", "top", "sandbox", "pymunk", "pymunk runs at its defaults"):
        assert word in done.out
    assert len(re.findall(r"^\s*\d\.\d\d ", done.out, re.MULTILINE)) == 13
    assert "…" not in done.out


@pytest.mark.slow
def test_a_twin_in_json_and_as_a_picture(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    picture = tmp_path / "twin.svg"
    done = cli(
        "compare", "--twin", "--json", "--steps", 6, "--every", 3, "--plot", picture, write_scene("a.scene.json")
    )
    assert done.code == 0
    (scene,) = json.loads(done.out)["scenes"]
    assert scene["times"] == pytest.approx([0.0, 0.05, 0.1])
    for side in ("sandbox", "pymunk"):
        assert [set(each) for each in scene[side]] == [{"energy", "penetration", "height", "top"}] * 3
    assert scene["plot"] == picture.as_posix()
    assert picture.read_text().startswith("<?xml")


@pytest.mark.parametrize(
    "arguments", [["--twin", "simple", "PATH"], ["PATH", "--twin", "simple"], ["--twin=simple", "PATH"]]
)
def test_the_simple_solver_is_a_twin_by_name(cli: Callable, write_scene: Callable, arguments: list[str]) -> None:
    path = write_scene("a.scene.json").as_posix()
    done = cli("compare", "--json", *(path if part == "PATH" else part for part in arguments))
    assert done.code == 0
    document = json.loads(done.out)
    assert (document["twin"], "pymunk" in document) == ("simple", False)
    (scene,) = document["scenes"]
    assert len(scene["simple"]) == len(scene["sandbox"]) == len(scene["times"]) == 21
    assert "catches nothing in mid-step" in scene["notes"][0]


def test_the_picture_and_the_table_name_the_twin(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    done = cli("compare", write_scene("a.scene.json"), "--twin", "simple", "--plot", tmp_path / "twin.svg")
    assert done.code == 0
    assert "simple" in done.out
    assert "pymunk" not in done.out
    assert (tmp_path / "twin.svg").is_file()


def test_a_bare_twin_is_pymunk_and_what_follows_is_a_path(cli: Callable, write_scene: Callable) -> None:
    done = cli("compare", "--json", "--twin", write_scene("simply.scene.json"))
    assert json.loads(done.out)["twin"] == "pymunk"


def test_what_the_simple_solver_cannot_step_is_told(cli: Callable) -> None:
    done = cli("compare", "--twin", "simple", "cart", "--steps", 2)
    assert done.code == 2
    assert done.err.count("the simple solver knows contacts alone; this scene has 2 joints") == 1


def test_a_twin_of_a_bad_file_is_told(cli: Callable, write_scene: Callable) -> None:
    done = cli("compare", "--twin", "--json", write_scene("bad.scene.json", bodies=3))
    assert done.code == json.loads(done.out)["exit_code"] == 2
    assert "bad.scene.json:" in done.err


@pytest.mark.slow
def test_no_shipped_scene_disagrees_or_misses_a_pair(cli: Callable) -> None:
    """At three steps of the first second; `sandbox compare scenes/` looks at all."""
    done = cli("compare", scenes_dir(), "--steps", 61, "--every", 30, "--json")
    assert done.code == 0
    scenes = json.loads(done.out)["scenes"]
    assert len(scenes) == len(shipped_scenes()) > 40
    assert [scene["path"] for scene in scenes if scene["disagreed"] or scene["missed"]] == []
    assert sum(scene["pairs"] for scene in scenes) > 50_000


def test_a_folder_of_shipped_scenes_agrees(cli: Callable) -> None:
    done = cli("compare", scenes_dir() / "masonry", "--every", 10)
    assert done.code == 0
    assert "3 scenes: 3 agree" in done.out
