"""`sandbox events`: what happened, for people and for machines."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

import sandbox
from sandbox.engine.events.events import KINDS

DROP = {"id": "drop", "position": [0, 4], "shapes": [{"circle": 0.5}]}
GATE = {"id": "gate", "type": "static", "position": [0, 2], "shapes": [{"box": [2, 1], "sensor": True}]}
GROUND = {"id": "ground", "type": "static", "position": [0, -0.5], "shapes": [{"box": [40, 1]}]}


def test_a_fall_is_told_in_order(cli: Callable, write_scene: Callable[..., Path]) -> None:
    path = write_scene("fall.scene.json", bodies=[GROUND, GATE, DROP], settings={"steps": 120})
    done = cli("events", path)
    assert done.code == 0
    *lines, last = done.out.splitlines()
    assert [line.split()[3] for line in lines] == ["enter", "leave", "begin", "hit", "sleep"]
    assert "drop in gate" in lines[0]
    assert "drop out of gate" in lines[1]
    assert last == "5 events"


def test_the_document_is_what_the_world_says(cli: Callable, write_scene: Callable[..., Path]) -> None:
    path = write_scene("fall.scene.json", bodies=[GROUND, GATE, DROP], settings={"steps": 120})
    document = json.loads(cli("events", path, "--json").out)
    world = sandbox.World(sandbox.load_scene(path))
    expected = []
    for _ in range(120):
        world.step()
        expected += list(world.events)
    assert document["events"] == expected
    assert sum(document["counts"].values()) == len(expected)


def test_only_what_is_asked_for(cli: Callable, write_scene: Callable[..., Path]) -> None:
    other = {**DROP, "id": "far", "position": [9, 4]}
    path = write_scene("fall.scene.json", bodies=[GROUND, GATE, DROP, other], settings={"steps": 120})
    rows = json.loads(cli("events", path, "--json", "--kind", "hit", "--kind", "begin", "--body", "f*").out)["events"]
    assert [(row["event"], row["b"]) for row in rows] == [("begin", "far"), ("hit", "far")]
    assert cli("events", path, "--steps", "5").out == "0 events\n"


def test_an_unknown_kind_is_refused(cli: Callable) -> None:
    done = cli("events", "zigzag", "--kind", "bump")
    assert (done.code, done.out) == (2, "")
    assert all(kind in done.err for kind in KINDS)


def test_a_scene_that_is_not_there(cli: Callable, tmp_path: Path) -> None:
    done = cli("events", tmp_path / "no.scene.json")
    assert (done.code, done.out) == (2, "")
    assert "no.scene.json" in done.err


@pytest.mark.parametrize(
    ("body", "said"),
    [("gruond", 'did you mean "ground"?'), ("zzz", "stand for several"), ("cr?te-*", 'did you mean "crate"?')],
)
def test_a_body_that_is_not_there_is_a_mistake(cli: Callable, write_scene: Callable, body: str, said: str) -> None:
    done = cli("events", write_scene("a.scene.json"), "--body", body)
    assert (done.code, done.out) == (2, "")
    assert f"--body: no body or joint {body!r} in this scene; " in done.err
    assert said in done.err
    assert cli("events", write_scene("a.scene.json"), "--body", "cr*").code == 0


PUSH = [3, "ApplyImpulse", {"body": "crate", "impulse": [0.0, 5.0]}]
NEW = [5, "Spawn", {"bodies": [{"id": "late", "position": [0, 5], "shapes": [{"circle": 0.25}]}]}]


class TestRecording:
    """What happens in a recording happens to its commands too."""

    @pytest.fixture(autouse=True)
    def recording(self, cli: Callable, write_scene: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.chdir(tmp_path)
        write_scene("a.scene.json", settings={"steps": 80})
        Path("commands.json").write_text(json.dumps([PUSH, NEW]))
        assert cli("record", "a.scene.json", "-o", "a.replay.json", "--commands", "commands.json").code == 0

    def test_the_events_are_those_of_the_run_that_was_recorded(self, cli: Callable) -> None:
        recording = sandbox.Recording.load("a.replay.json")
        recorder = sandbox.Recorder(sandbox.World(recording.load_scene()))
        expected = []
        for step in range(recording.steps):
            for at, command in recording.commands:
                if at == step:
                    recorder.apply(command)
            recorder.step()
            expected += list(recorder.world.events)
        found = json.loads(cli("events", "a.replay.json", "--json").out)
        assert (found["scene"], found["events"]) == ("a.replay.json", expected)
        assert {"end", "hit"} <= found["counts"].keys()  # the crate lies still without the push
        assert json.loads(cli("events", "a.scene.json", "--json").out)["events"] != expected

    @pytest.mark.parametrize("body", ["late", "la*"])
    def test_a_body_that_comes_is_asked_for(self, cli: Callable, body: str) -> None:
        assert {
            row["event"] for row in json.loads(cli("events", "a.replay.json", "--json", "--body", body).out)["events"]
        }
        assert cli("events", "a.scene.json", "--body", body).code == 2

    @pytest.mark.parametrize("words", [["events"], ["sat"], ["render", "-o", "a.png"], ["render", "-o", "a.gif"],
                                       ["render", "-o", "a.html"]], ids=" ".join)  # fmt: skip
    def test_nobody_knows_what_comes_after_its_end(self, cli: Callable, words: list[str]) -> None:
        """A page went on as if nobody had done anything then."""
        option = "--step" if words[0] == "sat" or words[-1] == "a.png" else "--steps"
        done = cli(*words, "a.replay.json", option, "81")
        assert (done.code, done.err) == (2, "sandbox: step 81: a.replay.json has 80 steps\n")
        assert cli(*words, "a.replay.json", option, "80", *SMALL.get(words[-1], ())).code == 0

    def test_values_are_for_scenes(self, cli: Callable) -> None:
        done = cli("events", "a.replay.json", "--set", "gravity.1=1")
        assert (done.code, "--set is for scenes" in done.err) == (2, True)

    def test_a_command_that_is_refused_is_placed(self, cli: Callable) -> None:
        path = Path("a.replay.json")
        path.write_text(path.read_text().replace('"crate", "impulse"', '"carte", "impulse"'))
        done = cli("events", "a.replay.json")
        assert (done.code, "a.replay.json:" in done.err, "carte" in done.err) == (2, True, True)

    def test_the_pair_of_a_step_is_that_of_the_recording(self, cli: Callable) -> None:
        """After the push the crate is in the air."""
        pushed, still = (
            json.loads(cli("sat", name, "--bodies", "ground", "crate", "--step", "20", "--json").out)
            for name in ("a.replay.json", "a.scene.json")
        )
        low, rests = (min(y for _, y in each["bodies"][1]["vertices"]) for each in (pushed, still))
        assert (pushed["step"], rests) == (20, pytest.approx(0.0, abs=0.01))
        assert low > 0.5


SMALL = {"a.png": ("--size", "64x48"), "a.gif": ("--size", "64x48")}


def test_bodies_that_rules_bring_are_asked_for(cli: Callable, write_scene: Callable) -> None:
    """They are called ID-1, ID-2, ... and stand in no scene."""
    drop = {"id": "drop", "position": [0, 3], "shapes": [{"circle": 0.2}]}
    rules = [{"when": {"every": 0.2}, "do": [{"spawn": drop}]}]
    path = write_scene("rain.scene.json", rules=rules, settings={"steps": 60})
    told = cli("events", path, "--body", "drop-2", "--kind", "spawn").out
    assert "drop-2" in told
    assert cli("events", path, "--body", "drop-*").code == 0
    assert cli("events", path, "--body", "drip-1").code == 2
