"""From a recording to text: one line for each step, command, checkpoint and body, so that a diff is readable."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

from sandbox._atomic_write import utf8, write_text
from sandbox._printable import printable
from sandbox.errors import Problem, RecordingError
from sandbox.replay.recording.command_words import encode
from sandbox.replay.recording.file_model import is_way
from sandbox.replay.recording.limits import MAX_BYTES, MAX_COMMANDS, MAX_STEPS
from sandbox.replay.recording.migrate import FORMAT
from sandbox.replay.recording.recording_fields import RecordingFields, SceneSource
from sandbox.resources import scenes_dir
from sandbox.scene.pretty import kinds_first

_WIDTH = 100


def write_recording(recording: RecordingFields, path: Path, embed: bool | None, over: bool = True) -> None:
    """Write `recording` to `path`, also `over` a file that is there.

    Raises `RecordingError`, or `OSError` if the file cannot be written.
    """
    if not 1 <= recording.steps <= MAX_STEPS or len(recording.commands) > MAX_COMMANDS:
        limits = f"a recording has 1 to {MAX_STEPS:,} steps and at most {MAX_COMMANDS:,} commands"
        raise RecordingError(str(path), [Problem(f"{limits}; this one has {recording.steps:,}")])
    text = recording_text(recording, path, embed)
    if len(utf8(text)) > MAX_BYTES:
        raise RecordingError(str(path), [Problem(f"a recording has at most {MAX_BYTES // 2**20} MiB")])
    write_text(path, text, over)


def recording_text(recording: RecordingFields, path: Path, embed: bool | None = None) -> str:
    """The text of the file that is to stand at `path`."""
    return "{\n" + ",\n".join(_members(recording, path, embed)) + "\n}\n"


def _members(recording: RecordingFields, path: Path, embed: bool | None) -> Iterator[str]:
    yield _member("format", _json(FORMAT))
    yield _member("sandbox", _json(recording.version))
    yield _member("arithmetic", _json(recording.arithmetic))
    yield _member("environment", _json(recording.environment))
    yield _member("scene", _scene(recording.scene, path, embed))
    yield _member("steps", _json(recording.steps))
    yield _member("step_rate", _json(recording.step_rate))
    yield _member("commands", _lines("[]", (_json([step, *encode(command)]) for step, command in recording.commands)))
    yield _member("checkpoints", _lines("[]", (_json(asdict(row)) for row in recording.checkpoints)))
    yield _member("digests", _lines("[]", (f'"{digest}"' for digest in recording.digests)))
    poses = (f"{_json(name)}: {_json(list(pose))}" for name, pose in recording.final.items())
    yield _member("final", _lines("{}", poses))
    yield _member("digest", _json(recording.digest))


def _scene(scene: SceneSource, path: Path, embed: bool | None) -> str:
    members = []
    way = None if embed else _way(scene, path, embed)
    if way is not None:
        members.append(f'"path": {_json(way)}')
        members += [f'"set": {_json(dict(scene.set))}'] if scene.set else []
    elif scene.content is None and scene.path is None:
        raise RecordingError(str(path), [Problem("the recording has no scene")])
    meaning = scene.meaning
    members += [f'"hash": "{meaning.whole}"', f'"world": "{meaning.world}"']
    members.append(f'"bodies": {_filled(meaning.bodies.items())}')
    members += [f'"joints": {_filled(meaning.joints.items())}'] if meaning.joints else []
    if way is None:
        entries = kinds_first({"format": 1, **scene.load().to_data()}).items()
        members.append(f'"content": {{{_deep(entries)}\n    }}')
    return "{" + ",".join(f"\n    {member}" for member in members) + "\n  }"


def _way(scene: SceneSource, path: Path, embed: bool | None) -> str | None:
    """The way from the recording's folder to the scene's file; None if the scene is to be in the recording.

    There it is where it has to be, too: where the way cannot be said so that every system understands it.
    """
    if scene.path is None:
        return None
    here, there = path.parent.resolve(), scene.path.resolve()
    shipped = scenes_dir().resolve()
    if embed is None and there.is_relative_to(shipped) and not here.is_relative_to(shipped):
        return None
    try:
        way = Path(os.path.relpath(there, here)).as_posix()
    except ValueError:  # on another drive
        return None
    if is_way(way):
        return way
    if embed is None:
        return None
    text = f"the way to its scene, {printable(way)}, cannot stand in a recording: rename that file, or embed it"
    raise RecordingError(str(path), [Problem(text)])


def _deep(entries: Iterable[tuple[str, Any]]) -> str:
    """Members of the scene: lists of objects have a line for each."""
    return ",".join(f"\n      {_json(key)}: {_listed(value)}" for key, value in entries)


def _listed(value: Any) -> str:
    if not isinstance(value, list) or not value or not isinstance(value[0], dict):
        return _json(value)
    return "[" + ",".join(f"\n        {_json(entry)}" for entry in value) + "\n      ]"


def _filled(pairs: Iterable[tuple[str, str]]) -> str:
    """An object with as many members a line as fit."""
    rows, used = [[]], 0  # type: list[list[str]], int
    for key, value in pairs:
        member = f'{_json(key)}: "{value}"'
        if rows[-1] and used + len(member) > _WIDTH:
            rows.append([])
            used = 0
        rows[-1].append(member)
        used += len(member) + 2
    return "{" + ",".join("\n      " + ", ".join(row) for row in rows if row) + "\n    }"


def _member(key: str, text: str) -> str:
    return f"  {_json(key)}: {text}"


def _lines(brackets: str, entries: Iterable[str]) -> str:
    lines = ",".join(f"\n    {entry}" for entry in entries)
    return f"{brackets[0]}{lines}\n  {brackets[1]}" if lines else brackets


def _json(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)
