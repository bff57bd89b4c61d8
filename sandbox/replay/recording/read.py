"""From a file to a recording, or to one error with every mistake and its place."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pydantic import ValidationError

from sandbox._bounded_read import is_regular
from sandbox._lent import home_of
from sandbox.errors import Problem, RecordingError, SceneError
from sandbox.replay.recording.checkpoint import Checkpoint
from sandbox.replay.recording.command_words import TimedCommand, decode
from sandbox.replay.recording.file_model import FileModel, SceneEntry
from sandbox.replay.recording.limits import MAX_BYTES
from sandbox.replay.recording.meaning import Meaning
from sandbox.replay.recording.migrate import migrated
from sandbox.replay.recording.recording_fields import RecordingFields, SceneSource
from sandbox.scene import Scene
from sandbox.scene.effort import one_effort
from sandbox.scene.finding import Finding, path_of
from sandbox.scene.finding import Path as Way
from sandbox.scene.known_file import is_scene
from sandbox.scene.limits import MAX_FINDINGS
from sandbox.scene.parse import parse
from sandbox.scene.read import read_text
from sandbox.scene.report import scene_error
from sandbox.scene.wording import findings


def read_recording(path: Path) -> RecordingFields:
    """The recording in a file. Raises `RecordingError`."""
    try:
        text = read_text(path, "recording", MAX_BYTES).removeprefix("\ufeff")
        return loads_recording(text, path)
    except SceneError as error:
        raise RecordingError(error.source, error.problems) from None


@one_effort()
def loads_recording(text: str, path: Path) -> RecordingFields:
    """The recording in a text that stands in the file `path`. Raises `SceneError`."""
    if not text.strip():
        raise SceneError(str(path), [Problem("the file is empty")])
    parsed = parse(text, str(path))
    if not isinstance(parsed.data, dict):
        raise scene_error(str(path), [Finding((), "a recording is an object {...}")], text)
    if is_scene(parsed.data):
        raise SceneError(
            str(path), [Problem("this is a scene, not a recording", hint="sandbox record makes one of it")]
        )
    data, found = migrated(parsed.data)
    if found:
        raise scene_error(str(path), found, text)
    model, found = _validated(data)
    commands: list[TimedCommand] = []
    content = None
    if model is not None:
        found = _cross_checks(model)
        found += decode_all(model.commands, model.steps, commands)
        content, wrong = _content(model.scene)
        found += wrong
    if found or parsed.repeats or model is None:
        raise scene_error(str(path), found + parsed.repeats, text)
    return _recording(model, tuple(commands), content, path)


def _validated(data: dict[str, Any]) -> tuple[FileModel | None, list[Finding]]:
    try:
        return FileModel.model_validate(data), []
    except ValidationError as error:
        return None, findings(error, FileModel)


def _cross_checks(model: FileModel) -> list[Finding]:
    found = []
    if len(model.digests) != model.steps:
        text = f"{len(model.digests)} fingerprints for {model.steps} steps: the file was cut or edited"
        found.append(Finding(("digests",), text))
    if (model.scene.path is None) == (model.scene.content is None):
        found.append(Finding(("scene",), 'a scene has either a "path" or its "content"'))
    order = [entry.step for entry in model.checkpoints]
    if order != sorted(set(order)) or (order and order[-1] > model.steps):
        found.append(Finding(("checkpoints",), "the steps of checkpoints rise, up to the last step"))
    return found


def decode_all(
    entries: tuple[Any, ...], steps: int, commands: list[TimedCommand], home: Way = ("commands",)
) -> list[Finding]:
    """Put all commands into `commands`; findings for those that are none, or stand out of order."""
    found: list[Finding] = []
    last = 0
    for place, entry in enumerate(entries):
        command, wrong = decode(entry, (*home, place))
        found += wrong
        if command is not None:
            commands.append(command)
            if not last <= command[0] <= steps:
                text = f"the steps of commands rise from 0 up to {steps}, and {command[0]} comes after {last}"
                found.append(Finding((*home, place, 0), text))
            last = max(last, command[0])
        if len(found) > MAX_FINDINGS:
            break
    return found


def _content(entry: SceneEntry) -> tuple[Scene | None, list[Finding]]:
    if entry.content is None:
        return None, []
    try:
        return Scene(**entry.content), []
    except SceneError as error:
        # Path and message as the scene would say it, from where the scene stands in this file.
        return None, [Finding(("scene", "content", *path_of(p.pointer)), p.message, p.hint) for p in error.problems]


def _recording(
    model: FileModel, commands: tuple[TimedCommand, ...], content: Scene | None, path: Path
) -> RecordingFields:
    entry = model.scene
    meaning = Meaning(entry.hash, entry.world, entry.bodies, entry.joints)
    place = home_of(path) / entry.path if entry.path is not None else None
    return RecordingFields(
        scene=SceneSource(meaning, place, content, entry.set),
        steps=model.steps,
        step_rate=model.step_rate,
        commands=commands,
        digests=model.digests,
        checkpoints=tuple(Checkpoint(**dict(row)) for row in model.checkpoints),
        final=model.final,
        digest=model.digest,
        arithmetic=model.arithmetic,
        version=model.sandbox,
        environment=model.environment,
        source=path if is_regular(path) else None,  # what a pipe had to say is gone
    )
