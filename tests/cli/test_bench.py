"""`sandbox bench` as a user calls it."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable

import pytest


@pytest.fixture
def without_pyb2d3(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if pyb2d3 were not installed."""
    monkeypatch.setitem(sys.modules, "pyb2d3", None)


def test_the_document(cli: Callable, write_scene: Callable) -> None:
    path = write_scene("a.scene.json", {"at": 20, "inside": [-1, 0, 1, 1]})
    done = cli("bench", path, "--engines", "sandbox,pymunk", "--steps", 3, "--json")
    assert (done.code, done.err) == (0, "")
    document = json.loads(done.out)
    assert document["exit_code"] == 0
    (scene,) = document["scenes"]
    assert (scene["title"], scene["steps"], scene["bodies"], scene["shapes"]) == ("a.scene.json", 3, 2, 2)
    ours, pymunk = scene["engines"]
    assert (ours["name"], pymunk["name"]) == ("sandbox", "pymunk")
    assert ours.keys() - pymunk.keys() == {"digest", "contacts", "awake", "frozen", "table_bytes"}
    for engine in scene["engines"]:
        assert len(engine["turns_ms_per_step"]) == 2
        assert engine["escaped"] == engine["lost"] == 0
        assert 0.0 <= engine["deepest_overlap_m"] < 0.01
        assert engine["first_step_ms"] >= 0.0
    checked = json.loads(cli("check", path, "--steps", 3, "--json").out)
    assert len(ours["digest"]) == len(checked["scenes"][0]["digest"]) == 16


def test_the_table_and_the_profile(cli: Callable, write_scene: Callable) -> None:
    done = cli("bench", write_scene("a.scene.json"), "--engines", "pymunk,sandbox", "--steps", 3, "--profile")
    assert (done.code, done.err) == (0, "")
    assert "2 bodies, 2 shapes, 0 joints, 1 contact, 3 steps" in done.out
    assert "step ms    ratio  overlap mm" in done.out
    lines = done.out.splitlines()
    assert [line.split()[0] for line in lines if line.startswith(("pymunk", "sandbox"))] == ["pymunk", "sandbox"]
    assert "sandbox: digest " in done.out
    assert "ms a step: collide " in done.out


def test_the_document_is_kept_beside_the_table_and_over_nothing(cli: Callable, write_scene: Callable) -> None:
    path = write_scene("a.scene.json")
    file = path.with_name("found.json")
    command = "bench", path, path.with_name("nowhere.json"), "--engines", "sandbox", "--steps", 3, "-o", file
    done = cli(*command)
    assert (done.code, "step ms    ratio" in done.out) == (2, True)
    document = json.loads(file.read_text("utf-8"))
    assert (document["exit_code"], [*map(len, document["scenes"])]) == (2, [8, 2])
    again = cli(*command)
    assert (again.code, "there is a file of that name already; --force writes over it" in again.err) == (2, True)
    assert json.loads(file.read_text("utf-8")) == document
    machine = cli(*command[:2], *command[3:], "--force", "--json")
    assert (machine.code, machine.out) == (0, file.read_text("utf-8"))


def test_one_step_has_no_turns(cli: Callable, write_scene: Callable) -> None:
    done = cli("bench", write_scene("a.scene.json"), "--engines", "sandbox", "--steps", 1, "--json")
    (engine,) = json.loads(done.out)["scenes"][0]["engines"]
    assert (engine["ms_per_step"], engine["sandbox_over_this"], engine["turns_ms_per_step"]) == (None, None, [])


def test_box2d_takes_part(cli: Callable, write_scene: Callable) -> None:
    pytest.importorskip("pyb2d3")
    done = cli("bench", write_scene("a.scene.json"), "--steps", 3, "--json")
    engines = json.loads(done.out)["scenes"][0]["engines"]
    assert [engine["name"] for engine in engines] == ["sandbox", "pymunk", "box2d"]
    assert engines[2]["label"].startswith("Box2D (pyb2d3 ")


def test_a_missing_engine_is_left_out_by_name(cli: Callable, write_scene: Callable, without_pyb2d3: None) -> None:
    done = cli("bench", write_scene("a.scene.json"), "--steps", 2, "--json")
    assert done.code == 0
    assert done.err.startswith("sandbox: box2d is left out.")
    assert "pip install pyb2d3" in done.err
    assert [engine["name"] for engine in json.loads(done.out)["scenes"][0]["engines"]] == ["sandbox", "pymunk"]


def test_no_engine_is_nothing_to_do(cli: Callable, without_pyb2d3: None) -> None:
    done = cli("bench", "pyramid-10", "--engines", "box2d")
    assert (done.code, done.out) == (5, "")
    assert "box2d is left out" in done.err
    assert json.loads(cli("bench", "pyramid-10", "--engines", "box2d", "--json").out)["exit_code"] == 5


@pytest.mark.parametrize(
    ("names", "hint"), [("sandbox,pymnuk", 'did you mean "pymunk"?'), ("", "there are sandbox, pymunk, box2d")]
)
def test_a_name_that_no_engine_has(cli: Callable, names: str, hint: str) -> None:
    done = cli("bench", "pyramid-10", f"--engines={names}")
    assert (done.code, done.out) == (2, "")
    assert done.err.count("sandbox: --engines") == 1
    assert hint in done.err


@pytest.mark.parametrize("steps", ["0", "-1", "many"])
def test_bad_numbers_of_steps(cli: Callable, steps: str) -> None:
    done = cli("bench", "pyramid-10", f"--steps={steps}")
    assert done.code == 2
    assert "--steps" in done.err


def test_a_bad_scene_is_told_and_the_others_run(cli: Callable, write_scene: Callable) -> None:
    bad, good = write_scene("bad.scene.json", bodies=3), write_scene("good.scene.json")
    done = cli("bench", bad, good, "--engines", "sandbox", "--steps", 2, "--json")
    document = json.loads(done.out)
    assert done.code == document["exit_code"] == 2
    assert done.err.count("bad.scene.json:") == 1
    assert document["scenes"][0]["problems"]
    assert document["scenes"][1]["engines"][0]["name"] == "sandbox"


def test_a_misspelt_scene_gets_a_hint(cli: Callable) -> None:
    done = cli("bench", "box2d-smahs", "--engines", "sandbox", "--steps", 1)
    assert (done.code, done.out) == (2, "")
    assert 'did you mean "box2d-smash"' in done.err


@pytest.mark.slow
def test_workers_take_part_one_after_another(cli: Callable, write_scene: Callable) -> None:
    path = write_scene("a.scene.json")
    done = cli("bench", path, "--engines", "sandbox,pymunk", "--workers", "1,2", "--steps", 3, "--json")
    assert (done.code, done.err) == (0, "")
    one, two, pymunk = json.loads(done.out)["scenes"][0]["engines"]
    assert [each["name"] for each in (one, two, pymunk)] == ["sandbox", "sandbox 2", "pymunk"]
    assert two["label"] == "sandbox, 2 workers"
    assert one["digest"] == two["digest"]
    assert "sandbox, 2 workers: digest " in cli("bench", path, "--engines", "sandbox", "--workers", "2").out


@pytest.mark.parametrize("wrong", ["0", "two", "1,,2", "-1", "1.5", "65", ""])
def test_wrong_workers(cli: Callable, write_scene: Callable, wrong: str) -> None:
    done = cli("bench", write_scene("a.scene.json"), "--workers", wrong)
    assert done.code == 2
    assert f"--workers {wrong}: takes numbers from 1 to 64 with commas between, as 1,2" in done.err
