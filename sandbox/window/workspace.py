"""What the window knows while a scene is open: all that actions, tools and panels look at and change."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from sandbox._printable import told
from sandbox.errors import SandboxError
from sandbox.render.camera import Vec
from sandbox.render.frame import Frame
from sandbox.render.theme import DARK, Theme
from sandbox.window.comparer import Comparer
from sandbox.window.selection import Selection
from sandbox.window.session import Session
from sandbox.window.steering import Steering
from sandbox.window.time_marks import TimeMarks
from sandbox.window.viewport import Viewport
from sandbox.world.export.copies import Entries

if TYPE_CHECKING:
    from sandbox.engine.commands.base import Command

NOTE_SECONDS = 5.0


@dataclass(frozen=True)
class Wish:
    """What the user wants that leads away from this session: "leave", "quit", "gallery", "open" `path`, "resume" what
    was done the last time and is at `path`, or to go on with another `session` of the same file."""

    kind: str
    path: Path | None = None
    session: Session | None = None


def _nothing() -> bool:
    return False


@dataclass
class Workspace:
    """One open scene.

    `panels` and `overlays` are the names of those that are shown; `interface` False hides all but the scene. `held`
    are the names of actions whose keys are held down. `wish` is taken by the screen at its next update.
    """

    session: Session
    viewport: Viewport
    folder: Path
    theme: Theme = DARK
    selection: Selection = field(default_factory=Selection)
    panels: set[str] = field(default_factory=set)
    front: str = ""
    """The panel that is to be in front of those in its place."""
    behind: set[str] = field(default_factory=set)
    """The panels that are hidden by others in their places."""
    overlays: list[str] = field(default_factory=list)
    color_by: str = "theme"
    """What the colours of bodies mean: a name in `render/coloring`."""
    depth: bool = True
    """Whether what moves casts a soft shadow."""
    interface: bool = True
    help_shown: bool = False
    palette_shown: bool = False
    text_scale: float = 1.0
    less_motion: bool = False
    """Nothing fades or turns."""
    clipboard: Entries | None = None
    """What was copied."""
    pointer: Vec | None = None
    """The point of the plane under the mouse in metres; None where it is over something else."""
    held: set[str] = field(default_factory=set)
    steering: Steering = field(default_factory=Steering)
    """Where the keyboard is, if not in the scene."""
    wish: Wish | None = None
    interrupt: Callable[[], bool] = _nothing
    """Gives up what the tool in hand is in the middle of; False if there is nothing."""
    last_session: Path | None = None
    """What was done in this scene the last time, if it is on disk."""
    reread: bool = False
    """Whether the file is to be read again now."""
    keep_time: bool = False
    """Whether a scene that is read again goes on from the step at which the one before it stood."""
    export_asked: bool = False
    """Whether the dialog for pictures and films is to open."""
    comparer: Comparer | None = None
    """Holds the session against a recording."""
    time_marks: TimeMarks = field(default_factory=TimeMarks)
    """What stands on the scrubber, and the range chosen there."""
    shots: list[Path] = field(default_factory=list)
    """Pictures of the window that are asked for."""
    fps: float = 0.0
    age: float = 0.0
    note: str = ""
    note_until: float = 0.0
    frame: Frame | None = None
    """What the last picture showed."""

    def say(self, text: str) -> None:
        """Tell the user for a while."""
        self.note, self.note_until = text, self.age + NOTE_SECONDS

    def do(self, label: str, *commands: Command) -> bool:
        """Apply commands as one act that can be undone; False, and a note, if one is refused."""
        done = self.session.do(label, *commands)
        if not done:
            self.say_trouble()
        return done

    def toggle_panel(self, name: str) -> None:
        """Show a panel, in front of those in its place; close it if it is there."""
        if name in self.panels and name not in self.behind:
            self.panels.discard(name)
        else:
            self.panels.add(name)
            self.front = name

    def toggle_overlay(self, name: str) -> None:
        """Show an overlay over the others, or no longer."""
        others = [one for one in self.overlays if one != name]
        self.overlays = others if name in self.overlays else [*others, name]

    def say_trouble(self) -> None:
        """Tell what went wrong in the session, if anything did."""
        if self.session.trouble:
            self.say(self.session.trouble)
            self.session.trouble = ""

    def restart(self) -> None:
        """Begin again: with what the file says now if it says something else, or with the same scene."""
        source = Path(self.session.scene.source)
        try:
            changed = (
                self.session.scene.text is not None and source.read_text(encoding="utf-8") != self.session.scene.text
            )
        except (OSError, ValueError):
            changed = False
        if changed:
            self.reread = True
        else:
            self.session.restart()

    def attempt(self, what: str, *errors: type[Exception]) -> Attempt:
        """A context in which `errors`, and those of this package, become a note that begins with `what`."""
        return Attempt(self, what, (SandboxError, *errors))


@dataclass
class Attempt:
    """See `Workspace.attempt`."""

    workspace: Workspace
    what: str
    errors: tuple[type[Exception], ...]

    def __enter__(self) -> None:
        return None

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: object) -> bool:
        if not isinstance(error, self.errors):
            return False
        self.workspace.say(failed(self.what, error))
        return True


def failed(what: str, error: BaseException) -> str:
    """A note on what could not be done, and why."""
    if isinstance(error, OSError) and error.filename is not None:
        return f"{what}: {told(error.filename)}: {error.strerror}"
    return f"{what}: {error}"
