"""Pictures and films of a session: what is written, what is not, and the dialog with real keys and clicks."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import sandbox
from sandbox.cli import main
from sandbox.errors import SandboxError
from sandbox.render.theme import DARK, LIGHT
from sandbox.replay.golden.run import Run
from sandbox.replay.recording.recorder import record
from sandbox.window.app import App
from sandbox.window.export import Wanted, even, write_export
from sandbox.window.job import Cancelled, Job, Progress
from sandbox.window.options import Options
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas, Screen
from tests.window.test_compare import STEPS, WORDS

SCENE = sandbox.Scene(**WORDS)
PUSH = (30, sandbox.SetVelocity("ball", (4.0, 0.0), 0.0))
RUN = Run(SCENE, STEPS, (PUSH,))
WANTED = Wanted(".gif", 20, 50, 40, (160, 100), 25.0, DARK, (0.0, 2.0), 10.0)

LOOK = "--step 70 --size 160x100 --center 0,2 --height 10 --theme light --overlay contacts".split()  # noqa: SIM905


def pixels(path: Path) -> Any:
    with Image.open(path) as image:
        return np.asarray(image.convert("RGB")).astype(int)


def frames(path: Path) -> int:
    """Pictures of 40 ms: one that shows nothing new lengthens the one before."""
    with Image.open(path) as image:
        shown = [image.seek(k) or image.info["duration"] for k in range(image.n_frames)]
    return round(sum(shown) / 40)


def test_a_film_is_as_long_as_its_range(tmp_path: Path) -> None:
    told = write_export(RUN, WANTED, tmp_path / "a.gif", Progress())
    assert told.startswith("a.gif: 13 pictures, ")
    assert frames(tmp_path / "a.gif") == 13  # half a second, both ends


def test_a_picture_is_what_render_draws_of_the_recording(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    record(SCENE, STEPS, (PUSH,)).save("fall.replay.json")
    with pytest.raises(SystemExit) as stop:
        main(["render", "fall.replay.json", "-o", "b.png", *LOOK])
    assert stop.value.code == 0
    wanted = Wanted(".png", 0, 0, 70, (160, 100), 25.0, LIGHT, (0.0, 2.0), 10.0, None, ("contacts",))
    write_export(RUN, wanted, tmp_path / "a.png", Progress())
    assert (pixels(tmp_path / "a.png") == pixels(tmp_path / "b.png")).all()


def test_what_was_done_at_the_last_step_is_in_its_picture(tmp_path: Path) -> None:
    for name, commands in (("with", ()), ("without", ((40, sandbox.Delete("crate")),))):
        wanted = Wanted(".png", 0, 0, 40, (160, 100), 25.0, DARK, (0.0, 2.0), 10.0)
        write_export(Run(SCENE, 40, commands), wanted, tmp_path / f"{name}.png", Progress())
    assert np.abs(pixels(tmp_path / "with.png") - pixels(tmp_path / "without.png")).max() > 50


def test_a_drawing_of_vectors_and_a_video(tmp_path: Path) -> None:
    write_export(RUN, Wanted(".svg", 0, 0, 5, (160, 100), 25.0, DARK, (0.0, 2.0), 10.0), tmp_path / "a.svg", Progress())
    assert (tmp_path / "a.svg").read_text().startswith("<")
    pytest.importorskip("av")
    told = write_export(RUN, WANTED.with_suffix(".mp4"), tmp_path / "a.mp4", Progress())
    assert told.startswith("a.mp4: 31 pictures")


@pytest.mark.parametrize("suffix", [".gif", ".png"])
def test_what_is_cancelled_writes_nothing(tmp_path: Path, suffix: str) -> None:
    def work(progress: Progress) -> str:
        progress.cancelled = True
        return write_export(RUN, WANTED.with_suffix(suffix), tmp_path / f"a{suffix}", progress)

    with pytest.raises(Cancelled):
        Job(work).result()
    assert list(tmp_path.iterdir()) == []


def test_a_film_of_no_step_is_refused(tmp_path: Path) -> None:
    none = Wanted(".gif", 20, 20, 0, (160, 100), 25.0, DARK, (0.0, 2.0), 10.0)
    with pytest.raises(SandboxError, match="a film needs steps"):
        write_export(RUN, none, tmp_path / "a.gif", Progress())
    assert list(tmp_path.iterdir()) == []


def test_sides_are_even_and_possible() -> None:
    assert [even(size) for size in ((641, 400), (1, 9000))] == [(640, 400), (16, 8192)]


class Exporting(App):
    """The program; unless `hasty`, its hands wait until what they have asked for is written."""

    hasty = False
    last: PlayScreen

    def __init__(self, canvas: Canvas, options: Options) -> None:
        super().__init__(canvas, options)
        self.notes: list[str] = []
        self.steps_meanwhile: list[int] = []

    def _act(self, screen: Screen) -> bool:
        waits = isinstance(screen, PlayScreen) and screen.export_box.busy and not self.hasty
        return True if waits else super()._act(screen)

    def _draw(self, screen: Screen) -> None:
        super()._draw(screen)
        if isinstance(screen, PlayScreen):
            self.last = screen
            if screen.note not in self.notes[-1:]:
                self.notes.append(screen.note)
            if screen.export_box.busy:
                self.steps_meanwhile.append(screen.session.timeline.step_count)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "fall.scene.json").write_text(json.dumps({"format": 1, **WORDS}))
    return tmp_path


def visit(canvas: Canvas, folder: Path, script: str, hasty: bool = False) -> Exporting:
    (folder / "hands.txt").write_text(script)
    app = Exporting(canvas, Options(folder / "fall.scene.json", script=folder / "hands.txt"))
    app.hasty = hasty
    app.run()
    return app


@pytest.mark.slow
def test_the_whole_session_is_filmed_while_the_window_goes_on(canvas: Canvas, folder: Path) -> None:
    (folder / "fall.gif").write_text("mine")
    app = visit(canvas, folder, "wait 60\nkey Ctrl+E\nwait 2\nclick export.start\nwait 5\n")
    assert (folder / "fall.gif").read_text() == "mine"
    assert frames(folder / "fall-2.gif") >= 25
    assert any(note.startswith("exported fall-2.gif: ") for note in app.notes)
    assert app.steps_meanwhile[-1] > app.steps_meanwhile[0]


@pytest.mark.slow
def test_the_range_of_the_scrubber_is_filmed(canvas: Canvas, folder: Path) -> None:
    script = (
        "wait 60\nkey Space\nhold Shift\ndrag 120,248 to 240,248\nlet Shift\n"
        "key Ctrl+E\nwait 2\nclick export.start\nwait 3\n"
    )
    app = visit(canvas, folder, script)
    chosen = app.last.workspace.time_marks.chosen
    assert chosen is not None
    assert frames(folder / "fall.gif") == 1 + int((chosen[1] - chosen[0]) * 25 / 60 + 1e-9)


def test_a_picture_in_light_of_the_step_that_is_shown(canvas: Canvas, folder: Path) -> None:
    script = (
        "wait 20\nkey Space\nkey Ctrl+E\nwait 2\nclick export.kind.png\nclick export.theme.light\n"
        "click export.start\nwait 3\n"
    )
    visit(canvas, folder, script)
    picture = pixels(folder / "fall.png")
    assert picture.mean() > 150


@pytest.mark.slow
def test_it_can_be_cancelled(canvas: Canvas, folder: Path) -> None:
    script = (
        "wait 200\nkey Space\nkey Ctrl+E\nwait 2\nclick export.size.1080p\n"
        "click export.start\nwait 2\nclick export.cancel\nwait 2\n"
    )

    class Patient(Exporting):
        def _act(self, screen: Screen) -> bool:
            told = any("cancelled" in note for note in self.notes)
            asked = isinstance(screen, PlayScreen) and screen.export_box.busy and screen.export_box.cancelled
            return True if asked and not told else super()._act(screen)

    (folder / "hands.txt").write_text(script)
    app = Patient(canvas, Options(folder / "fall.scene.json", script=folder / "hands.txt"))
    app.hasty = True
    app.run()
    assert "the export was cancelled: nothing is written" in app.notes
    assert sorted(path.name for path in folder.iterdir()) == ["fall.scene.json", "hands.txt"]


def test_without_the_package_for_videos_none_is_begun(
    canvas: Canvas, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def none() -> Any:
        raise ImportError("No module named 'av'")

    monkeypatch.setattr("sandbox.render.video._av", none)
    visit(canvas, folder, "wait 20\nkey Ctrl+E\nwait 2\nclick export.kind.mp4\nclick export.start\nwait 3\nkey Esc\n")
    assert sorted(path.name for path in folder.iterdir()) == ["fall.scene.json", "hands.txt"]
