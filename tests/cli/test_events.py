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
