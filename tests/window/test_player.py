"""A scene is played with its own keys, gamepad and mouse; what is saved runs again without hands."""

from __future__ import annotations

from pathlib import Path

import pygame
import pytest

import sandbox
from sandbox.render.camera import Camera
from sandbox.window.controls.control_keys import control_keys
from sandbox.window.controls.inputs import axis_value, read
from sandbox.window.controls.player import Player
from sandbox.window.session import Session
from sandbox.window.viewport import Viewport
from sandbox.window.workspace import Workspace

SCENE = sandbox.Scene(
    gravity=(0.0, 0.0),
    bodies=[
        {"id": "ship", "shapes": [{"circle": 0.5}], "sleep_speed": 0},
        {"id": "rock", "type": "static", "shapes": [{"box": [1, 1]}], "position": [0, 9]},
    ],
    counters={"shots": 0},
    controls=[
        {"id": "go", "title": "Go", "keys": ["right"], "minus": ["left"], "pad": ["left stick x"],
         "hold": [{"force": [10, 0], "of": "ship"}]},
        {"id": "fire", "keys": ["space"], "pad": ["a"], "mouse": ["left"], "press": [{"counter": "shots", "add": 1}]},
    ],
)  # fmt: skip


@pytest.fixture
def player() -> Player:
    viewport = Viewport((0, 0, 800, 600), Camera((0.0, 0.0), 50.0, (800, 600)), touched=True)
    return Player(Workspace(Session(SCENE), viewport, Path()))


def key(code: int, down: bool) -> pygame.event.Event:
    return pygame.event.Event(pygame.KEYDOWN if down else pygame.KEYUP, key=code, unicode="", mod=0)


def steps(player: Player, count: int) -> None:
    for _ in range(count):
        player.play()
        player.workspace.session.step_once()


def speed(player: Player) -> float:
    return float(player.workspace.session.world.body("ship").velocity[0])


def test_keys_hold_a_control_both_ways_and_let_go(player: Player) -> None:
    assert player.wants(key(pygame.K_RIGHT, True))
    steps(player, 10)
    fast = speed(player)
    assert fast > 0.5
    player.wants(key(pygame.K_RIGHT, False))
    player.wants(key(pygame.K_LEFT, True))
    steps(player, 10)
    assert speed(player) == pytest.approx(0.0, abs=1e-9)
    player.wants(key(pygame.K_LEFT, False))
    steps(player, 10)
    assert speed(player) == pytest.approx(0.0, abs=1e-9)
    values = [command.value for _, command in player.workspace.session.timeline.commands]
    assert values == [1.0, -1.0, 0.0]  # only what changes is told


def test_both_ways_at_once_are_none(player: Player) -> None:
    player.wants(key(pygame.K_RIGHT, True))
    player.wants(key(pygame.K_LEFT, True))
    steps(player, 5)
    assert speed(player) == 0.0


def test_a_stick_holds_it_as_far_as_it_is_moved(player: Player) -> None:
    axis = pygame.event.Event(pygame.CONTROLLERAXISMOTION, axis=pygame.CONTROLLER_AXIS_LEFTX, value=-19000)
    assert player.wants(axis)
    steps(player, 10)
    ((_, command),) = player.workspace.session.timeline.commands
    assert command.value == pytest.approx(-0.5, abs=0.05)
    assert speed(player) < -0.2


def test_each_press_counts_once(player: Player) -> None:
    for _ in range(3):
        player.wants(key(pygame.K_SPACE, True))
        steps(player, 4)
        player.wants(key(pygame.K_SPACE, False))
        steps(player, 4)
    button = {"button": 1, "pos": (10, 10)}
    player.wants(pygame.event.Event(pygame.MOUSEBUTTONDOWN, **button))
    steps(player, 2)
    assert player.workspace.session.world.counters == {"shots": 4.0}


def test_other_keys_are_not_the_scenes(player: Player) -> None:
    assert not player.wants(key(pygame.K_UP, True))
    assert not player.wants(pygame.event.Event(pygame.MOUSEBUTTONDOWN, button=3, pos=(1, 1)))
    assert not player.wants(pygame.event.Event(pygame.MOUSEMOTION, pos=(1, 1), rel=(1, 1), buttons=(0, 0, 0)))


def test_all_that_was_played_is_one_act(player: Player) -> None:
    player.wants(key(pygame.K_RIGHT, True))
    steps(player, 5)
    player.wants(key(pygame.K_RIGHT, False))
    steps(player, 5)
    timeline = player.workspace.session.timeline
    assert timeline.undo() == "Play"
    assert (timeline.commands, timeline.undo_label) == ([], None)


def test_the_hint_names_keys_and_titles(player: Player) -> None:
    assert [key.text for key in control_keys(player.controls)] == ["Left / Right: Go", "Space: fire"]


@pytest.mark.parametrize(
    ("raw", "value"), [(0.0, 0.0), (0.1, 0.0), (-0.149, 0.0), (1.0, 1.0), (-1.0, -1.0), (0.575, 0.5), (1.3, 1.0)]
)
def test_axes_have_a_dead_zone(raw: float, value: float) -> None:
    assert axis_value(raw) == value


def test_up_on_a_stick_is_positive() -> None:
    up = pygame.event.Event(pygame.CONTROLLERAXISMOTION, axis=pygame.CONTROLLER_AXIS_LEFTY, value=-32767)
    assert read(up) == (("pad", "left stick y"), 1.0)


@pytest.mark.slow
def test_breakout_is_played_in_the_window_and_replays_headless(display: object, tmp_path: Path) -> None:
    import os
    import subprocess
    import sys

    script = "wait 3\nkey Space\nhold Right for 14\nwait 10\nhold Left for 20\nwait 40\nkey Ctrl+Space\nkey S\nwait 2\n"
    (tmp_path / "hands.txt").write_text(script)
    command = [sys.executable, "-m", "sandbox", "run", "breakout", "--script", "hands.txt"]
    environment = {**os.environ, "SANDBOX_STATE_DIR": str(tmp_path / "state")}
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    recording = sandbox.Recording.load(tmp_path / "breakout.replay.json")
    assert {type(command).__name__ for _, command in recording.commands} == {"Control"}
    assert sandbox.rerun(recording).passed
    assert len([name for name in recording.final if name.startswith("brick")]) < 50
