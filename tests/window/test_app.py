"""The program from list to scene and back, driven by events as a user's hands would make them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pygame
import pytest
from PIL import Image

from sandbox.render.theme import DARK, LIGHT, Theme
from sandbox.scene.catalog import Entry
from sandbox.window.app import App
from sandbox.window.gallery import Gallery
from sandbox.window.gl_painter import GlPainter
from sandbox.window.gui import Gui
from sandbox.window.loader import Loader
from sandbox.window.loading import LoadingScreen
from sandbox.window.options import Options
from sandbox.window.play import PlayScreen
from sandbox.window.recent import recent_files
from sandbox.window.screen import Canvas, Screen
from sandbox.window.state_folder import state_folder
from tests.window.hands import play
from tests.window.test_session import SCENE

Condition = Callable[[Any], bool]


def key(code: int, character: str = "") -> pygame.event.Event:
    return pygame.event.Event(pygame.KEYDOWN, key=code, unicode=character, mod=0)


def shows(kind: type) -> Condition:
    return lambda screen: isinstance(screen, kind)


class Hands(App):
    """The program, with hands that press the next thing as soon as its condition holds."""

    def __init__(self, canvas: Canvas, options: Options, script: list[tuple[Condition, pygame.event.Event]]) -> None:
        super().__init__(canvas, options)
        self.script = script
        self.seen: list[str] = []
        self.pictures = 0

    def _draw(self, screen: Screen) -> None:
        super()._draw(screen)
        self.pictures += screen.counts
        assert self.pictures < 1500, f"stuck on {self.seen[-1]}"
        name = type(screen).__name__
        if screen.counts and name not in self.seen[-1:]:  # loading may be over before it is ever drawn
            self.seen.append(name)
        if self.script and self.script[0][0](screen):
            pygame.event.post(self.script.pop(0)[1])


@pytest.fixture
def canvas(display: Any) -> Iterator[Canvas]:
    from sandbox.render.theme import DARK

    gui = Gui(display.driver)
    yield Canvas(display, GlPainter(display.context), gui, DARK)
    gui.close()


@pytest.fixture
def scenes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[Entry]:
    SCENE.save(tmp_path / "good.scene.json")
    (tmp_path / "bad.scene.json").write_text('{"format": 1, "bodys": []}')
    entries = [Entry(tmp_path / f"{name}.scene.json", name, "", "a theme") for name in ("bad", "good")]
    monkeypatch.setattr("sandbox.window.app.scene_entries", lambda *folders: entries)
    return entries


def test_from_the_list_to_a_scene_and_back_and_out(canvas: Canvas, scenes: list[Entry]) -> None:
    steps: list[int] = []

    def paused(screen: Any) -> bool:
        if isinstance(screen, PlayScreen) and screen.session.clock.paused:
            steps.append(screen.session.world.step_count)
        return len(steps) >= 4

    script = [
        (shows(Gallery), key(pygame.K_DOWN)),
        (shows(Gallery), key(pygame.K_RIGHT)),
        (shows(Gallery), key(pygame.K_RETURN)),
        (lambda s: isinstance(s, PlayScreen) and s.session.world.step_count > 5, key(pygame.K_SPACE, " ")),
        (paused, key(pygame.K_ESCAPE)),
        (shows(Gallery), key(pygame.K_ESCAPE)),
    ]
    hands = Hands(canvas, Options(), script)
    hands.run()
    assert hands.script == []
    assert hands.seen == ["Gallery", "PlayScreen", "Gallery"]
    assert len(set(steps)) == 1  # nothing moved while paused


def test_a_bad_scene_leads_back_to_the_list_with_a_message(canvas: Canvas, scenes: list[Entry]) -> None:
    messages: list[str] = []

    def told(screen: Any) -> bool:
        messages.append(getattr(screen, "message", ""))
        return bool(messages[-1])

    script = [(shows(Gallery), key(pygame.K_RETURN)), (told, key(pygame.K_ESCAPE))]
    hands = Hands(canvas, Options(), script)
    hands.run()
    assert hands.seen == ["Gallery"]
    assert "bad.scene.json:1:15" in messages[-1]


def test_a_click_on_a_card_opens_it(canvas: Canvas, scenes: list[Entry]) -> None:
    x, y = 200, 190  # inside the first card
    moves = [
        pygame.event.Event(pygame.MOUSEMOTION, pos=(x, y), rel=(1, 1), buttons=(0, 0, 0)),
        pygame.event.Event(pygame.MOUSEBUTTONDOWN, pos=(x, y), button=1),
        pygame.event.Event(pygame.MOUSEBUTTONUP, pos=(x, y), button=1),
    ]
    script: list[tuple[Condition, pygame.event.Event]] = [(shows(Gallery), move) for move in moves]
    script.append((lambda s: isinstance(s, Gallery) and bool(s.message), key(pygame.K_ESCAPE)))
    hands = Hands(canvas, Options(), script)
    hands.run()
    assert hands.script == []


@pytest.mark.parametrize("theme", [DARK, LIGHT])
def test_the_loading_screen_says_what_is_being_done(
    theme: Theme, canvas: Canvas, scenes: list[Entry], tmp_path: Path
) -> None:
    canvas.theme = theme
    loader = Loader(scenes[1].path)
    screen = LoadingScreen(loader, play=lambda session: pytest.fail("not asked"), failed=pytest.fail)
    canvas.display.begin()
    canvas.gui.begin(canvas.display.size)
    screen.draw(canvas)
    canvas.gui.end()
    canvas.display.save(tmp_path / "loading.png")
    with Image.open(tmp_path / "loading.png") as image:
        drawn = np.asarray(image).astype(int)
    apart = np.abs(drawn[..., :3] - 255.0 * np.array(theme.background)).max(axis=2)
    bright = (apart > 80.0).nonzero()
    assert len(bright[0]) > 500  # the arc, what is being done, and the file's name
    assert abs(bright[1].mean() - canvas.display.size[0] / 2) < 20  # centred
    assert loader.result().world.step_count == 0


def test_what_loads_does_not_count_as_a_picture(canvas: Canvas, scenes: list[Entry]) -> None:
    hands = Hands(canvas, Options(scene=scenes[1].path, frames=3), [])
    hands.run()
    assert hands.seen == ["PlayScreen"]
    assert hands.pictures == 3


def test_closing_the_window_ends_the_program(canvas: Canvas, scenes: list[Entry]) -> None:
    hands = Hands(canvas, Options(), [(shows(Gallery), pygame.event.Event(pygame.QUIT))])
    hands.run()
    assert hands.seen == ["Gallery"]


def test_the_panel_in_front_stays_there_in_the_next_scene(canvas: Canvas, tmp_path: Path) -> None:
    SCENE.save(tmp_path / "second.scene.json")
    seen: list[tuple[str, set[str]]] = []

    def look(screen: PlayScreen) -> None:
        seen.append((Path(screen.session.scene.source).name, set(screen.workspace.behind)))

    play(canvas, SCENE, tmp_path, "click panel.world\nwait 4\n", look, "key PageDown\nwait 20\n", look)
    behind = {"inspector", "overlays"}
    assert seen == [("played.scene.json", behind), ("second.scene.json", behind)]


@pytest.mark.parametrize("start", [None, "good.scene.json"])
def test_a_dropped_file_is_opened_and_a_broken_one_told(
    canvas: Canvas, scenes: list[Entry], tmp_path: Path, start: str | None
) -> None:
    folder = scenes[0].path.parent
    SCENE.model_copy(update={"title": "Dropped"}).save(tmp_path / "dropped.scene.json")
    told: list[str] = []

    def drop(name: str) -> pygame.event.Event:
        return pygame.event.Event(pygame.DROPFILE, file=str(folder / name))

    def at_home(screen: Any) -> bool:
        return isinstance(screen, Gallery if start is None else PlayScreen)

    def opened(screen: Any) -> bool:
        return isinstance(screen, PlayScreen) and screen.session.scene.title == "Dropped"

    def refused(screen: Any) -> bool:
        if opened(screen) and screen.refused:
            told.append(screen.refused)
        return bool(told)

    leave = [(refused, key(pygame.K_ESCAPE)), *([(shows(Gallery), key(pygame.K_ESCAPE))] if start is None else [])]
    acts = [(at_home, drop("dropped.scene.json")), (opened, drop("bad.scene.json")), *leave]
    hands = Hands(canvas, Options(folder / start if start is not None else None), acts)
    hands.run()
    assert not hands.script
    assert "bad.scene.json:1:15" in told[0]
    lately = [path.name for path in recent_files(state_folder())]
    assert lately == ["dropped.scene.json", *([start] if start is not None else [])]  # and not what was refused


def test_the_panel_in_front_is_so_again_after_panels_were_hidden(canvas: Canvas, tmp_path: Path) -> None:
    fronts: list[set[str]] = []

    def look(screen: PlayScreen) -> None:
        fronts.append(screen.workspace.panels - screen.workspace.behind)

    opened = "key F7\nkey F5\nwait 4\nclick panel.profile\nclick panel.world\nwait 4\n"
    play(canvas, SCENE, tmp_path, opened, look, "key Tab\nwait 4\nkey Tab\nwait 6\n", look)
    assert fronts == [{"profile", "world"}] * 2
