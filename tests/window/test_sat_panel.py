"""The inspector of separating axes in the real window, worked by real events."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from sandbox.geometry.sat_table import sat_table
from sandbox.render.theme import DARK
from sandbox.resources import find_scene
from sandbox.window.app import App
from sandbox.window.gl_painter import GlPainter
from sandbox.window.gui import Gui
from sandbox.window.options import Options
from sandbox.window.overlay import Overlay
from sandbox.window.panels.sat import SatPanel
from sandbox.window.play import PlayScreen
from sandbox.window.remembered import Remembered
from sandbox.window.sat.colors import sat_colors
from sandbox.window.sat.drawing import Drawing
from sandbox.window.sat.overlap_curve import axis_angle
from sandbox.window.sat.pen import Pen
from sandbox.window.screen import Canvas, Screen
from sandbox.window.widgets import places
from tests.window.resizing import LARGEST, window_of

PICK = "key Space\nkey F3\nkey K\nclick @7,6\nclick @12,13\n"
"""Pause, close the panel of the world, and click square and triangle with the tool of pairs."""

DRAW_AND_PICK = "key F3\nkey B\ndrag @9,4 to @10,5\nkey F4\nkey K\nclick @9.5,4.5\nclick @7,6\nwait 2\n"


@pytest.fixture
def canvas(display: Any) -> Iterator[Canvas]:
    with window_of(LARGEST):
        gui = Gui(display.driver)
        yield Canvas(display, GlPainter(display.context), gui, DARK)
        gui.close()


class Watched(App):
    """The program, keeping the screen that it showed last and where its widgets were."""

    screen: PlayScreen

    def _draw(self, screen: Screen) -> None:
        super()._draw(screen)
        if isinstance(screen, PlayScreen):
            self.screen = screen
            self.places = dict(places)

    @property
    def panel(self) -> SatPanel:
        panel = self.screen.panels["sat"]
        assert isinstance(panel, SatPanel)
        return panel


def run(canvas: Canvas, folder: Path, scene: str, script: str, first: str = PICK) -> Watched:
    """Let hands work the window of a shipped scene."""
    path = folder / "hands.txt"
    path.write_text(first + script)
    canvas = replace(canvas, remembered=Remembered())
    app = Watched(canvas, Options(scene=find_scene(Path(scene)), script=path))
    app.run()
    return app


def test_two_clicks_pick_a_pair_and_its_table_is_that_of_the_world(canvas: Canvas, tmp_path: Path) -> None:
    app = run(canvas, tmp_path, "test-two", "wait 2\n")
    world = app.screen.session.world
    assert app.screen.workspace.selection.pair == ("square", "triangle")
    seen = app.panel.look(app.screen.workspace)
    assert seen is not None
    a, b = world.body("square").shapes[0], world.body("triangle").shapes[0]
    assert seen.table == sat_table(a, b, all_axes=True)
    assert {f"sat.row.{number}" for number in range(1, 8)} <= app.places.keys()
    assert seen.opinion.asked
    assert seen.opinion.same


def test_a_row_and_its_edge_are_linked_by_the_pointer(canvas: Canvas, tmp_path: Path) -> None:
    app = run(canvas, tmp_path, "test-two", "move sat.row.3\nwait 2\n")
    assert app.panel.focus.pointed == 3
    # The third edge of the square is its left one, from (4, 3) to (4, 10).
    app = run(canvas, tmp_path, "test-two", "move @4,7\nwait 2\n")
    assert (app.panel.focus.pointed, app.panel.focus.lit) == (None, 3)
    seen = app.panel.look(app.screen.workspace)
    assert seen is not None
    row = app.panel.focus.row(seen)
    assert row is not None
    assert (row.owner, row.edge) == ("a", 3)


@pytest.mark.slow
def test_a_gap_ends_the_test_and_a_rewound_pair_is_that_of_its_step(canvas: Canvas, tmp_path: Path) -> None:
    app = run(canvas, tmp_path, "test-one", "key Space\nwait 112\nkey Space\nwait 2\n")
    found = []
    for step in (1, 100, *range(106, 112)):
        app.screen.session.seek(step)
        seen = app.panel.look(app.screen.workspace)
        assert seen is not None
        b = app.screen.session.world.body("triangle").shapes[0]
        assert seen.b == b
        found.append((seen.table.colliding, seen.tested))
    assert found[0] == (False, 2)
    assert found[-1] == (False, 6)  # only now does a later axis part them: they all but touch


def test_a_pair_that_is_taken_back_leaves_the_hint_how_to_pick_one_and_comes_again(
    canvas: Canvas, tmp_path: Path
) -> None:
    app = run(canvas, tmp_path, "test-two", f"{DRAW_AND_PICK}key Ctrl+Z\nwait 2\n", "key Space\nwait 2\n")
    assert app.screen.workspace.selection.pair == ("box-1", "square")
    assert app.panel.look(app.screen.workspace) is None
    assert app.panel.inspector.trouble == ""
    assert "sat.verdict" not in app.places
    app.screen.session.redo()
    assert app.panel.look(app.screen.workspace) is not None


@pytest.mark.parametrize("zoom", [1.0, 0.5, 0.3])
def test_the_outcome_covers_neither_the_arrow_of_the_edge_nor_other_words(
    zoom: float, canvas: Canvas, tmp_path: Path
) -> None:
    app = run(canvas, tmp_path, "test-two", "wait 2\n")
    workspace = app.screen.workspace
    workspace.viewport.zoom(zoom)
    seen = app.panel.look(workspace)
    assert seen is not None
    canvas.gui.begin(LARGEST)
    pen = Pen(workspace, Overlay(canvas.gui))
    drawing = Drawing(pen, seen, sat_colors(DARK), workspace.viewport.camera)
    drawing.edge(seen.deciding)
    drawing.rail(seen.deciding.axis, seen.deciding)
    canvas.gui.end()
    *others, (left, top, right, bottom) = pen.taken
    assert len(others) >= 6
    assert all(right <= x0 or x1 <= left or bottom <= y0 or y1 <= top for x0, y0, x1, y1 in others)


@pytest.mark.parametrize(("x", "y"), [(0.99, 0.0), (-0.99, 0.0), (0.0, 0.99), (0.7, 0.7), (0.99999999, 0.0)])
def test_the_words_of_the_way_out_do_not_lie_on_its_arrow(x: float, y: float, canvas: Canvas, tmp_path: Path) -> None:
    bodies = [
        {"id": "a", "type": "static", "shapes": [{"circle": 0.5}]},
        {"id": "b", "position": [x, y], "shapes": [{"circle": 0.5}]},
    ]
    path = tmp_path / "two.scene.json"
    path.write_text(json.dumps({"bodies": bodies, "view": {"height": 4}}))
    pick = f"key Space\nkey F4\nkey K\nclick @{-x / 2},{-y / 2}\nclick @{x * 1.3},{y * 1.3}\nwait 2\nkey Home\n"
    app = run(canvas, tmp_path, str(path), "wait 2\n", pick)
    workspace = app.screen.workspace
    seen = app.panel.look(workspace)
    assert seen is not None
    canvas.gui.begin(LARGEST)
    pen = Pen(workspace, Overlay(canvas.gui))
    Drawing(pen, seen, sat_colors(DARK), workspace.viewport.camera).way_out()
    canvas.gui.end()
    (x0, y0, x1, y1), (left, top, right, bottom) = pen.taken
    assert right <= x0 or x1 <= left or bottom <= y0 or y1 <= top


@pytest.mark.slow
def test_the_axis_is_turned_in_the_scene_and_clicks_into_place_at_edges(canvas: Canvas, tmp_path: Path) -> None:
    app = run(canvas, tmp_path, "test-two", "click sat.free\nwait 2\ndrag sat.handle to @13,9.55\nwait 2\n")
    free = app.panel.focus.free
    assert free is not None
    seen = app.panel.look(app.screen.workspace)
    assert seen is not None
    assert min(abs(free % 180.0 - axis_angle(row.axis)) for row in seen.table.rows) == 0.0
    before = app.screen.session.world.digest()
    app = run(canvas, tmp_path, "test-two", "drag sat.dial to 1100,760\nwait 2\n")
    assert app.panel.focus.free not in (None, free)
    assert app.screen.session.world.digest() == before  # turning an axis moves no body


@pytest.mark.slow
def test_the_tour_goes_from_the_axes_to_the_contact_points(canvas: Canvas, tmp_path: Path) -> None:
    app = run(
        canvas, tmp_path, "test-two", "click sat.tour.start\nwait 1\n" + "click sat.tour.next\n" * 20 + "wait 1\n"
    )
    seen = app.panel.look(app.screen.workspace)
    assert seen is not None
    steps = app.panel.steps(seen)
    assert app.panel.focus.step == len(steps) - 1
    kinds = [step.kind for step in steps]
    assert kinds == ["axes", *["project"] * 7, "minimum", "orientation", "reference", "cut", "points"]
    app = run(canvas, tmp_path, "test-one", "click sat.tour.start\nclick sat.tour.next\n")
    seen = app.panel.look(app.screen.workspace)
    assert seen is not None
    assert [step.kind for step in app.panel.steps(seen)] == ["axes", "project", "project", "exit"]
    assert "42 to 91" in app.panel.steps(seen)[1].text


@pytest.mark.parametrize(("scene", "verdict"), [("test-one", "apart"), ("test-two", "touches")])
@pytest.mark.slow
def test_a_saved_pair_passes_check(
    canvas: Canvas, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, scene: str, verdict: str
) -> None:
    monkeypatch.chdir(tmp_path)
    app = run(canvas, tmp_path, scene, "click sat.save\nclick sat.save\n")
    assert app.screen.note == f"saved: {scene}-square-triangle-2.scene.json"
    saved = sorted(tmp_path.glob("*.scene.json"))
    assert len(saved) == 2
    assert json.loads(saved[0].read_text())["expect"] == [{"at": 1, verdict: ["square", "triangle"]}]
    checked = subprocess.run(
        [sys.executable, "-m", "sandbox", "check", *map(str, saved)], capture_output=True, text=True
    )
    assert checked.returncode == 0, checked.stdout + checked.stderr


def test_pairs_of_the_grid_can_be_chosen_from_the_list(canvas: Canvas, tmp_path: Path) -> None:
    first = "wait 20\nkey Space\nkey F3\nkey F4\nwait 2\n"
    app = run(canvas, tmp_path, "pyramid-10", "click sat.pair.ground.block-1-2\nwait 1\n", first)
    assert app.screen.workspace.selection.pair == ("ground", "block-1-2")
    seen = app.panel.look(app.screen.workspace)
    assert seen is not None
    assert seen.b == app.screen.session.world.body("block-1-2").shapes[0]


def test_a_closed_panel_is_not_called(canvas: Canvas, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[str] = []
    monkeypatch.setattr(SatPanel, "draw", lambda self, workspace: calls.append("draw"))
    monkeypatch.setattr(SatPanel, "draw_over", lambda self, workspace, overlay: calls.append("over"))
    run(canvas, tmp_path, "test-two", "key F4\nwait 5\n")  # the tool has opened it
    assert calls
    opened = len(calls)
    run(canvas, tmp_path, "test-two", "wait 5\n", first="")
    assert len(calls) == opened
