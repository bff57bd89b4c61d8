"""Getting a session ready in a thread, so that the window stays alive while kernels are being compiled."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from sandbox.errors import SandboxError
from sandbox.resources import SCENE_SUFFIX
from sandbox.window.leftover import Leftover
from sandbox.window.session import Session
from sandbox.window.threads import start_thread

if TYPE_CHECKING:
    from sandbox.replay.recording.command_words import TimedCommand
    from sandbox.replay.recording.recording import Recording
    from sandbox.scene import Scene


class Loader:
    """Loads a scene file or a recording and warms up the engine; look at `done`, then take `result`."""

    def __init__(
        self,
        path: Path,
        start_step: int = 0,
        workers: int = 1,
        leftover: Leftover | None = None,
        other: Path | None = None,
        values: Mapping[str, Any] = MappingProxyType({}),
    ) -> None:
        """With `leftover`, what is in it is loaded, and not the file at `path`; `other` is a recording beside it.

        `values` are set in the scene, as `load_scene` takes them.
        """
        self.path = path
        self._values = values
        self._other = other
        self._leftover = leftover
        self.start_step = start_step
        self.workers = workers
        self.message = "Reading the scene"
        self._left_out = 0
        self._session: Session | None = None
        self._error: Exception | None = None
        self._thread = start_thread(self._run)

    @property
    def done(self) -> bool:
        """True when `result` can be called without waiting."""
        return not self._thread.is_alive()

    def result(self) -> Session:
        """The session. Raises what went wrong: `FileError` for a bad file, `OSError` for a missing one."""
        self._thread.join()
        if self._error is not None:
            raise self._error
        if self._session is None:
            raise SandboxError(f"{self.path}: loading ended without a result")
        return self._session

    def _run(self) -> None:
        try:
            self._session = self._load()
        except Exception as error:  # handed to the thread that asks for the result
            self._error = error

    def _load(self) -> Session:
        from sandbox.engine.world import World
        from sandbox.replay.recording.recording import Recording

        recording = self._recording()
        scene, script, length = self._read(recording)
        self.message = "Preparing the engine"
        # The first step of a process compiles or loads kernels. It is taken here in a world of its own, so
        # that the first step a person sees does not wait.
        World(scene, self.workers).step()
        session = Session(scene, script, length, self.workers)
        session.recording = recording
        if self._left_out:
            session.trouble = f"not all of the file is carried over: sandbox import lists {self._left_out} remarks"
        session.other = Recording.load(self._other) if self._other is not None else None
        if self.start_step:
            self.message = f"Simulating the first {self.start_step:,} steps"
            session.skip(self.start_step)
        if self._leftover is not None:
            session.recall(self._leftover.script, self._leftover.past, self._leftover.at)
        return session

    def _recording(self) -> Recording | None:
        """What the file is, if it is a recording."""
        from sandbox.replay.recording.known_recording import holds_recording
        from sandbox.replay.recording.recording import Recording

        plays = self._leftover is None and holds_recording(self.path)
        return Recording.load(self.path) if plays else None

    def _read(self, recording: Recording | None) -> tuple[Scene, tuple[TimedCommand, ...], int]:
        """A scene, what a recording did to it, and in how many steps."""
        if self._leftover is not None:
            return self._leftover.scene, self._leftover.commands, self._leftover.steps
        if recording is None and self.path.name.endswith(SCENE_SUFFIX):
            from sandbox.scene import load_scene

            return load_scene(self.path, self._values), (), 0
        if recording is None:
            from sandbox.formats import open_scene  # which knows all formats, and takes its time to be imported

            imported = open_scene(self.path, self._values)
            self._left_out = len(imported.remarks)
            return imported.scene, (), 0
        return recording.load_scene(), recording.commands, recording.steps
