"""The window lives on while an act waits for machine code: real compiling, in the thread that draws."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import numpy as np
import pygame
import pytest
from PIL import Image

import sandbox
from sandbox import _compiling, _jit
from sandbox._jit import entry_point, jit_enabled
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas
from tests.window.hands import play

pytestmark = pytest.mark.skipif(not jit_enabled(), reason="nothing is compiled without the compiler")
SCENE = sandbox.Scene(
    title="A yard",
    bodies=[
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 0.5]},
    ],
    view={"center": [0, 3], "height": 12},
)


@pytest.fixture
def shown(canvas: Canvas, monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """An entry for each picture that was put on the screen."""
    pictures: list[int] = []
    show = canvas.display.show

    def noted() -> None:
        pictures.append(len(pictures))
        show()

    monkeypatch.setattr(canvas.display, "show", noted)
    return pictures


def fresh() -> Any:
    """An entry point that nobody has compiled."""

    @entry_point
    def poured(rows: Any, limit: int) -> float:
        total = 0.0
        for row in range(limit):
            total += rows[row] * (row % 7)
        return total

    return poured


@pytest.mark.slow
def test_pictures_go_on_while_an_act_waits_for_the_compiler(
    canvas: Canvas, tmp_path: Path, shown: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The thread that compiles looks at the pictures itself: it is not done before there are some."""
    monkeypatch.setenv("SANDBOX_CACHE_DIR", str(tmp_path / "cold"))
    seen: list[int] = []

    def act(screen: PlayScreen) -> None:
        before = len(shown)

        def look(dispatcher: Any, arguments: Any, file: Any) -> None:
            for _ in range(3000):
                if len(shown) >= before + 3:
                    break
                time.sleep(0.01)
            seen.append(len(shown) - before)

        monkeypatch.setattr(_jit, "further", [look])
        assert fresh()(np.ones(8), 8) == 0 + 1 + 2 + 3 + 4 + 5 + 6 + 0

    play(canvas, SCENE, tmp_path, act, "key .\nwait 3\n")
    assert seen[0] >= 3


@pytest.mark.slow
def test_the_box_stands_over_the_scene_and_the_panels_come_back(
    canvas: Canvas, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(canvas.display, "watched", True)  # what stays is kept, and shown again to the last bit
    size = canvas.display.size
    seen: list[Any] = []

    def slow() -> None:
        time.sleep(0.6)

    show = canvas.display.show

    def look() -> None:
        seen.append(canvas.display.picture())
        show()

    def act(screen: PlayScreen) -> None:
        with monkeypatch.context() as patch:
            patch.setattr(canvas.display, "show", look)
            _compiling.patiently(slow)
        screen.workspace.shots.append(tmp_path / "after.png")

    def before(screen: PlayScreen) -> None:
        screen.workspace.shots.append(tmp_path / "before.png")

    play(canvas, SCENE, tmp_path, "wait 2\n", before, "wait 2\n", act, "wait 2\n", size=(800, 600))
    assert canvas.display.size == size
    box = np.asarray(seen[-1]).astype(int)
    first, last = (np.asarray(Image.open(tmp_path / f"{name}.png")).astype(int) for name in ("before", "after"))
    assert np.abs(first - last)[100:].max() == 0  # but for the figures at the top, and the note there
    assert (box[220:396, 200:600].max(axis=2) > 150).sum() > 300  # words
    assert 10 < box[410, 700].mean() < 0.8 * first[410, 700].mean()  # the ground, dimmed


def test_what_is_pressed_meanwhile_begins_nothing_and_what_is_let_go_is_heard(canvas: Canvas, tmp_path: Path) -> None:
    def slow() -> None:
        time.sleep(0.15)
        pygame.event.post(pygame.event.Event(pygame.MOUSEBUTTONDOWN, pos=(5, 5), button=1))
        pygame.event.post(pygame.event.Event(pygame.MOUSEBUTTONUP, pos=(5, 5), button=1))
        time.sleep(0.3)

    def act(screen: PlayScreen) -> None:
        pygame.event.get()
        _compiling.patiently(slow)
        left = [event.type for event in pygame.event.get((pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP))]
        assert left == [pygame.MOUSEBUTTONUP]

    play(canvas, SCENE, tmp_path, act)


def test_a_window_that_is_closed_while_it_waits_closes_and_its_session_is_offered(
    canvas: Canvas, tmp_path: Path
) -> None:
    from sandbox.window.state_folder import state_folder

    def slow() -> None:
        time.sleep(0.15)
        pygame.event.post(pygame.event.Event(pygame.QUIT))
        time.sleep(0.5)

    def never(screen: PlayScreen) -> None:
        pytest.fail("it went on")

    play(canvas, SCENE, tmp_path, "drag @0,0.5 to @2,3\nkey .\n", lambda screen: _compiling.patiently(slow), never)
    (journal,) = state_folder().glob("*.session*")
    assert "ended" not in journal.name
    assert _compiling.patiently is _compiling.at_once


def test_what_goes_wrong_meanwhile_is_raised_where_it_was_asked_for(canvas: Canvas, tmp_path: Path) -> None:
    def broken() -> None:
        time.sleep(0.2)
        raise sandbox.SandboxError("no code for this")

    def act(screen: PlayScreen) -> None:
        with pytest.raises(sandbox.SandboxError, match="no code for this"):
            _compiling.patiently(broken)

    play(canvas, SCENE, tmp_path, act, "wait 2\n")
