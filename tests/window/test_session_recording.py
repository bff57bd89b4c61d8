"""A session played by hand is recorded: what S writes runs again headless, to the bit."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pygame
import pytest

import sandbox
from sandbox import ApplyImpulse, EndDrag, StartDrag
from sandbox.cli import main
from sandbox.window.loader import Loader
from sandbox.window.play import PlayScreen
from sandbox.window.session import Session
from tests.window.test_session import SCENE


@pytest.fixture
def scene_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    SCENE.save(tmp_path / "two.scene.json")
    monkeypatch.chdir(tmp_path)
    return tmp_path / "two.scene.json"


def replay_code(*arguments: object) -> Any:
    with pytest.raises(SystemExit) as stop:
        main(["replay", *map(str, arguments)])
    return stop.value.code


def key(code: int, character: str) -> pygame.event.Event:
    return pygame.event.Event(pygame.KEYDOWN, key=code, unicode=character, mod=0)


def drag_the_crate(screen: PlayScreen) -> None:
    """Take it by the mouse, swing it about and throw it."""
    camera = screen.camera
    start = tuple(round(float(v)) for v in camera.to_screen((0.2, 0.6)))
    screen.handle(pygame.event.Event(pygame.MOUSEBUTTONDOWN, button=1, pos=start))
    for k in range(12):
        for _ in range(2):
            screen.update(1 / 60)
        to = (start[0] + 9 * k, start[1] - 5 * k)
        screen.handle(pygame.event.Event(pygame.MOUSEMOTION, pos=to, rel=(9, -5), buttons=(1, 0, 0)))
    screen.handle(pygame.event.Event(pygame.MOUSEBUTTONUP, button=1, pos=to))
    for _ in range(20):
        screen.update(1 / 60)


def test_a_session_played_by_mouse_and_keys_replays_headless_with_exit_0(scene_file: Path, tmp_path: Path) -> None:
    session = Loader(scene_file).result()
    screen = PlayScreen(session, (800, 600), lambda wish, screen: None, lockstep=True)
    screen.handle(key(pygame.K_PERIOD, "."))
    screen.handle(key(pygame.K_SPACE, " "))
    drag_the_crate(screen)
    screen.handle(key(pygame.K_s, "s"))
    assert screen.note.startswith("saved two.replay.json: 45 steps")
    recording = sandbox.Recording.load(tmp_path / "two.replay.json")
    assert recording.digest == session.world.digest()
    assert len(recording.commands) >= 12
    assert replay_code(tmp_path) == 0
    assert replay_code(tmp_path, "--heavy") == 0


def test_restart_begins_a_new_recording(scene_file: Path, tmp_path: Path) -> None:
    screen = PlayScreen(Loader(scene_file).result(), (800, 600), lambda wish, screen: None, lockstep=True)
    drag_the_crate(screen)
    screen.handle(key(pygame.K_r, "r"))
    screen.handle(key(pygame.K_s, "s"))
    assert screen.note == "not saved: the world: has not taken a step yet"
    screen.update(1 / 60)
    screen.handle(key(pygame.K_s, "s"))
    assert sandbox.Recording.load(tmp_path / "two.replay.json").commands == ()


def test_no_file_is_written_over(scene_file: Path, tmp_path: Path) -> None:
    session = Loader(scene_file, start_step=3).result()
    names = [session.save_recording(tmp_path).name for _ in range(3)]
    assert names == ["two.replay.json", "two-2.replay.json", "two-3.replay.json"]
    assert sandbox.Recording.load(tmp_path / names[2]).steps == 3


PUSHES = ((5, StartDrag("crate", (0.0, 0.6))), (9, ApplyImpulse("other", (2.0, 3.0))), (30, EndDrag("crate")))


@pytest.fixture
def recorded(scene_file: Path, tmp_path: Path) -> Path:
    sandbox.record(scene_file, 60, PUSHES).save(tmp_path / "played.replay.json")
    return tmp_path / "played.replay.json"


def test_the_window_plays_a_recording(recorded: Path) -> None:
    session = Loader(recorded, start_step=7).result()
    for _ in range(2):
        while session.world.step_count < 60:
            session.step_once()
        assert session.world.digest() == sandbox.Recording.load(recorded).digest
        session.restart()


def test_a_hand_takes_over_and_that_can_be_saved(recorded: Path, tmp_path: Path) -> None:
    session = Loader(recorded, start_step=12).result()
    assert session.grab(tuple(session.world.body("other").center), 0.1)
    for _ in range(30):
        session.step_once()
    kinds = [(step, type(command).__name__) for step, command in _commands(session, tmp_path)]
    assert kinds == [
        (5, "StartDrag"), (9, "ApplyImpulse"), (12, "StartDrag"), (12, "EndDrag"), (42, "EndDrag"),
    ]  # fmt: skip
    assert replay_code(tmp_path, "-k", "two") == 0


def test_a_command_that_the_edited_scene_refuses_is_told(recorded: Path, tmp_path: Path) -> None:
    sandbox.Scene(bodies=[SCENE.bodies[0].model_dump(exclude_unset=True)]).save(tmp_path / "two.scene.json")
    screen = PlayScreen(Loader(recorded).result(), (800, 600), lambda wish, screen: None, lockstep=True)
    for _ in range(10):
        screen.update(1 / 60)
    assert "no body 'crate'" in screen.note
    assert screen.session.world.step_count == 10


def _commands(session: Session, folder: Path) -> Any:
    return sandbox.Recording.load(session.save_recording(folder)).commands
