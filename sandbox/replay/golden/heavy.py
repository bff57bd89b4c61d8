"""Heavy mode: every step is taken a second time, by another world that was given a snapshot."""

from __future__ import annotations

from collections.abc import Iterable

from sandbox.replay.golden.run import RunStepper
from sandbox.replay.recording.command_words import TimedCommand
from sandbox.scene import Scene


class Twin:
    """A second world of the same scene, which knows of the first only what snapshots tell."""

    def __init__(self, scene: Scene, commands: Iterable[TimedCommand]) -> None:
        self._stepper = RunStepper(scene, commands)

    def step_from(self, stepper: RunStepper) -> str:
        """Take the step that comes next for `stepper` from a snapshot of it; the digest after that."""
        self._stepper.restore(stepper.world.snapshot(), stepper.applied)
        self._stepper.advance()
        return self._stepper.world.digest()
