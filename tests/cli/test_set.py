"""`--set` on the command line."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest


@pytest.fixture
def scene(write_scene: Callable[..., Path], monkeypatch: pytest.MonkeyPatch) -> str:
    path = write_scene("a.scene.json", {"at": 5, "rests": "crate"}, vars={"g": 9.81}, gravity=[0, "=-g"])
    monkeypatch.chdir(path.parent)
    return path.name


def test_values_reach_the_commands(cli: Callable, scene: str) -> None:
    assert cli("check", scene).code == 0
    moved = cli("check", scene, "--set", "bodies.crate.position.1=5", "--json")
    assert moved.code == 1
    assert json.loads(moved.out)["scenes"][0]["verdict"] == "failed"
    assert cli("events", scene, "--set", "bodies.crate.position.1=0.52", "--steps", "60", "--kind", "begin").out
    assert cli("render", scene, "-o", "x.svg", "--set", "title=Moon").code == 0
    assert "Moon" in Path("x.svg").read_text(encoding="utf-8")


def test_an_expression_is_a_value_also_where_the_scene_has_none(cli: Callable, write_scene: Callable) -> None:
    plain = write_scene("plain.scene.json", {"at": 5, "rests": "crate"})
    assert cli("expand", plain, "--set", "bodies.crate.mass==1 + 1").out.count('"mass": 2') == 1
    assert 'no number is named "rows"' in cli("check", plain, "--set", "bodies.crate.mass==rows").err


def test_a_recording_with_values_is_replayed(cli: Callable, scene: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("CI", raising=False)
    assert cli("record", scene, "-o", "a.replay.json", "--steps", "10", "--set", "vars.g=1.62").code == 0
    assert json.loads(Path("a.replay.json").read_text())["scene"]["set"] == {"vars.g": 1.62}
    assert cli("replay", "a.replay.json").code == 0
    assert cli("replay", "a.replay.json", "--update").code == 0
    assert json.loads(Path("a.replay.json").read_text())["scene"]["set"] == {"vars.g": 1.62}


@pytest.mark.parametrize(
    ("command", "more"),
    [
        ("bench", ["--engines", "sandbox"]),
        ("bisect", ["--good", "HEAD"]),
        ("compare", []),
        ("compare", ["--twin"]),
        ("diff", ["a.scene.json"]),
        ("expand", []),
        ("export", ["-o", "x.py"]),
        ("lint", []),
        ("sat", []),
        ("solver", []),
        ("sweep", ["--vary", "vars.g=1,2"]),
    ],
)
def test_every_command_that_reads_a_scene_takes_values(
    cli: Callable, scene: str, command: str, more: list[str]
) -> None:
    done = cli(command, scene, *more, "--set", "bodies.crate.mass=true")
    said = "a.scene.json: --set bodies.crate.mass: mass must be a number, not true or false"
    assert (done.code, said in done.err.replace("\n", " ")) == (2, True), done


def test_of_two_scenes_the_second_gets_the_values(cli: Callable, scene: str) -> None:
    done = cli("diff", scene, scene, "--set", "bodies.crate.velocity.0=1")
    assert done.code == 1
    assert "velocity_x expected 0.0 m/s, got 1.0 m/s" in done.out
    assert cli("diff", scene, scene, "--set", "title=Moon").code == 0


def test_what_lint_finds_in_a_value_is_told_where_it_would_stand(cli: Callable, scene: str) -> None:
    done = cli("lint", scene, "--set", "bodies.crate.position=[0,0]", "--select", "overlap")
    assert (done.code, done.out.count("overlap")) == (1, 1)


@pytest.mark.parametrize(
    ("command", "given", "said"),
    [
        ("check", ["vars.h=1"], 'a.scene.json: --set vars.h: the scene has no number "h": it has g'),
        ("check", ["vars"], "sandbox: --set 'vars': write a path and a value, such as --set gravity.1=-1.62"),
        ("check", ["=1"], "sandbox: --set '=1': write a path and a value, such as --set gravity.1=-1.62"),
        ("check", ["vars.g=1", "vars.g=2"], "sandbox: --set vars.g is given twice"),
        ("check", ["vars.g=NaN"], "a.scene.json: --set vars.g: must be a finite number"),
        ("run", ["vars.h=1"], 'a.scene.json: --set vars.h: the scene has no number "h": it has g'),
        ("events", ["vars.g=x"], "a.scene.json: --set vars.g: must be a number, not text"),
    ],
)
def test_wrong_ones_are_one_message(cli: Callable, scene: str, command: str, given: list[str], said: str) -> None:
    done = cli(command, scene, *(word for value in given for word in ("--set", value)))
    assert done.code == 2
    assert said in done.err.replace("\n", " ")
    assert "Traceback" not in done.err


def test_recordings_bring_their_scene(cli: Callable, scene: str) -> None:
    cli("record", scene, "-o", "a.replay.json", "--steps", "2")
    for arguments in (["run"], ["render", "-o", "x.png"], ["diff", scene]):
        done = cli(*arguments, "a.replay.json", "--set", "vars.g=1")
        assert done.code == 2
        assert "a.replay.json is a recording, which brings its scene: --set is for scenes" in done.err
