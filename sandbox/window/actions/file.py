"""Actions on files: saving, pictures, other scenes."""

from __future__ import annotations

from collections.abc import Callable

from sandbox.window.actions.action import Action
from sandbox.window.workspace import Wish, Workspace


def _save_replay(workspace: Workspace) -> None:
    """Write the session into the folder that the program was started in."""
    with workspace.attempt("not saved", OSError):
        path = workspace.session.save_recording(workspace.folder)
        steps = workspace.session.timeline.length
        workspace.say(f"saved {path.name}: {steps:,} steps; run it again with sandbox replay")


def _leave(workspace: Workspace) -> None:
    """Esc: first what the tool is in the middle of, then the help, then the scene."""
    if workspace.help_shown:
        workspace.help_shown = False
    elif not workspace.interrupt():
        workspace.wish = Wish("leave")


def _wish(kind: str) -> Callable[[Workspace], None]:
    def run(workspace: Workspace) -> None:
        workspace.wish = Wish(kind)

    return run


ACTIONS = (
    Action("gallery", "Gallery", "File", ("Ctrl+O",), "Choose another scene.", _wish("gallery")),
    Action("save", "Save as replay", "File", ("S", "Ctrl+S"), "Write all that was done as a recording.", _save_replay),
    Action("leave", "Leave", "File", ("Esc",), "Give up what is begun, else back to the gallery or out.", _leave),
    Action("quit", "Quit", "File", ("Ctrl+Q",), "Close the window.", _wish("quit")),
)  # fmt: skip
