"""Where the body that a divergence is about was written: file, line and column."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from sandbox._printable import told
from sandbox.errors import SandboxError
from sandbox.replay.golden.divergence import Divergence, Drift
from sandbox.replay.golden.rerun import Outcome
from sandbox.replay.recording.recording import Recording
from sandbox.scene import Scene
from sandbox.scene.excerpt import line_column
from sandbox.scene.finding import path_of
from sandbox.scene.locate import locate


def divergence_location(recording: Recording, outcome: Outcome) -> str:
    """In words, where the body stands by which `outcome` is best explained; "" if there is none, or it has no place.

    See `suspects`.
    """
    if outcome.divergence is None:
        return ""
    bodies = suspects(recording, outcome.divergence, outcome.edits, outcome.drifts)
    return next((text for body in bodies if (text := body_location(recording, body))), "")


def body_location(recording: Recording, body: str) -> str:
    """`body NAME: FILE:LINE:COLUMN` of what made the body of that id; "" where that was no scene in a file."""
    try:
        scene = recording.load_scene()
        if recording.scene.content is not None and recording.source is not None and scene.text is None:
            return _in_recording(recording.source, scene, body)
    except (SandboxError, OSError):
        return ""
    return location_in_scene(scene, body)


def location_in_scene(scene: Scene, body: str) -> str:
    """The same for a scene by itself."""
    pointer = _pointer(scene, body)
    found = scene.locate(pointer) if pointer else None
    return _words(body, scene.source, *found) if found else ""


def suspects(
    recording: Recording, parted: Divergence | None, edits: Sequence[str], drifts: Sequence[Drift]
) -> list[str]:
    """The ids of bodies that explain a divergence, the best explanation first.

    That of the first number that differs, those that were edited, those that ended farthest off.
    """
    first = [parted.detail.body] if parted is not None and parted.detail is not None and parted.detail.body else []
    edited = [name for name in recording.scene.meaning.bodies if f"body {name} was edited" in edits]
    return [*first, *edited, *(drift.body for drift in drifts)]


def _pointer(scene: Scene, body: str) -> str:
    return next((one.pointer for one in scene.flatten().bodies if one.id == body), "")


def _in_recording(file: Path, scene: Scene, body: str) -> str:
    pointer = _pointer(scene, body)
    if not pointer:
        return ""
    text = file.read_text(encoding="utf-8")
    path = ("scene", "content", *path_of(pointer))
    return _words(body, str(file), *line_column(text, locate(text, [path])[path].value_span[0]))


def _words(body: str, file: str, line: int, column: int) -> str:
    return f"body {body}: {posix(file)}:{line}:{column}"


def posix(file: str | Path) -> str:
    """A path as it is told: without detours, and with / on every system."""
    return told(os.path.normpath(file))
