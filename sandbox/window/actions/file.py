"""Actions on files: saving, pictures, other scenes."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from sandbox.render.number_text import counted
from sandbox.resources import SCENE_SUFFIX
from sandbox.window.actions.action import Action
from sandbox.window.session import free_path
from sandbox.window.workspace import Wish, Workspace
from sandbox.world.export.scene_now import scene_of


def _save_replay(workspace: Workspace) -> None:
    """Write the session into the folder that the program was started in."""
    with workspace.attempt("not saved", OSError):
        path = workspace.session.save_recording(workspace.folder)
        steps = workspace.session.timeline.length
        workspace.say(f"saved {path.name}: {counted(steps, 'step')}; run it again with sandbox replay")


def _shoot(workspace: Workspace) -> None:
    path = free_path(workspace.folder, workspace.session.stem, ".png")
    workspace.shots.append(path)


def _open_beside(workspace: Workspace, by: int) -> None:
    """Another scene of the same folder."""
    here = Path(workspace.session.scene.source)
    beside = sorted(here.parent.glob(f"*{SCENE_SUFFIX}")) if workspace.session.scene.text is not None else []
    if here not in beside:
        workspace.say("this scene has no neighbours: it does not come from a folder of scenes")
        return
    workspace.wish = Wish("open", beside[(beside.index(here) + by) % len(beside)])


def _save_scene(workspace: Workspace) -> None:
    """Write the moment as a scene, with the author's own words where they still hold."""
    with workspace.attempt("not saved", OSError):
        found = scene_of(workspace.session.world)
        path = free_path(workspace.folder, workspace.session.stem, SCENE_SUFFIX)
        found.scene.save(path)
        lost = f"; {'; '.join(found.remarks)}" if found.remarks else ""
        workspace.say(f"saved {path.name}: a scene that begins as it is now{lost}")


def _resume(workspace: Workspace) -> None:
    if workspace.last_session is None:
        workspace.say("nothing is known that was done in this scene the last time")
    else:
        workspace.wish = Wish("resume", workspace.last_session)


def _leave(workspace: Workspace) -> None:
    """Esc: first the help, then what the tool is in the middle of, then the selection, then the scene."""
    if workspace.help_shown:
        workspace.help_shown = False
    elif not workspace.interrupt() and not workspace.selection.clear():
        workspace.wish = Wish("leave")


def _wish(kind: str) -> Callable[[Workspace], None]:
    def run(workspace: Workspace) -> None:
        workspace.wish = Wish(kind)

    return run


ACTIONS = (
    Action("gallery", "Gallery", "File", ("Ctrl+O",), "Choose another scene.", _wish("gallery")),
    Action("save", "Save as replay", "File", ("S", "Ctrl+S"), "Write all that was done as a recording.", _save_replay),
    Action("save-scene", "Save as scene", "File", ("Ctrl+Shift+S",), "Write a scene that begins as it is now.",
           _save_scene),
    Action("resume", "Last session", "File", ("Ctrl+Shift+O",),
           "Go on with what was done in this scene the last time, with all its other futures.",
           _resume, enabled=lambda w: w.last_session is not None),
    Action("reload", "Read again", "File", ("F9",), "Read the file again and begin with it.",
           lambda w: setattr(w, "reread", True)),
    Action("keep-time", "Keep the time", "File", (), "A file that is read again goes on from this step.",
           lambda w: setattr(w, "keep_time", not w.keep_time), checked=lambda w: w.keep_time),
    Action("next", "Next scene", "File", ("PageDown",), "The next scene of the same folder.",
           lambda w: _open_beside(w, 1)),
    Action("previous", "Previous scene", "File", ("PageUp",), "The scene before in the same folder.",
           lambda w: _open_beside(w, -1)),
    Action("export", "Export...", "File", ("Ctrl+E",), "A picture or a film of the session: PNG, SVG, GIF, MP4, WebM.",
           lambda w: setattr(w, "export_asked", True)),
    Action("screenshot", "Picture", "File", ("F12",), "Save a picture of the window.", _shoot),
    Action("leave", "Leave", "File", ("Esc",), "Give up what is begun, else unselect, else back or out.", _leave),
    Action("quit", "Quit", "File", ("Ctrl+Q",), "Close the window.", _wish("quit")),
)  # fmt: skip
