"""Holding a recording against what it gives now, and against another one."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

import sandbox
from sandbox.replay.comparison import compare_two, compare_with_recording, field_rows
from sandbox.replay.golden.run import RunStepper, run_of
from sandbox.replay.recording.recorder import record

SCENE = sandbox.Scene(
    title="A fall",
    bodies=[
        {"id": "ground", "type": "static", "shapes": [{"box": [20, 1]}], "position": [0, -0.5]},
        {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 2]},
        {"id": "ball", "shapes": [{"circle": 0.5}], "position": [4, 3]},
    ],
)
STEPS = 60


@pytest.fixture
def recording(tmp_path: Path) -> sandbox.Recording:
    SCENE.save(tmp_path / "fall.scene.json")
    record(sandbox.load_scene(tmp_path / "fall.scene.json"), STEPS).save(tmp_path / "fall.replay.json")
    return sandbox.Recording.load(tmp_path / "fall.replay.json")


def test_what_runs_as_recorded_has_no_difference_and_is_its_own_ghost(recording: sandbox.Recording) -> None:
    told: list[int] = []
    found = compare_with_recording(recording, told.append)
    assert (found.divergence, found.edits, found.body, found.where()) == (None, (), None, [])
    assert found.expected == run_of(recording)
    assert told
    assert told == sorted(told)
    assert told[-1] <= STEPS


@pytest.mark.parametrize(("step", "group"), [(1, 0), (17, 3), (STEPS, 1)])
def test_a_tampered_fingerprint_is_found_at_its_step(recording: sandbox.Recording, step: int, group: int) -> None:
    parts = recording.digests[step - 1].split(" ")
    parts[group] = "0000" if parts[group] != "0000" else "1111"
    digests = (*recording.digests[: step - 1], " ".join(parts), *recording.digests[step:])
    found = compare_with_recording(replace(recording, digests=digests))
    assert found.divergence is not None
    assert (found.divergence.step, found.divergence.group) == (step, ("pairs", "manifolds", "impulses", "poses")[group])
    assert found.divergence.expected == parts[group]
    assert found.expected is None  # no run gives what never was


def test_an_edited_scene_is_told_with_the_body_and_the_first_step(recording: sandbox.Recording) -> None:
    path = recording.scene.path
    assert path is not None
    data = json.loads(path.read_text())
    data["bodies"][2]["position"] = [4, 3.25]
    path.write_text(json.dumps(data))
    found = compare_with_recording(recording)
    assert found.edits == ("body ball was edited",)
    assert found.divergence is not None
    assert found.divergence.step == 1
    assert found.body == "ball"
    assert "body ball was edited" in found.lines()


def test_what_was_edited_comes_before_what_it_threw_farthest(tmp_path: Path) -> None:
    """The crate is heavy and hardly moved by what it strikes; the feather flies."""
    crate = {"id": "crate", "shapes": [{"box": [1, 1], "density": 100}], "position": [0, 0], "velocity": [5, 0]}
    feather = {"id": "feather", "shapes": [{"circle": 0.2, "density": 0.1, "restitution": 1}], "position": [2, 0]}
    for speed in (5, 5.5):
        crate["velocity"] = [speed, 0]
        sandbox.Scene(gravity=(0, 0), bodies=[crate, feather]).save(tmp_path / "throw.scene.json")
        if speed == 5:
            record(sandbox.load_scene(tmp_path / "throw.scene.json"), STEPS).save(tmp_path / "throw.replay.json")
    found = compare_with_recording(sandbox.Recording.load(tmp_path / "throw.replay.json"))
    assert found.drifts[0].body == "feather"
    assert found.body == "crate"


def test_of_two_recordings_the_first_number_that_differs_is_named(recording: sandbox.Recording) -> None:
    moved = record(recording.load_scene(), STEPS, ((20, sandbox.SetVelocity("ball", (1.0, 0.0), 0.0)),))
    found = compare_two(moved, recording)
    assert found.divergence is not None
    assert found.divergence.step == 21
    assert found.body == "ball"
    assert found.expected is not None
    assert found.expected.commands == ()
    assert found.drifts[0].body == "ball"
    assert found.drifts[0].distance > 0.5
    assert compare_two(recording, recording).divergence is None


def test_two_lengths_and_two_scenes_are_told(recording: sandbox.Recording) -> None:
    heavier = sandbox.Scene(**{**SCENE.to_data(), "gravity": [0, -12]})
    found = compare_two(record(heavier, STEPS + 10), recording)
    assert found.edits == ("settings, gravity or regions were edited",)
    assert found.notes == (f"it has {STEPS} steps, this one {STEPS + 10}",)
    assert found.drifts == ()


def test_the_fields_of_a_body_stand_side_by_side(recording: sandbox.Recording) -> None:
    run = run_of(recording)
    one, two = (RunStepper(run.scene, ()) for _ in range(2))
    two.world.apply(sandbox.SetVelocity("crate", (0.5, 0.0), 0.0))
    for stepper in (one, two):
        stepper.advance()
    crate, ball = (one.world.names.index(name) for name in ("crate", "ball"))
    rows = {row.field: row for row in field_rows(one.world.state.bodies[crate], two.world.state.bodies[crate])}
    assert rows["velocity_x"].expected == 0.0
    assert rows["velocity_x"].difference == pytest.approx(0.5)
    assert rows["velocity_x"].ulps > 0
    assert rows["position_y"].ulps == 0
    same = field_rows(one.world.state.bodies[ball], two.world.state.bodies[ball])
    assert [row.ulps for row in same] == [0] * 6
    assert [row.difference for row in field_rows(None, two.world.state.bodies[ball])] == [None] * 6
