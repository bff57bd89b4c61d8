"""Recordings of worlds in which bodies come and go."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import sandbox
from sandbox import Delete, DeleteJoint, SetRegion, SetThruster, SetVelocity, Spawn
from tests.determinism.processes import other_process
from tests.replay.played import DATA

STEPS = 120
ROCKET: dict[str, Any] = {
    "id": "rocket", "shapes": [{"box": [0.4, 1]}], "position": [8, 3], "thrusters": [{"force": [0, 9]}],
}  # fmt: skip
COMMANDS = (
    (0, Spawn([ROCKET, {"id": "tile", "type": "static", "shapes": [{"box": [2, 1]}], "position": [21, -0.5]}])),
    (10, Delete("crate")),
    (15, SetRegion("air", wind=(0.1, 3.0))),
    (20, Spawn({"id": "crate", "shapes": [{"box": [1, 1]}], "position": [1.0 / 3.0, 4]})),
    (30, Spawn(joints={"id": "rope", "type": "distance", "bodies": ["crate", "rocket"], "anchors": [[0, 3], [8, 4]]})),
    (40, SetThruster("rocket", enabled=False)),
    (50, Delete(["hub", "ground"])),
    (60, SetVelocity("crate", (3.0, 1.0), 2.0)),
    (70, DeleteJoint("rope")),
    (80, SetRegion("air", enabled=False)),
)


def scene() -> sandbox.Scene:
    """The scene of the recordings with a wind."""
    return sandbox.Scene(**{**DATA, "expect": [], "regions": [{"id": "air", "wind": [5, 0], "density": 0.2}]})


def digests() -> list[str]:
    """The digest after each step, with the commands that come before."""
    world, found = sandbox.World(scene()), []
    for step in range(STEPS):
        for at, command in COMMANDS:
            if at == step:
                world.apply(command)
        world.step()
        found.append(world.digest())
    return found


def test_a_recording_of_spawns_runs_again(tmp_path: Path) -> None:
    sandbox.record(scene(), STEPS, COMMANDS).save(tmp_path / "x.replay.json")
    recording = sandbox.Recording.load(tmp_path / "x.replay.json")
    assert recording.commands == COMMANDS
    assert sandbox.rerun(recording).divergence is None


def test_any_step_of_it_can_be_gone_to() -> None:
    straight = digests()
    player = sandbox.Player(sandbox.record(scene(), STEPS, COMMANDS))
    player.seek(STEPS)
    for step in range(STEPS, 0, -7):
        player.seek(step)
        assert player.world.digest() == straight[step - 1]


def test_restoring_at_every_step_changes_nothing() -> None:
    world, fresh = sandbox.World(scene()), sandbox.World(scene())
    for step, digest in enumerate(digests()):
        for at, command in COMMANDS:
            if at == step:
                world.apply(command)
        saved = world.snapshot()
        world.step()
        world.restore(saved)
        fresh.restore(saved)
        assert fresh.snapshot() == saved
        world.step()
        fresh.step()
        assert world.digest() == fresh.digest() == digest


@pytest.mark.slow(seconds=10)
def test_another_process_without_the_compiler_has_the_same_bits() -> None:
    assert other_process("tests.replay.test_rows_that_move", NUMBA_DISABLE_JIT="1", PYTHONHASHSEED="5") == digests()


if __name__ == "__main__":
    print("\n".join(digests()))
