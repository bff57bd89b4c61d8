"""Comparing, as a screen does it: begun when a recording is opened, looked after picture by picture."""

from __future__ import annotations

from pathlib import Path

from sandbox.render.frame import Frame
from sandbox.render.marks import Marks
from sandbox.replay.recording.limits import SUFFIX
from sandbox.replay.recording.recording import Recording
from sandbox.window.comparer import Comparer
from sandbox.window.gui_style import palette_of
from sandbox.window.workspace import Workspace

OWNER = "compare"
"""Whose marks they are, and the name of the panel."""
MOST_FILES = 40
NARROW = 900
"""Pixels of the window below which the panel does not open by itself."""


def begin_comparison(workspace: Workspace, other: Recording | None = None, patient: bool = False) -> None:
    """Hold the session's recording against itself, or against `other`; `patient` is for pictures that are counted."""
    end_comparison(workspace)
    recording = workspace.session.recording
    if recording is not None:
        workspace.comparer = Comparer(recording, other, patient)


def open_panel(workspace: Workspace) -> None:
    """Show the panel, unless it would leave little of the scene."""
    if workspace.viewport.rect[2] >= NARROW:
        workspace.panels.add(OWNER)
        workspace.front = OWNER


def end_comparison(workspace: Workspace) -> None:
    """Compare no more."""
    if workspace.comparer is not None:
        workspace.comparer.close()
    workspace.comparer = None
    workspace.time_marks.put(OWNER, ())


def follow_comparison(workspace: Workspace) -> None:
    """Tell what came of it as soon as it is known."""
    comparer = workspace.comparer
    if comparer is not None and comparer.poll():
        workspace.time_marks.put(OWNER, comparer.time_marks())
        workspace.say(comparer.title())


def ghost_over(workspace: Workspace, frame: Frame) -> Marks:
    """The ghost of the expected run over a frame of the session."""
    if workspace.comparer is None:
        return Marks()
    color = palette_of(workspace.theme).second
    return workspace.comparer.marks(workspace.session, frame, workspace.viewport.camera, color)


def compare_with_file(workspace: Workspace, path: Path) -> None:
    """Hold what the window plays against a recording in a file; all that was done counts as what is compared."""
    with workspace.attempt("not compared", OSError):
        other = Recording.load(path)
        if workspace.session.recording is None:
            workspace.session.recording = workspace.session.timeline.recording()
        begin_comparison(workspace, other, workspace.comparer is not None and workspace.comparer.patient)


def recordings_near(workspace: Workspace) -> list[Path]:
    """The recordings in the folder of the scene and in that in which the program was started."""
    recording = workspace.session.recording
    own = recording.source if recording is not None else None
    folders = dict.fromkeys([*([own.parent.resolve()] if own is not None else []), workspace.folder.resolve()])
    found = [path for folder in folders for path in sorted(folder.glob(f"*{SUFFIX}"))]
    return [path for path in found if own is None or path.resolve() != own.resolve()][:MOST_FILES]


def go_to_difference(workspace: Workspace) -> None:
    """Pause at the first step that differs, with the body that differs selected and in the middle."""
    comparer = workspace.comparer
    found = comparer.comparison if comparer is not None else None
    if found is None or found.divergence is None:
        return
    workspace.session.clock.paused = True
    workspace.session.seek(found.divergence.step)
    if found.body is not None:
        show_body(workspace, found.body)


def show_body(workspace: Workspace, name: str) -> None:
    """Select a body and look at it."""
    names = workspace.session.world.names
    if name not in names:
        workspace.say(f"{name} is not there at this step")
        return
    workspace.selection.clear()
    workspace.selection.pick(name)
    x, y = workspace.session.current.center[names.index(name)].tolist()
    workspace.viewport.center_on((x, y))
