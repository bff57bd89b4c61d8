"""What a session does to its world, always recorded from the start; it may begin with what a recording did."""

from __future__ import annotations

import time
from collections.abc import Sequence
from pathlib import Path

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.drags import EndDrag
from sandbox.engine.world import World
from sandbox.errors import SandboxError
from sandbox.replay.recording.command_words import TimedCommand
from sandbox.replay.recording.limits import MAX_STEPS, SUFFIX
from sandbox.replay.recording.recorder import Recorder


class SessionRecorder:
    """Stands between a session and its fresh `world`.

    The commands of `script` are applied as their steps come, until a hand's first command takes over.
    """

    def __init__(self, world: World, script: Sequence[TimedCommand] = ()) -> None:
        self.world = world
        self._recorder = Recorder(world)
        self._script = list(script)

    def apply(self, command: Command) -> None:
        """Apply a command of the user's. Raises what `World.apply` raises."""
        if self._script:
            self._script.clear()
            self._let_go()
        self._recorder.apply(command)

    def step(self) -> float:
        """Take a step; the seconds it took, without those of recording it. Raises what a scripted command raises."""
        while self._script and self._script[0][0] <= self.world.step_count:
            try:
                self._recorder.apply(self._script.pop(0)[1])
            except SandboxError:
                self._script.clear()
                raise
        begin = time.perf_counter()
        self.world.step()
        cost = time.perf_counter() - begin
        if self.world.step_count <= MAX_STEPS:
            self._recorder.note_step()
        return cost

    def save(self, folder: Path) -> Path:
        """Write all that was done so far as the first free of NAME.replay.json, NAME-2.replay.json, ... in `folder`.

        Raises `RecordingError` before the first step and after the millionth, `OSError` if it cannot be written.
        """
        recording = self._recorder.recording()
        source = Path(self._recorder.scene.source)
        stem = source.name.split(".")[0] if self._recorder.scene.text is not None else "scene"
        path, count = folder / (stem + SUFFIX), 1
        while path.exists():
            count += 1
            path = folder / f"{stem}-{count}{SUFFIX}"
        recording.save(path)
        return path

    def _let_go(self) -> None:
        """End the drags that the script has begun and now will not end."""
        for body in [int(row.body) for row in self.world.state.drags if row.body >= 0]:
            self._recorder.apply(EndDrag(self.world.names[body]))
