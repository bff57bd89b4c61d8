"""The replay viewer, with real keys and clicks: recordings that hold, that do not, and two beside each other."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import sandbox
from sandbox.render.theme import DARK
from sandbox.replay.comparison import Comparison
from sandbox.replay.recording.recorder import record
from sandbox.window.app import App
from sandbox.window.compare import recordings_near
from sandbox.window.comparer import Comparer
from sandbox.window.options import Options
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas, Screen
from sandbox.window.workspace import Workspace

STEPS = 90
WORDS = {
    "title": "A fall",
    "bodies": [
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 2]},
        {"id": "ball", "shapes": [{"circle": 0.5}], "position": [3, 4]},
    ],
}


class Watched(App):
    """The program; its hands wait until a comparison is there. `seen` tells what the pictures showed."""

    last: Workspace
    comparer: Comparer
    comparison: Comparison

    def __init__(self, canvas: Canvas, options: Options) -> None:
        super().__init__(canvas, options)
        self.seen: list[tuple[int, tuple[str, ...], int]] = []
        self.flags: list[int] = []

    def _act(self, screen: Screen) -> bool:
        if isinstance(screen, PlayScreen):
            comparer = screen.workspace.comparer
            if comparer is not None and comparer.comparison is None and not comparer.trouble:
                return True
        return super()._act(screen)

    def _draw(self, screen: Screen) -> None:
        super()._draw(screen)
        if isinstance(screen, PlayScreen):
            self.last = workspace = screen.workspace
            assert workspace.frame is not None
            marks = 0
            if workspace.comparer is not None:
                self.comparer = workspace.comparer
                marks = len(self.comparer.marks(screen.session, workspace.frame, screen.camera, DARK.drag).strokes)
                self.flags = [mark.step for mark in workspace.time_marks.all()]
                if self.comparer.comparison is not None:
                    self.comparison = self.comparer.comparison
            self.seen.append((screen.session.timeline.step_count, workspace.selection.bodies, marks))


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where the program is started: a scene, a recording of it, and one in which the ball is pushed."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "fall.scene.json").write_text(json.dumps({"format": 1, **WORDS}))
    scene = sandbox.load_scene(tmp_path / "fall.scene.json")
    record(scene, STEPS).save(tmp_path / "fall.replay.json")
    push = sandbox.SetVelocity("ball", (4.0, 0.0), 0.0)
    record(scene, STEPS, ((30, push),)).save(tmp_path / "pushed.replay.json")
    return tmp_path


def watch(canvas: Canvas, folder: Path, script: str, name: str, other: str | None = None) -> Watched:
    (folder / "hands.txt").write_text(script)
    beside = folder / other if other is not None else None
    app = Watched(canvas, Options(folder / name, script=folder / "hands.txt", other=beside))
    app.run()
    return app


def test_a_recording_that_holds_is_told_so_and_casts_no_ghost(canvas: Canvas, folder: Path) -> None:
    app = watch(canvas, folder, "key Space\nwait 3\nkey F11\nwait 3\nkey End\nwait 20\n", "fall.replay.json")
    assert app.comparer.title() == f"as recorded, to the bit, in all {STEPS} steps"
    assert app.flags == []
    assert {strokes for _, _, strokes in app.seen} == {0}


def test_each_recording_of_the_folder_is_offered_once(canvas: Canvas, folder: Path) -> None:
    """Also where its path was given as one from the folder in which the program was started."""
    app = watch(canvas, Path(), "key Space\nwait 2\n", "fall.replay.json")
    assert [path.name for path in recordings_near(app.last)] == ["pushed.replay.json"]


def test_of_a_tampered_recording_the_step_is_marked_and_gone_to(canvas: Canvas, folder: Path) -> None:
    data = json.loads((folder / "fall.replay.json").read_text())
    data["digests"][41] = "0000 " + data["digests"][41][5:]
    (folder / "fall.replay.json").write_text(json.dumps(data))
    app = watch(canvas, folder, "key F11\nwait 3\nclick compare.go\nwait 3\n", "fall.replay.json")
    assert app.flags == [42]
    assert app.seen[-1][0] == 42
    assert app.last.session.clock.paused


def test_of_an_edited_scene_the_body_is_selected_and_the_recorded_end_is_outlined(canvas: Canvas, folder: Path) -> None:
    text = (folder / "fall.scene.json").read_text()
    (folder / "fall.scene.json").write_text(text.replace('"position": [3, 4]', '"position": [3.4, 4]'))
    app = watch(canvas, folder, "key F11\nwait 3\nclick compare.go\nwait 3\nkey End\nwait 3\n", "fall.replay.json")
    assert app.comparison.edits == ("body ball was edited",)
    assert app.flags == [1]
    assert (1, ("ball",), 0) in app.seen
    step, _, strokes = app.seen[-1]
    assert step == STEPS
    assert strokes > 10


def test_of_two_recordings_the_second_is_the_ghost(canvas: Canvas, folder: Path) -> None:
    script = "key F11\nwait 3\nclick compare.go\nwait 3\nkey End\nwait 3\n"
    app = watch(canvas, folder, script, "pushed.replay.json", "fall.replay.json")
    assert app.flags == [31]
    assert any(step == 31 and bodies == ("ball",) for step, bodies, _ in app.seen)
    assert app.last.selection.bodies == ("ball",)
    ghost = app.comparer.ghost
    assert ghost is not None
    assert ghost.at(STEPS) is not None
    assert app.seen[-1][0] == STEPS
    assert app.seen[-1][2] > 10


def test_another_recording_of_the_folder_is_chosen_by_a_click(canvas: Canvas, folder: Path) -> None:
    script = "key F11\nwait 3\nwheel -30 compare.verdict\nwait 3\nclick compare.with.pushed.replay.json\nwait 5\n"
    app = watch(canvas, folder, script, "fall.replay.json")
    assert app.comparer.title().startswith("not as in pushed.replay.json from step 31 on")


def test_what_the_user_does_is_told_from_what_the_recording_did(canvas: Canvas, folder: Path) -> None:
    app = watch(canvas, folder, "wait 5\nkey Space\nkey Delete\nkey Ctrl+A\nkey Delete\nwait 3\n", "fall.replay.json")
    own = app.comparer.own_acts_from(app.last.session)
    assert own is not None
    assert own == app.last.session.timeline.commands[0][0]
    assert app.seen[-1][2] > 10  # what is no more is outlined


@pytest.mark.slow
def test_the_scene_edited_meanwhile_is_compared_anew(canvas: Canvas, folder: Path) -> None:
    class Editing(Watched):
        def _act(self, screen: Screen) -> bool:
            if isinstance(screen, PlayScreen) and len(self.seen) == 5:
                text = (folder / "fall.scene.json").read_text()
                (folder / "fall.scene.json").write_text(text.replace('"position": [3, 4]', '"position": [3.4, 4]'))
            return super()._act(screen)

    (folder / "hands.txt").write_text("wait 20\nkey F9\nwait 200\n")
    app = Editing(canvas, Options(folder / "fall.replay.json", script=folder / "hands.txt"))
    app.run()
    assert app.comparison.edits == ("body ball was edited",)


def test_a_range_is_chosen_with_shift_and_dropped_by_a_click(canvas: Canvas, folder: Path) -> None:
    class Choosing(Watched):
        chosen: list[Any]

        def _draw(self, screen: Screen) -> None:
            super()._draw(screen)
            if isinstance(screen, PlayScreen):
                self.chosen.append(screen.workspace.time_marks.chosen)

    script = (
        "key Space\nwait 3\nhold Shift\ndrag 130,248 to 370,248\nlet Shift\nwait 3\nhold Shift\nclick 50,248\n"
        "let Shift\nwait 2\n"
    )
    (folder / "hands.txt").write_text(script)
    app = Choosing(canvas, Options(folder / "fall.replay.json", script=folder / "hands.txt"))
    app.chosen = []
    app.run()
    ranges = [chosen for chosen in app.chosen if chosen is not None]
    first, last = ranges[-1]
    assert 20 <= first <= 28
    assert 65 <= last <= 72
    assert app.chosen[-1] is None
    assert len({step for step, _, _ in app.seen[-20:]}) == 1  # time stays where it is
