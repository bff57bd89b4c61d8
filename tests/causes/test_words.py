"""What is said of a cause that git knows, knows in part, or does not know at all."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from sandbox.engine.arithmetic_version import ARITHMETIC
from tests.causes.conftest import BOX, PUSH, SLOPE, Views, place, record, write
from tests.git_folder import commit, needs_git


def edit(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


def spoil(golden: Path, step: int) -> None:
    """Write another fingerprint of a step."""
    lines = golden.read_text(encoding="utf-8").split("\n")
    lines[lines.index('  "digests": [') + step] = '    "0000 0000 0000 0000",'
    golden.write_text("\n".join(lines), encoding="utf-8")


def test_without_git_a_scene_has_no_past(views: Callable[..., Views], cli: Callable) -> None:
    write()
    golden = record(cli)
    write(friction=0.2)
    seen = views(golden)
    assert seen.divergence["detail"] is None
    assert seen.all_say("cause: the scene was edited: how it was before is not known, for it is not kept in git")
    assert seen.all_say("with a copy of the earlier one: sandbox diff EARLIER.scene.json slide.scene.json")


@needs_git
def test_git_may_not_know_the_version_that_was_recorded(views: Callable[..., Views], cli: Callable) -> None:
    write(friction=0.4)
    commit()
    write()
    golden = record(cli)
    write(friction=0.2)
    assert views(golden).all_say("none of its versions in git is the recorded one")


@needs_git
def test_a_scene_that_was_edited_is_not_all(views: Callable[..., Views], cli: Callable) -> None:
    """The earlier scene is known, but does not give what was recorded."""
    write()
    golden = record(cli)
    spoil(golden, 9)
    commit()
    scene = write(friction=0.2)
    seen = views(golden)
    assert seen.all_say(f"{place(scene, '0.2')}: materials.stuff.friction was 0.3 and is 0.2")
    assert seen.all_say("with that undone the recorded steps do not come back either")
    assert seen.divergence["detail"] is None


@needs_git
def test_a_scene_inside_the_recording(views: Callable[..., Views], cli: Callable) -> None:
    write()
    golden = record(cli, "--embed")
    commit()
    edit(golden, '"friction": 0.3', '"friction": 0.25')
    seen = views(golden)
    spot = place(golden, "0.25")
    assert seen.all_say(f"cause: the scene was edited: {spot}: materials.stuff.friction was 0.3 and is 0.25")
    assert seen.divergence["detail"]["body"] == "box"
    assert seen.all_say("body box: slide.replay.json:")


@needs_git
def test_of_many_versions_the_recorded_one_is_found(views: Callable[..., Views], cli: Callable) -> None:
    revisions = []
    for friction in (0.5, 0.3, 0.6):
        write(friction=friction)
        golden = record(cli) if friction == 0.3 else Path("slide.replay.json")
        revisions.append(commit())
    write(SLOPE, {**BOX, "position": [-3, 4.01]})
    seen = views(golden)
    assert seen.divergence["cause"]["origin"] == f"slide.scene.json of revision {revisions[1]}"
    assert seen.all_say("bodies[box].position was [-3, 4] and is [-3, 4.01]")


def test_commands_that_git_does_not_know_may_have_been_edited(views: Callable[..., Views], cli: Callable) -> None:
    write()
    Path("push.json").write_text(json.dumps([PUSH]))
    golden = record(cli, "--commands", "push.json")
    edit(golden, "[0.5, 0.0]", "[0.75, 0.0]")
    seen = views(golden)
    assert seen.divergence["step"] == 21
    assert seen.all_say("whether its command was edited is not known, for the recording is not kept in git")


@needs_git
def test_a_step_more(views: Callable[..., Views], cli: Callable) -> None:
    write()
    Path("push.json").write_text(json.dumps([PUSH]))
    golden = record(cli, "--commands", "push.json")
    commit()
    edit(golden, "[20, ", "[19, ")
    seen = views(golden)
    assert seen.divergence["step"] == 20
    assert seen.all_say("command 1 (step 19, ApplyImpulse on box): its step was 20 and is 19")


def test_where_nothing_is_known_to_be_another(views: Callable[..., Views], cli: Callable) -> None:
    write()
    golden = record(cli)
    spoil(golden, 9)
    seen = views(golden)
    assert seen.divergence["step"] == 9
    assert seen.divergence["cause"]["kind"] in ("unknown", "engine")  # in a checkout that is being worked on
    assert seen.all_say("for the first number that differs: sandbox replay slide.replay.json --against ")


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (f'"arithmetic": {ARITHMETIC}', '"arithmetic": 1', "arithmetic was changed on purpose since sandbox"),
        (f'"arithmetic": {ARITHMETIC}', '"arithmetic": 99', "recorded by a later version"),
        ('"sandbox": "', '"sandbox": "0.0.1-', "sandbox 0.0.1-"),
        ('"environment": "', '"environment": "PyPy, ', "recorded with PyPy, "),
    ],
)
def test_another_version_or_other_surroundings(
    views: Callable[..., Views], cli: Callable, old: str, new: str, words: str
) -> None:
    write()
    golden = record(cli)
    spoil(golden, 9)
    edit(golden, old, new)
    seen = views(golden)
    # Other surroundings should make no difference, and so are no cause; the checkout may be one that is worked on.
    assert seen.divergence["cause"]["kind"] == "engine" or "environment" in old
    assert words in "\n".join(seen.divergence["cause"]["said"])
    assert seen.all_say(words)
    assert seen.text.count(words) == 1


def test_a_figure_out_of_tolerance_has_a_cause_but_no_number(views: Callable[..., Views], cli: Callable) -> None:
    write()
    golden = record(cli)
    write(friction=0.1)
    seen = views(golden, "--tolerance")
    assert seen.divergence["group"] not in ("pairs", "manifolds", "impulses", "poses")
    assert seen.divergence["cause"]["kind"] == "scene"
    assert seen.divergence["detail"] is None


@needs_git
def test_a_shallow_clone_says_how_to_get_more(
    views: Callable[..., Views], cli: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As a CI server checks out: the scene was edited in the last commit, and no other is there."""
    write()
    golden = record(cli)
    commit()
    write(friction=0.2)
    commit()
    clone = ["git", "clone", "-q", "--depth=1", f"file://{tmp_path}", "shallow"]
    subprocess.run(clone, check=True, capture_output=True)
    monkeypatch.chdir("shallow")
    assert views(golden).all_say("git has only the latest revisions here: git fetch --unshallow")
    subprocess.run(["git", "fetch", "-q", "--unshallow"], check=True, capture_output=True)
    assert views(golden).all_say("materials.stuff.friction was 0.3 and is 0.2")


@needs_git
def test_a_note_on_github_stands_beside_the_edit(
    views: Callable[..., Views], cli: Callable, monkeypatch: pytest.MonkeyPatch
) -> None:
    write()
    golden = record(cli)
    commit()
    scene = write(friction=0.2)
    monkeypatch.setenv("GITHUB_ACTIONS", "true")
    line = place(scene, "0.2").split(":")[1]
    assert f"::error file=slide.scene.json,line={line},title=replay stale::" in views(golden).text


@needs_git
def test_in_a_hook_of_another_repository(
    views: Callable[..., Views], cli: Callable, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    write()
    golden = record(cli)
    commit()
    write(friction=0.2)
    monkeypatch.setenv("GIT_DIR", str(tmp_path / "elsewhere"))
    monkeypatch.setenv("GIT_INDEX_FILE", str(tmp_path / "elsewhere" / "index"))
    assert views(golden).all_say("materials.stuff.friction was 0.3 and is 0.2")


@needs_git
def test_a_figure_out_of_tolerance_has_the_edit_too(views: Callable[..., Views], cli: Callable) -> None:
    write()
    golden = record(cli)
    commit()
    write(friction=0.1)
    seen = views(golden, "--tolerance")
    assert seen.all_say("materials.stuff.friction was 0.3 and is 0.1")
    assert "do not come back" not in seen.text


@needs_git
def test_a_command_that_is_refused_now_was_another(views: Callable[..., Views], cli: Callable) -> None:
    write()
    Path("push.json").write_text(json.dumps([PUSH]))
    golden = record(cli, "--commands", "push.json")
    commit()
    edit(golden, '"body": "box", "impulse"', '"body": "bax", "impulse"')
    seen = views(golden)
    assert (seen.divergence["step"], seen.divergence["group"]) == (20, "command")
    assert seen.all_say('command 1 (step 20, ApplyImpulse on bax): body was "box" and is "bax"')


@needs_git
def test_an_edit_of_no_consequence_is_told_too(views: Callable[..., Views], cli: Callable) -> None:
    write()
    golden = record(cli)
    commit()
    scene = write(settings={"steps": 60, "push_out_speed": 2.5})
    seen = views(golden)
    if seen.divergence["group"] == "rest":  # settings are in the digest at the end
        assert seen.divergence["detail"]["field"] == "push_out_speed"
    assert seen.all_say(f"{place(scene, '2.5')}: settings.push_out_speed is new: 2.5")
    assert "all steps came out the same nevertheless" in views(golden, "--tolerance").text
    assert views(golden, "--tolerance").all_say("settings.push_out_speed is new: 2.5")
