"""A run as data, and the world that takes it step by step."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from sandbox.arguments import check_kind, checked_count
from sandbox.engine.events.event_log import Untold
from sandbox.engine.world import LastStep, World
from sandbox.replay.recording.command_words import TimedCommand
from sandbox.replay.recording.recording import Recording
from sandbox.replay.recording.refusal import telling_refusal
from sandbox.replay.recording.script import checked_script
from sandbox.scene import Scene
from sandbox.scene.duration import planned_steps
from sandbox.scene.flat import FlatScene


@dataclass(frozen=True)
class Run:
    """A scene, the commands with the steps they come after, and how many steps to take."""

    scene: Scene | FlatScene
    steps: int
    commands: tuple[TimedCommand, ...] = ()


def run_of(what: Run | Recording | Scene, call: str = "to play") -> Run:
    """What a recording did, or a scene by itself.

    Raises `SceneError` if the recording's scene cannot be used, and `ArgumentError` for anything else.
    """
    check_kind(call, "a Run, a Recording or a Scene", what, Run, Recording, Scene)
    if isinstance(what, Run):
        check_kind(f"{call}: a Run", "a Scene", what.scene, Scene, FlatScene)
        return Run(what.scene, checked_count(f"{call}: a Run", what.steps), tuple(checked_script(call, what.commands)))
    if isinstance(what, Scene):
        return Run(what, planned_steps(what))
    return Run(what.load_scene(), what.steps, what.commands)


class RunStepper:
    """A world that takes a run; `world` is at `step`, its commands of that step not yet applied."""

    def __init__(self, scene: Scene | FlatScene, commands: Iterable[TimedCommand], workers: int = 1) -> None:
        self.world = World(scene, workers)
        self.commands = list(commands)
        self._applied = 0

    @property
    def step(self) -> int:
        """Steps taken since the start."""
        return self.world.step_count

    def apply_due(self, until: int | None = None) -> None:
        """Apply this step's commands that have not been, up to `until` in all. Raises `RefusedCommandError`."""
        end = len(self.commands) if until is None else until
        while self._applied < end and self.commands[self._applied][0] <= self.step:
            command = self.commands[self._applied][1]
            with telling_refusal(self._applied, command, self.world):
                self.world.apply(command)
            self._applied += 1

    def advance(self) -> None:
        """Apply what is due and take a step. Raises `RefusedCommandError`, and `CapacityError` as `World.step` does."""
        self.apply_due()
        self.world.step()

    def add(self, command: Any) -> None:
        """Apply a command now and know it from now on. Raises what `World.apply` raises."""
        self.world.apply(command)
        self.note(command)

    def note(self, command: Any) -> None:
        """Know a command that the world has just been given."""
        self.commands.insert(self._applied, (self.step, command))
        self._applied += 1

    def take_back(self, snapshot: bytes, applied: int, last_step: LastStep) -> None:
        """Forget all commands but the first `applied`; `snapshot` is the world after these, in this step, which has
        `last_step` to tell.

        Raises `SnapshotError`.
        """
        self.restore(snapshot, applied)
        self.world.recall(last_step)
        self.commands = self.commands[:applied]

    def forget_coming(self) -> None:
        """Forget the commands that have not been applied."""
        self.commands = self.commands[: self._applied]

    def commands_done_at(self, step: int) -> list[TimedCommand]:
        """The commands of `step` that have been applied."""
        return [row for row in self.commands[: self._applied] if row[0] == step]

    def restore(self, snapshot: bytes, applied: int, untold: Untold | None = None) -> None:
        """Go to a snapshot, taken when `applied` commands had been applied, and to what was `untold` then, for the
        events of the next step. Raises `SnapshotError`."""
        self.world.restore(snapshot, untold)
        self._applied = applied

    @property
    def applied(self) -> int:
        """How many commands have been applied."""
        return self._applied
