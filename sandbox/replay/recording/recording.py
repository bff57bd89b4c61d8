"""A recording: a scene, what was done to it, and what came of it."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from sandbox.arguments import check_path
from sandbox.notebook import Shown
from sandbox.replay.recording.read import read_recording
from sandbox.replay.recording.recording_fields import RecordingFields
from sandbox.replay.recording.write import write_recording
from sandbox.scene import Scene


@dataclass(frozen=True)
class Recording(Shown, RecordingFields):
    """What a run did, step for step.

    `commands` are (step, command) in order: the command comes after that many steps. `digests[k]` is the fingerprint
    after step k + 1, `digest` that of the whole state at the end, `final` the pose of each body there. `arithmetic`,
    `version` and `environment` say what it was recorded with, `source` the file it was read from.
    """

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Recording:
        """The recording in a file. Raises `RecordingError` with every mistake and its place, and `ArgumentError`."""
        check_path("Recording.load", path)
        return cls(**vars(read_recording(Path(path))))

    def save(self, path: str | os.PathLike[str], embed: bool | None = None, over: bool = True) -> None:
        """Write the recording as JSON. Its scene goes in by path and hash, with `embed` by content.

        Without `embed` a scene goes in by content if it has no file, comes with the package, or has a file that is not
        JSON by its name, or with a backslash or what cannot be printed on the way to it.
        Without `over`, no file that is there is written over.
        Raises `RecordingError` if it cannot be written so, `OSError` (`FileExistsError` for a file that is there), and
        `ArgumentError`.
        """
        check_path("Recording.save", path)
        write_recording(self, Path(path), embed, over)

    def load_scene(self) -> Scene:
        """The scene as it is now. Raises `SceneError` if its file cannot be used."""
        return self.scene.load()
