"""What a recording holds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeAlias

from sandbox._version import __version__
from sandbox.engine.arithmetic_version import ARITHMETIC
from sandbox.errors import Problem, SceneError
from sandbox.replay.recording.checkpoint import Checkpoint
from sandbox.replay.recording.command_words import TimedCommand
from sandbox.replay.recording.environment import environment
from sandbox.replay.recording.meaning import Meaning
from sandbox.scene import Scene, load_scene
from sandbox.scene.known_file import looks_like_a_scene

Pose: TypeAlias = tuple[float, float, float]
"""Position x and y (m) and angle (rad) of a body's origin."""


@dataclass(frozen=True)
class SceneSource:
    """Where a recording's scene is: in a file at `path`, or in `content`; `meaning` is what it came down to then.

    `set` are values that were put into the scene of a file when it was loaded.
    """

    meaning: Meaning
    path: Path | None = None
    content: Scene | None = None
    set: Mapping[str, Any] = field(default_factory=dict)

    @property
    def gone(self) -> bool:
        """Whether the scene's file is not there any more."""
        return self.content is None and self.path is not None and not self.path.is_file()

    def load(self) -> Scene:
        """The scene as it is now. Raises `SceneError`, which shows nothing of a file that is no scene."""
        if self.content is not None:
            return self.content
        assert self.path is not None
        try:
            return load_scene(self.path, self.set)
        except SceneError as error:
            if looks_like_a_scene(self.path):
                raise
            # Others may have written the recording, and read what is told of it.
            problems = [problem for problem in error.problems if not problem.line]
            mend = "look at scene.path in the recording"
            said = problems or [Problem("the recording names this file as its scene, but it is none", hint=mend)]
            raise SceneError(error.source, said) from None


@dataclass(frozen=True)
class RecordingFields:
    """The fields of a recording; `Recording` adds loading and saving.

    `commands` are (step, command) in order: the command comes after that many steps. `digests[k]` is the fingerprint
    after step k + 1, `digest` that of the whole state at the end, `final` the pose of each body there. `arithmetic`,
    `version` and `environment` say what it was recorded with, `source` the file it was read from.
    """

    scene: SceneSource
    steps: int
    step_rate: float
    commands: tuple[TimedCommand, ...]
    digests: tuple[str, ...]
    checkpoints: tuple[Checkpoint, ...]
    final: Mapping[str, Pose]
    digest: str
    arithmetic: int = ARITHMETIC
    version: str = __version__
    environment: str = field(default_factory=environment)
    source: Path | None = None
