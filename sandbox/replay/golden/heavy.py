"""Heavy mode: every step is taken a second time, by another world that was given a snapshot."""

from __future__ import annotations

from collections.abc import Iterable

from sandbox.replay.golden.run import Stage
from sandbox.replay.recording.command_words import TimedCommand
from sandbox.scene import Scene


class Twin:
    """A second world of the same scene, which knows of the first only what snapshots tell."""

    def __init__(self, scene: Scene, commands: Iterable[TimedCommand]) -> None:
        self._stage = Stage(scene, commands)

    def step_from(self, stage: Stage) -> str:
        """Take the step that comes next for `stage` from a snapshot of it; the digest after that."""
        self._stage.restore(stage.world.snapshot(), stage.applied)
        self._stage.advance()
        return self._stage.world.digest()
