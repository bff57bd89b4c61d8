"""The player: wherever it is sent, it gives the bits of a straight run."""

from __future__ import annotations

import pytest

import sandbox
from sandbox import ApplyImpulse, SetPose
from sandbox.replay.golden.run import RunStepper
from sandbox.replay.keyframes import Keyframe, Keyframes
from sandbox.replay.timeline import Timeline
from tests.determinism import busy
from tests.replay.played import COMMANDS, STEPS, recording, scene

BUSY = sandbox.Run(busy.scene(), busy.STEPS, tuple(busy.COMMANDS.items()))
PLAYED = sandbox.Run(scene(), STEPS, COMMANDS)


def straight(run: sandbox.Run) -> list[str]:
    """The digest at each step, its commands not yet applied, of a run without detours."""
    stepper = RunStepper(run.scene, run.commands)
    digests = [stepper.world.digest()]
    for _ in range(run.steps):
        stepper.advance()
        digests.append(stepper.world.digest())
    return digests


@pytest.mark.parametrize(
    "budget", [pytest.param(1, marks=pytest.mark.slow), 60_000, pytest.param(400_000, marks=pytest.mark.slow), 1 << 40]
)
@pytest.mark.parametrize("run", [BUSY, PLAYED], ids=["busy", "played"])
def test_every_step_from_end_to_start_is_that_of_a_straight_run(run: sandbox.Run, budget: int) -> None:
    expected = straight(run)
    player = sandbox.Player(run, budget)
    for step in reversed(range(run.steps + 1)):
        player.seek(step)
        assert player.step_count == step
        assert player.world.digest() == expected[step], step


def test_and_in_any_order() -> None:
    expected = straight(PLAYED)
    player = sandbox.Player(recording(), 100_000)
    for k in range(120):
        step = k * 37 % (STEPS + 1)
        player.seek(step)
        assert player.world.digest() == expected[step], step


def test_the_events_of_a_step_are_those_of_a_straight_run() -> None:
    world, expected = sandbox.World(busy.scene()), []
    for step in range(busy.STEPS):
        busy.digests(world, step, step + 1)
        expected.append(list(world.events))
    assert any(expected)
    player = sandbox.Player(BUSY)
    for step in reversed(range(1, busy.STEPS + 1)):
        player.seek(step)
        assert list(player.world.events) == expected[step - 1], step


EVENTFUL = sandbox.Scene(
    bodies=[
        {"id": "ground", "type": "static", "shapes": [{"box": [20, 1]}], "position": [0, -0.5]},
        {"id": "eye", "type": "static", "shapes": [{"box": [1, 1], "sensor": True}], "position": [6, 0.5]},
        *(
            {"id": name, "shapes": [{"box": [1, 1]}], "position": [x, 0.5]}
            for name, x in (("a", -4), ("b", -2), ("c", 0))
        ),
    ],
    rules=[{"when": {"time": 0.1}, "do": [{"delete": "a"}]}],
)
"""A rule deletes a body after step 6."""


@pytest.mark.parametrize("kind", [sandbox.Player, Timeline])
def test_what_was_done_between_two_steps_is_told_by_the_second_whoever_goes_there(kind) -> None:
    """Contacts of what was deleted end, and what was put into a sensor enters it."""
    world, player, told = sandbox.World(EVENTFUL), kind(EVENTFUL), [[]]
    todo = {4: [sandbox.Delete("b"), SetPose("c", (6.0, 0.5), 0.0)], 8: [SetPose("c", (0.0, 0.5), 0.0)]}
    if kind is sandbox.Player:
        player.seek(0)
        player = player.branch()
    for step in range(10):
        for command in todo.get(step, []):
            world.apply(command)
            player.apply(command)
        world.step()
        player.step()
        told.append(list(world.events))
    assert [[event["event"] for event in told[step]] for step in (5, 7, 9)] == [
        ["end", "enter"],
        ["end"],
        ["leave"],
    ]
    for step in (5, 9, 7, 10, 7, 4, 5, 8, 9):
        player.seek(step)
        assert list(player.world.events) == told[step], step
    world = sandbox.World(EVENTFUL)
    world.step(4)
    for command in todo[4]:
        world.apply(command)
    twin = sandbox.World(EVENTFUL)
    twin.restore(world.snapshot(), world.untold)
    twin.step()
    assert list(twin.events) == told[5]
    with pytest.raises(sandbox.ArgumentError, match="takes as untold what World"):
        twin.restore(world.snapshot(), 3)  # type: ignore[arg-type]


def test_a_branch_tells_what_was_done_before_it_in_the_same_step() -> None:
    player = sandbox.Player(sandbox.Run(EVENTFUL, 4))
    player.seek(4)
    player.apply(sandbox.Delete("b"))
    branch = player.branch()
    branch.step()
    assert [(event["event"], event["b"]) for event in branch.world.events] == [("end", "b")]


def test_keyframes_keep_to_the_budget_and_stand_farther_apart_in_longer_runs() -> None:
    player = sandbox.Player(PLAYED, 200_000)
    spacings = []
    for step in range(0, STEPS, 10):
        player.seek(step)
        assert player._head.frames.size <= 200_000
        spacings.append(player._head.frames.spacing)
    assert spacings == sorted(spacings)
    assert spacings[0] < spacings[-1]
    assert len(player._head.frames) >= 5


def test_a_budget_too_small_for_one_keyframe_keeps_the_first() -> None:
    frames = Keyframes(10)
    for step in range(8):
        if frames.wants(step):
            frames.add(Keyframe(step, 0, bytes(100)))
    assert (len(frames), frames.before(8).step) == (1, 0)


def test_a_branch_goes_its_own_way_and_leaves_the_first_alone() -> None:
    expected = straight(PLAYED)
    player = sandbox.Player(PLAYED)
    player.seek(100)
    other = player.branch()
    assert (other.step_count, other.length) == (100, 100)
    assert other.world.digest() == expected[100]
    other.apply(ApplyImpulse("ball", (5.0, 5.0)))
    other.step(20)
    assert other.world.digest() != expected[120]
    player.seek(120)
    assert player.world.digest() == expected[120]
    again = straight(other.run)
    assert other.run.commands[-1] == (100, ApplyImpulse("ball", (5.0, 5.0)))
    for step in reversed(range(121)):
        other.seek(step)
        assert other.world.digest() == again[step], step
    assert again[:101] == expected[:101]


def test_a_branch_without_another_command_comes_to_the_same() -> None:
    expected = straight(PLAYED)
    player = sandbox.Player(PLAYED)
    player.seek(125)  # the last command comes after 120 steps
    other = player.branch()
    other.step(STEPS - 125)
    assert other.world.digest() == expected[STEPS]


def test_what_a_branch_has_applied_at_its_step_stays() -> None:
    player = sandbox.Player(sandbox.Run(scene(), 0))
    player.step(10)
    player.apply(SetPose("ball", (1.0, 3.0), 0.5))
    other = player.branch()
    assert other.world.digest() == player.world.digest()
    for one in (player, other):
        one.step(10)
    assert other.world.digest() == player.world.digest() == straight(other.run)[20]


def test_commands_are_applied_at_the_end_only() -> None:
    player = sandbox.Player(PLAYED)
    with pytest.raises(sandbox.CommandError, match=r"known up to step 150: branch\(\)"):
        player.apply(COMMANDS[0][1])
    for step, told in (
        (-1, "takes a whole number of steps from 0, not -1"),
        (STEPS + 1, f"is not one of 0 to {STEPS}"),
    ):
        with pytest.raises(ValueError, match=told):
            player.seek(step)
    player.seek(STEPS)
    player.apply(ApplyImpulse("ball", (1.0, 0.0)))
    player.step()
    assert player.length == STEPS + 1
    assert player.world.digest() == straight(player.run)[STEPS + 1]


def test_sleeping_worlds_can_be_sought_too() -> None:
    crate = {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 0.5]}
    ground = {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]}
    run = sandbox.Run(sandbox.Scene(bodies=[ground, crate]), 120, ((100, ApplyImpulse("crate", (0.0, 4.0))),))
    expected = straight(run)
    player = sandbox.Player(run, 30_000)
    player.seek(90)
    assert not player.world.body("crate").awake
    for step in reversed(range(121)):
        player.seek(step)
        assert player.world.digest() == expected[step], step
