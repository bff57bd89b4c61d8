"""A scene being played: timeline, clock, the hand that drags and the last two frames. Knows no window."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sandbox.engine.commands.base import Command
from sandbox.engine.world import World
from sandbox.errors import SandboxError
from sandbox.render.camera import Bounds, Vec
from sandbox.render.frame import Frame, blend, capture, interesting_bounds
from sandbox.render.trails import Trails
from sandbox.replay.moment import Mark, Past
from sandbox.replay.recording.limits import SUFFIX
from sandbox.replay.timeline import Timeline
from sandbox.window.clock import StepClock
from sandbox.window.grip import Grip
from sandbox.window.history import Branches

if TYPE_CHECKING:
    from sandbox.replay.recording.command_words import TimedCommand
    from sandbox.replay.recording.recording import Recording
    from sandbox.scene import Scene

MOST_STEPS = 8
"""Steps a frame at most, however much time has passed."""
FRAME_BUDGET = 0.05
"""Seconds a frame may spend on steps, so that a heavy scene runs slower but stays responsive."""


class Session:
    """One scene from its start. `script` is what a recording did to it, in `length` steps; it is played again."""

    def __init__(self, scene: Scene, script: Sequence[TimedCommand] = (), length: int = 0, workers: int = 1) -> None:
        self.scene = scene
        self.timeline = Timeline(scene, script, length, workers)
        self.grip = Grip(self.timeline)
        self.script = tuple(script)
        """What it began with, and begins with again."""
        self.recording: Recording | None = None
        """What it plays, if it plays a recording."""
        self.other: Recording | None = None
        """Another one, which says what is expected."""
        self.trouble = ""
        """What went wrong last, for the user."""
        self.clock = StepClock(float(self.world.state.settings[0].step_seconds))
        self.step_cost = 0.0
        self.watchers: list[Callable[[], None]] = []
        """Called after each step that is shown; what they keep of it holds until `timeline.cuts` says otherwise."""
        self.trails: Trails | None = None
        """Where bodies were; kept while somebody wants to see it."""
        self._branches = Branches()
        self._blended: Frame | None = None
        self._blended_of = (0, 0, 0.0)
        self.previous = self.current = capture(self.world.state)
        self._between = self.previous, self.current
        self.home = interesting_bounds(self.current)
        """What is worth looking at when the scene begins, in metres."""

    @property
    def world(self) -> World:
        """The world as it is now; change it through `do` or `apply`."""
        return self.timeline.world

    @property
    def touched(self) -> bool:
        """Whether anything has been done in it."""
        past = self.timeline.past
        known = bool(past.undo or past.redo or past.branches)
        return known or len(self.timeline.commands) != len(self.script)

    def recall(self, script: Sequence[TimedCommand], past: Past, step: int) -> None:
        """Be at the step where a session stood that did all that this one has done, began with `script` and knew
        that much.
        """
        self.script = tuple(script)
        self.timeline.recall(past)
        self.seek(step)

    def update(self, elapsed: float) -> int:
        """Let `elapsed` seconds of real time pass; gives the number of steps taken."""
        most = MOST_STEPS if self.step_cost == 0.0 else int(FRAME_BUDGET / self.step_cost)
        steps = self.clock.advance(elapsed, min(max(most, 1), MOST_STEPS))
        for _ in range(steps):
            self._step()
        return steps

    def step_once(self) -> None:
        """Take one step and show it exactly."""
        self._step()
        self.clock.snap_to_step()

    def skip(self, steps: int) -> None:
        """Take many steps unseen."""
        for _ in range(steps):
            self._take()
        self._look_anew()

    def seek(self, step: int) -> None:
        """Go to a step that is known, or to the nearest one."""
        self.grip.let_go()
        self.timeline.seek(min(max(step, 0), self.timeline.length))
        self._look_anew()

    def restart(self) -> None:
        """Begin again from the scene as it was written."""
        self.grip.let_go()
        self.timeline.begin_again(self.script)
        self._look_anew()

    def undo(self) -> str | None:
        """Take back the last act; gives its label."""
        self.grip.let_go()
        label = self.timeline.undo()
        self._look_anew()
        return label

    def redo(self) -> str | None:
        """Bring back what `undo` took; gives its label."""
        self.grip.let_go()
        label = self.timeline.redo()
        self._look_anew()
        return label

    def switch(self, number: int) -> None:
        """Go on with one of the timeline's other futures, from where it parts from this one."""
        self.grip.let_go()
        self.timeline.switch(number)
        self._look_anew()

    def do(self, label: str, *commands: Command) -> bool:
        """Apply commands as one act. False if one is refused: `trouble` says why, and all are taken back."""
        self.timeline.begin_act(label)
        try:
            for done, command in enumerate(commands):  # noqa: B007 - how many were taken is asked for below
                self.timeline.apply(command)
        except SandboxError as error:
            self.trouble = str(error)
            if done:
                self.timeline.undo()
            self.timeline.end_act()
            return False
        finally:
            self._look_anew()
        return True

    def apply(self, command: Command) -> None:
        """Apply a command as part of the act that has begun. Raises what `World.apply` raises."""
        self.timeline.apply(command)
        self._look_anew()

    def adjust(self, mark: Mark, *commands: Command) -> None:
        """Apply commands instead of those since `mark`. Raises what `World.apply` raises."""
        self.timeline.amend(mark, *commands)
        self._look_anew()

    def save_recording(self, folder: Path) -> Path:
        """Write all that is known as the first free of NAME.replay.json, NAME-2.replay.json, ... in `folder`.

        Raises `RecordingError` if there is nothing to write, `OSError` if it cannot be written.
        """
        self.grip.let_go()
        recording = self.timeline.recording()
        path = free_path(folder, self.stem, SUFFIX)
        recording.save(path)
        return path

    @property
    def title(self) -> str:
        """What the scene is called: by itself, or else by its file; "" if it has none."""
        return self.scene.title or (Path(self.scene.source).name if self.scene.text is not None else "")

    @property
    def stem(self) -> str:
        """What files of this session are called."""
        return Path(self.scene.source).name.split(".")[0] if self.scene.text is not None else "scene"

    def frame(self) -> Frame:
        """What is to be seen now: between the last two steps, as far as the clock says. While time stands still it is
        the same object.
        """
        if self.current.mesh.layout != self.world.layout:  # bodies came or went between two steps
            self.previous = self.current = capture(self.world.state)
        of = id(self.previous), id(self.current), self.clock.alpha
        if of != self._blended_of or self._blended is None:
            self._between, self._blended_of = (self.previous, self.current), of  # kept alive, so that ids stay theirs
            self._blended = blend(self.previous, self.current, self.clock.alpha)
        return self._blended

    def bounds(self) -> Bounds:
        """What is worth looking at now, in metres."""
        return interesting_bounds(self.current)

    def grab(self, point: Vec, slack: float) -> bool:
        """Take hold of the dynamic body at `point` (metres); False if there is none within `slack` metres."""
        return self.grip.take(self.frame(), self.current, point, slack)

    def _look_anew(self) -> None:
        """Time has jumped, or something was put elsewhere: show the world as it is, without a blend."""
        parting = self._branches.parting(self.timeline)
        if parting is not None and self.trails is not None:
            self.trails.forget(parting + 1)
        self.previous = self.current = capture(self.world.state, self.current.mesh)

    def _take(self) -> None:
        """Take a step, whatever has to be left out for it."""
        try:
            self.timeline.step()
        except SandboxError as error:
            self.trouble = str(error)
            self.timeline.step()

    def _step(self) -> None:
        self._take()
        cost = self.timeline.cost
        if self.trails is not None:
            self.trails.note(self.world.state)
        self.step_cost = cost if self.step_cost == 0.0 else 0.9 * self.step_cost + 0.1 * cost
        self.previous, self.current = self.current, capture(self.world.state, self.current.mesh)
        for watch in self.watchers:
            watch()


def free_path(folder: Path, stem: str, suffix: str) -> Path:
    """The first of STEM+SUFFIX, STEM-2+SUFFIX, ... in `folder` that does not exist."""
    path, count = folder / (stem + suffix), 1
    while path.exists():
        count += 1
        path = folder / f"{stem}-{count}{suffix}"
    return path
