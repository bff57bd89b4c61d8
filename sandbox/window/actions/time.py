"""Actions on time: pause, steps, speed, rewinding."""

from __future__ import annotations

from sandbox.window.actions.action import Action
from sandbox.window.workspace import Workspace

REWIND_STEPS = 2
"""Steps a picture while the key is held."""


def _pause(workspace: Workspace) -> None:
    clock = workspace.session.clock
    clock.paused = not clock.paused


def _step(workspace: Workspace) -> None:
    workspace.session.clock.paused = True
    workspace.session.step_once()


def _go(workspace: Workspace, by: int) -> None:
    workspace.session.clock.paused = True
    workspace.session.seek(workspace.session.timeline.step_count + by)


def _to_end(workspace: Workspace) -> None:
    workspace.session.seek(workspace.session.timeline.length)


def _other_future(workspace: Workspace) -> None:
    """The one that was left first, so that whoever asks again and again sees all of them."""
    if not workspace.session.timeline.branches:
        workspace.say("there is no other future: one begins with what you do at an earlier moment")
        return
    workspace.session.clock.paused = True
    branch = workspace.session.timeline.branches[0]
    workspace.session.switch(0)
    workspace.say(f"another future, known up to step {branch.length:,}: {branch.label or 'nothing done'}")


def _known_before(workspace: Workspace) -> bool:
    return workspace.session.timeline.step_count > 0


def _known_after(workspace: Workspace) -> bool:
    return workspace.session.timeline.step_count < workspace.session.timeline.length


ACTIONS = (
    Action("pause", "Pause", "Time", ("Space", "Ctrl+Space"), "Stop time, or let it run.", _pause,
           checked=lambda w: w.session.clock.paused),
    Action("step", "One step", "Time", (".",), "Pause, and take one step.", _step),
    Action("step-back", "One step back", "Time", (",",), "Pause, and go back one step.", lambda w: _go(w, -1),
           enabled=_known_before),
    Action("rewind", "Rewind", "Time", ("Left", "Backspace"), "Hold to go back in time.",
           lambda w: _go(w, -REWIND_STEPS), held=True, enabled=_known_before),
    Action("forward", "Forward", "Time", ("Right",), "Hold to go forward through what is known.",
           lambda w: _go(w, REWIND_STEPS), held=True, enabled=_known_after),
    Action("start", "To the start", "Time", ("Home",), "Go to step 0; what is known stays.",
           lambda w: w.session.seek(0), enabled=_known_before),
    Action("end", "To the end", "Time", ("End",), "Go to the last step that is known.", _to_end,
           enabled=_known_after),
    Action("slower", "Slower", "Time", ("-",), "Half as fast, down to 1/64.",
           lambda w: w.session.clock.change_speed(-1)),
    Action("faster", "Faster", "Time", ("+", "="), "Twice as fast, up to 4.",
           lambda w: w.session.clock.change_speed(1)),
    Action("other-future", "Other future", "Time", ("Ctrl+B",),
           "Go to where the next of the futures that you left parts from this one.", _other_future,
           enabled=lambda w: bool(w.session.timeline.branches)),
    Action("restart", "Restart", "Time", ("R",), "Begin again, with what the file says now.", lambda w: w.restart()),
)  # fmt: skip
