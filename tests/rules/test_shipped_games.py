"""The recordings of the shipped games play them: only the player's commands are in them, and this is what they win."""

from __future__ import annotations

import pytest

from sandbox.engine.commands.control import Control
from sandbox.engine.world import World
from sandbox.replay.golden.run import RunStepper
from sandbox.replay.recording.recording import Recording
from tests.shipped import FILES


def played(name: str) -> World:
    """The world at the end of a scene's recording."""
    file = FILES[name]
    recording = Recording.load(file.with_name(f"{name}.replay.json"))
    assert {type(command) for _, command in recording.commands} <= {Control}
    stepper = RunStepper(recording.load_scene(), recording.commands)
    while stepper.step < recording.steps:
        stepper.advance()
    return stepper.world


@pytest.mark.parametrize(
    ("name", "least"),
    [
        ("breakout", {"score": 500, "balls": 3}),
        ("pinball", {"score": 500, "balls": 2, "down": 1}),
        ("pool", {"potted": 8, "strokes": 6}),
        ("lander", {"standing": 4}),
        ("mini-golf", {"strokes": 4}),
        ("air-hockey", {"blue": 2}),
        ("siege", {"stones": 4}),
        ("bowling", {"down": 10, "balls": 2}),
        ("lift", {"lifted": 4}),
        ("marble-clock", {"minutes": 1}),
    ],
)
def test_a_recording_plays_the_game(name: str, least: dict[str, float]):
    world = played(name)
    assert {counter: world.counters[counter] >= value for counter, value in least.items()} == dict.fromkeys(least, True)
    assert world.frozen == []
