"""How commands open what they are given: a scene, a file of another program, a recording."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sandbox._printable import told
from sandbox.errors import SandboxError
from sandbox.resources import SCENE_SUFFIX, find_scene

if TYPE_CHECKING:
    from sandbox.replay.recording.recording import Recording
    from sandbox.scene import Scene


def open_any(path: Path, values: Mapping[str, Any] | None = None) -> Scene:
    """The scene in a file, with `values` as `load_scene` takes them. Raises `FileError`.

    Of another program's file what it does not carry over is told on stderr.
    """
    from sandbox.scene import load_scene

    if path.name.endswith(SCENE_SUFFIX):
        return load_scene(path, values)
    from sandbox.cli.import_options import tell
    from sandbox.formats import open_scene

    imported = open_scene(path, values)
    tell(path, imported)
    return imported.scene


def open_or_replay(path: Path, values: Mapping[str, Any]) -> Recording | Scene:
    """The recording in a file, or the scene, with `values`. Raises `FileError`, and `SandboxError` for both at once."""
    from sandbox.replay.recording.known_recording import holds_recording
    from sandbox.replay.recording.recording import Recording

    if not holds_recording(path):
        return open_any(find_scene(path), values)
    no_values(path, values)
    return Recording.load(path)


def no_values(path: Path, values: Mapping[str, Any]) -> None:
    """A recording is of one scene as it was. Raises `SandboxError` if values were given for it."""
    if values:
        raise SandboxError(f"{told(path)} is a recording, which brings its scene: --set is for scenes")
