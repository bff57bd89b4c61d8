"""A picture in which nothing changes is kept, and looks the same."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import sandbox
from sandbox.render.coloring.registry import COLORINGS
from sandbox.render.draw_list import DrawList
from sandbox.render.theme import DARK
from sandbox.window.actions.registry import BY_NAME
from sandbox.window.gl_painter import GlPainter
from sandbox.window.gui import Gui
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas
from sandbox.window.session import Session
from tests.window.test_session import SCENE


class Counting(GlPainter):
    painted = 0

    def paint(self, picture: DrawList) -> None:
        self.painted += 1
        super().paint(picture)


@pytest.fixture
def canvas(display: Any) -> Iterator[Canvas]:
    gui = Gui(display.driver)
    yield Canvas(display, Counting(display.context), gui, DARK)
    gui.close()


def draw(screen: PlayScreen, canvas: Canvas, path: Path) -> Any:
    screen.update(1 / 60)
    canvas.display.begin()
    canvas.gui.begin(canvas.display.size)
    screen.draw(canvas)
    canvas.gui.end()
    canvas.display.save(path)
    canvas.display.show()
    with Image.open(path) as image:
        return np.asarray(image.convert("RGB")).astype(int)


@pytest.mark.slow
def test_while_nothing_changes_nothing_is_drawn_and_the_picture_stays(canvas: Canvas, tmp_path: Path) -> None:
    screen = PlayScreen(Session(SCENE), canvas.display.size, lambda *_: None)
    screen.session.clock.paused = True
    screen.workspace.less_motion = True
    pictures = [draw(screen, canvas, tmp_path / "a.png") for _ in range(6)]
    assert canvas.painter.painted <= 4  # the panels find their places in the first pictures
    before, first = canvas.painter.painted, pictures[-1]
    for _ in range(5):
        assert np.abs(draw(screen, canvas, tmp_path / "b.png") - first).max() <= 1
    assert canvas.painter.painted == before
    screen.workspace.viewport.zoom(1.5)
    nearer = draw(screen, canvas, tmp_path / "c.png")
    assert canvas.painter.painted == before + 1
    assert np.abs(nearer - first).mean() > 0.3
    kept = [draw(screen, canvas, tmp_path / "d.png") for _ in range(3)][-1]
    assert np.abs(kept - nearer).max() <= 1


@pytest.mark.slow
def test_trails_are_kept_only_while_they_are_shown(canvas: Canvas, tmp_path: Path) -> None:
    screen = PlayScreen(Session(SCENE), canvas.display.size, lambda *_: None, lockstep=True)
    workspace = screen.workspace
    draw(screen, canvas, tmp_path / "a.png")
    assert workspace.session.trails is None
    BY_NAME["trails"].run(workspace)
    for _ in range(20):
        draw(screen, canvas, tmp_path / "a.png")
    trails = workspace.session.trails
    assert trails is not None
    assert workspace.frame is not None
    start, _, rows = trails.lines(workspace.frame, screen.camera)
    assert len(rows) > 0 < start.shape[1]
    workspace.selection.pick(workspace.session.world.names[rows[0]])
    draw(screen, canvas, tmp_path / "a.png")
    assert len(trails.lines(workspace.frame, screen.camera)[2]) == 1
    BY_NAME["trails"].run(workspace)
    draw(screen, canvas, tmp_path / "a.png")
    assert workspace.session.trails is None


def test_the_menu_goes_through_all_ways_to_colour() -> None:
    workspace = PlayScreen(Session(SCENE), (480, 300), lambda *_: None).workspace
    seen = []
    for _ in COLORINGS:
        BY_NAME["color-by-next"].run(workspace)
        seen.append(workspace.color_by)
        assert BY_NAME[f"color-by-{workspace.color_by}"].checked(workspace)
    assert sorted(seen) == sorted(COLORINGS)
    assert workspace.color_by == "theme"


def test_what_changes_is_drawn(canvas: Canvas, tmp_path: Path) -> None:
    screen = PlayScreen(Session(SCENE), canvas.display.size, lambda *_: None)
    workspace = screen.workspace
    screen.session.clock.paused = True
    for _ in range(6):
        draw(screen, canvas, tmp_path / "a.png")
    name = workspace.session.world.names[-1]
    changes = (
        lambda: screen.session.step_once(),
        lambda: workspace.do("Move", sandbox.SetPose(name, (0.0, 3.0), 0.0)),
        lambda: setattr(workspace, "depth", False),
        lambda: setattr(workspace, "color_by", "mass"),
        lambda: setattr(workspace, "color_by", "theme"),
        lambda: workspace.selection.pick(name),
        lambda: workspace.selection.pick(None),
    )
    for change in changes:
        before = canvas.painter.painted
        change()
        draw(screen, canvas, tmp_path / "b.png")
        assert canvas.painter.painted > before
