"""Recordings: what was recorded comes back from its file, runs again to the bit, and is small and readable."""

from __future__ import annotations

import importlib
import inspect
import json
import pickle
import pkgutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
import sandbox.engine.commands
from sandbox import ApplyImpulse, MoveDrag, SetPose
from sandbox.engine.commands.base import Command
from sandbox.engine.commands.registry import COMMAND_CLASSES
from sandbox.replay.recording.command_words import decode, encode, plain_command
from sandbox.replay.recording.meaning import meaning_of
from tests.replay.played import COMMANDS, STEPS, recording, scene


@pytest.fixture(scope="module")
def recorded() -> sandbox.Recording:
    return recording()


def test_a_file_holds_all_of_a_recording(recorded: sandbox.Recording, tmp_path: Path) -> None:
    recorded.save(tmp_path / "a.replay.json")
    loaded = sandbox.Recording.load(tmp_path / "a.replay.json")
    assert replace(loaded, scene=recorded.scene, source=None) == recorded
    assert loaded.scene.meaning == recorded.scene.meaning
    assert loaded.load_scene() == scene()
    assert loaded.commands == COMMANDS
    loaded.save(tmp_path / "b.replay.json")
    assert (tmp_path / "b.replay.json").read_bytes() == (tmp_path / "a.replay.json").read_bytes()


def test_it_runs_again_to_the_bit(recorded: sandbox.Recording, tmp_path: Path) -> None:
    recorded.save(tmp_path / "a.replay.json")
    outcome = sandbox.rerun(sandbox.Recording.load(tmp_path / "a.replay.json"))
    assert (outcome.verdict, outcome.steps, outcome.divergence, outcome.edits) == ("passed", STEPS, None, ())


def test_the_recorder_records_what_goes_through_it() -> None:
    recorder = sandbox.Recorder(sandbox.World(scene()))
    for step in range(STEPS):
        for at, command in COMMANDS:
            if at == step:
                recorder.apply(command)
        recorder.step()
    assert recorder.recording() == recording()


def test_a_refused_command_of_a_run_is_told_with_its_index_and_step() -> None:
    script = [(7, ApplyImpulse("nobody", (1.0, 0.0))), (2, sandbox.SetGravity((0.0, -1.0)))]
    with pytest.raises(
        sandbox.RefusedCommandError, match=r"commands\[0\]: ApplyImpulse after step 7 \(0.117 s\)"
    ) as told:
        sandbox.record(scene(), 9, script)
    error = pickle.loads(pickle.dumps(told.value))
    assert (error.index, error.command, error.step) == (0, "ApplyImpulse", 7)
    assert error.reason.startswith("no body 'nobody'")
    assert isinstance(told.value.__cause__, sandbox.UnknownBodyError)
    player = sandbox.Player(sandbox.Run(scene(), 9, (script[0],)))
    with pytest.raises(sandbox.RefusedCommandError, match=r"commands\[0\]: ApplyImpulse after step 7"):
        player.step(9)


def test_a_refused_command_is_not_recorded() -> None:
    recorder = sandbox.Recorder(sandbox.World(scene()))
    with pytest.raises(sandbox.UnknownBodyError):
        recorder.apply(MoveDrag("nobody", (0, 0)))
    with pytest.raises(sandbox.CommandError, match="finite"):
        recorder.apply(SetPose("ball", (float("nan"), 0), 0))
    with pytest.raises(sandbox.CommandError, match="no command"):
        recorder.apply("jump")
    recorder.step(3)
    assert recorder.recording().commands == ()
    assert sandbox.rerun(recorder.recording()).passed


def test_numpy_numbers_in_commands_become_plain_ones() -> None:
    command = plain_command(MoveDrag("crate", tuple(np.array([0.1, 2.0]))))
    assert [type(value) for value in command.target] == [float, float]
    assert json.dumps(encode(command)) == '["MoveDrag", {"body": "crate", "target": [0.1, 2.0]}]'


def test_only_fresh_worlds_of_a_scene_can_be_recorded() -> None:
    used = sandbox.World(scene())
    used.step()
    with pytest.raises(sandbox.RecordingError, match="from its start"):
        sandbox.Recorder(used)
    with pytest.raises(sandbox.RecordingError, match="flat scene"):
        sandbox.Recorder(sandbox.World(scene().flatten()))
    recorder = sandbox.Recorder(sandbox.World(scene()))
    with pytest.raises(sandbox.RecordingError, match="not taken a step"):
        recorder.recording()
    recorder.step()
    recorder.world.step()
    with pytest.raises(sandbox.RecordingError, match="past the recorder after step 1"):
        recorder.recording()


def test_steps_of_commands_must_lie_in_the_run() -> None:
    for step in (-1, 11):
        with pytest.raises(sandbox.RecordingError, match="0 to 10"):
            sandbox.record(scene(), 10, [(step, COMMANDS[0][1])])


def test_a_command_after_the_last_step_counts() -> None:
    push = (20, ApplyImpulse("ball", (1.0, 0.0)))
    with_it, without = sandbox.record(scene(), 20, [push]), sandbox.record(scene(), 20)
    assert with_it.digests == without.digests
    assert with_it.digest != without.digest
    assert sandbox.rerun(with_it).passed
    parted = sandbox.rerun(replace(without, commands=(push,))).divergence
    assert parted is not None
    assert (parted.group, parted.step) == ("rest", 20)


def test_a_step_takes_at_most_30_bytes(tmp_path: Path) -> None:
    sizes = []
    for steps in (60, 660):
        sandbox.record(scene(), steps).save(tmp_path / "a.replay.json")
        sizes.append((tmp_path / "a.replay.json").stat().st_size)
    assert (sizes[1] - sizes[0]) / 600 <= 30


def test_a_line_holds_one_step_one_command_one_checkpoint_or_one_body(
    recorded: sandbox.Recording, tmp_path: Path
) -> None:
    recorded.save(tmp_path / "a.replay.json")
    lines = (tmp_path / "a.replay.json").read_text(encoding="utf-8").splitlines()
    for digest in recorded.digests:
        assert any(line.strip(" ,") == f'"{digest}"' for line in lines)
    assert sum('"MoveDrag", {"body": "crate", "target": [0.3333333333333333, 2.5]}' in line for line in lines) == 1
    assert sum(line.strip().startswith('{"step": ') for line in lines) == 3  # 60, 120 and the last
    assert lines[-2] == f'  "digest": "{recorded.digest}"'


def test_one_other_command_changes_only_lines_from_its_step_on(recorded: sandbox.Recording) -> None:
    other = sandbox.record(scene(), STEPS, [*COMMANDS[:-1], (120, type(COMMANDS[-1][1])((0.5, -9.5)))])
    assert other.digests[:120] == recorded.digests[:120]
    assert other.digests[120] != recorded.digests[120]


def test_checkpoints_are_figures_that_one_can_check() -> None:
    fall = {"id": "ball", "shapes": [{"circle": 0.5, "density": 2}], "position": [0, 1000], "velocity": [3, 0]}
    rows = sandbox.record(sandbox.Scene(bodies=[fall]), 130).checkpoints
    mass = 2 * np.pi * 0.25
    assert [row.step for row in rows] == [60, 120, 130]
    for row in rows:
        assert row.energy == pytest.approx(mass * (9.81 * 1000 + 4.5), rel=1e-5)
        assert (row.contacts, row.awake, row.deepest) == (0, 1, 0.0)


def test_the_last_poses_are_exact(recorded: sandbox.Recording) -> None:
    player = sandbox.Player(recorded)
    player.seek(STEPS)
    x, y, angle = recorded.final["pill"]
    assert player.world.body("pill").position == (x, y)
    assert player.world.body("pill").angle == angle


class TestScene:
    """By path, by content, and what it means."""

    @pytest.fixture
    def folder(self, tmp_path: Path) -> Path:
        scene().save(tmp_path / "a.scene.json")
        return tmp_path

    def test_a_scene_that_has_a_file_goes_in_by_path_and_hash(self, folder: Path) -> None:
        (folder / "goldens").mkdir()
        sandbox.record(folder / "a.scene.json", 5).save(folder / "goldens" / "a.replay.json")
        entry = json.loads((folder / "goldens" / "a.replay.json").read_text())["scene"]
        assert entry["path"] == "../a.scene.json"
        assert "content" not in entry
        assert sandbox.rerun(sandbox.Recording.load(folder / "goldens" / "a.replay.json")).passed

    def test_or_by_content_if_it_is_asked_for(self, folder: Path) -> None:
        sandbox.record(folder / "a.scene.json", 5).save(folder / "a.replay.json", embed=True)
        (folder / "a.scene.json").unlink()
        loaded = sandbox.Recording.load(folder / "a.replay.json")
        assert not loaded.scene.gone
        assert sandbox.rerun(loaded).passed

    def test_a_shipped_scene_goes_in_by_content(self, tmp_path: Path) -> None:
        from sandbox.resources import find_scene

        sandbox.record(find_scene(Path("pyramid-10")), 2).save(tmp_path / "p.replay.json")
        assert "content" in json.loads((tmp_path / "p.replay.json").read_text())["scene"]

    def test_layout_wording_and_colour_do_not_make_it_stale(self, folder: Path) -> None:
        sandbox.record(folder / "a.scene.json", 5).save(folder / "a.replay.json")
        data = json.loads((folder / "a.scene.json").read_text())
        data["title"], data["bodies"][2]["color"] = "Another", "#ff0000"
        data["expect"] = []
        (folder / "a.scene.json").write_text(json.dumps(data))
        assert sandbox.rerun(sandbox.Recording.load(folder / "a.replay.json")).passed

    def test_prefabs_and_materials_mean_what_they_come_to(self) -> None:
        plain = [{"id": "a", "shapes": [{"box": [1, 2], "friction": 0.3}], "position": [0, 1]}]
        made = [{"id": "a", "prefab": "p", "position": [0, 1]}]
        one = sandbox.Scene(bodies=plain)
        two = sandbox.Scene(
            bodies=made,
            prefabs={"p": {"shapes": [{"box": [1, 2]}], "material": "m"}},
            materials={"m": {"friction": 0.3}},
        )
        assert meaning_of(one.flatten()) == meaning_of(two.flatten())

    @pytest.mark.parametrize(
        ("change", "said"),
        [
            ({"materials": {"wood": {"friction": 0.41}}}, ["body crate was edited"]),
            ({"gravity": [0, -9.8]}, ["settings, gravity or regions were edited"]),
            ({"settings": {"substeps": 5}}, ["settings, gravity or regions were edited"]),
            ({"joints": []}, ["joint pin was taken away", "joint motor was taken away"]),
        ],
    )
    def test_what_was_edited_is_named(self, change: dict[str, Any], said: list[str]) -> None:
        then, now = meaning_of(scene().flatten()), meaning_of(scene(**change).flatten())
        assert then.changes(now) == said
        assert then.changes(then) == []

    def test_another_order_of_bodies_is_another_scene(self) -> None:
        bodies = scene().to_data()["bodies"]
        now = meaning_of(scene(bodies=[bodies[0], bodies[2], bodies[1], *bodies[3:]]).flatten())
        assert meaning_of(scene().flatten()).changes(now) == ["the order of the bodies was changed"]


@st.composite
def any_command(draw: st.DrawFn) -> Any:
    """A command of any class that `World.apply` takes, with any values of the right types in its fields."""
    kind = draw(st.sampled_from(sorted(COMMAND_CLASSES)))
    st.register_type_strategy(float, st.floats(allow_nan=False, allow_infinity=False))
    st.register_type_strategy(dict, st.dictionaries(st.text(), st.recursive(_scalars(), lambda s: st.lists(s))))
    return draw(st.from_type(COMMAND_CLASSES[kind]))


def _scalars() -> st.SearchStrategy[Any]:
    return st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False) | st.text()


@given(any_command(), st.integers(0, 1_000_000))
def test_every_command_comes_back_exactly_from_text(command: Any, step: int) -> None:
    text = json.dumps([step, *encode(plain_command(command))], allow_nan=False)
    back, wrong = decode(json.loads(text), ("commands", 0))
    assert wrong == []
    assert back == (step, command)
    assert repr(back) == repr((step, _as_floats(command)))


def _as_floats(command: Any) -> Any:
    """Whole numbers in fields of floats read back as floats."""
    return decode([0, *encode(command)], ())[0][1]  # type: ignore[index]


def test_the_registry_knows_every_command_of_the_engine() -> None:
    package = sandbox.engine.commands
    for info in pkgutil.iter_modules(package.__path__, package.__name__ + "."):
        importlib.import_module(info.name)
    found = {kind for kind in _below(Command) if not inspect.isabstract(kind)}
    assert len(found) >= 21
    assert found == set(COMMAND_CLASSES.values())
    assert [name for name, kind in COMMAND_CLASSES.items() if name != kind.__name__] == []


def _below(kind: type[Any]) -> set[type[Any]]:
    return {kind}.union(*map(_below, kind.__subclasses__()))
