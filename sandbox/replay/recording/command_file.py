"""A file of commands: a JSON list of `[step, "NAME", {...}]`, or a recording, whose commands are taken."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from sandbox.errors import Problem, RecordingError, RefusedCommandError, SceneError
from sandbox.replay.recording.command_words import TimedCommand
from sandbox.replay.recording.limits import MAX_BYTES, MAX_STEPS
from sandbox.replay.recording.read import decode_all, loads_recording
from sandbox.scene.effort import one_effort
from sandbox.scene.finding import Finding
from sandbox.scene.finding import Path as Way
from sandbox.scene.parse import parse
from sandbox.scene.read import read_text
from sandbox.scene.report import scene_error

_OF_RECORDINGS: Way = ("commands",)


@dataclass(frozen=True)
class CommandFile:
    """The `commands` in a file, whose `text` has the list of them at `home`."""

    path: Path
    text: str
    commands: tuple[TimedCommand, ...]
    home: Way

    def refused(self, error: RefusedCommandError) -> RecordingError:
        """The error for a command that a world refused, with its line."""
        return _located(self.path, self.text, self.home, error)


def read_commands(path: Path, steps: int = MAX_STEPS) -> CommandFile:
    """The commands in a file for a run of so many steps; a recording may be longer. Raises `RecordingError`."""
    try:
        text = read_text(path, "list of commands", MAX_BYTES).removeprefix("\ufeff")
        return _loads_commands(text, path, steps)
    except SceneError as error:
        raise RecordingError(error.source, error.problems) from None


def refused_in(path: Path, error: RefusedCommandError) -> RecordingError:
    """The error for a command of the recording in a file that a world refused, with its line if that can be told."""
    try:
        text = read_text(path, "recording", MAX_BYTES).removeprefix("\ufeff")
        return _located(path, text, _OF_RECORDINGS, error)
    except SceneError:  # what a pipe had to say is gone
        return RecordingError(str(path), [Problem(str(error))])


def _located(path: Path, text: str, home: Way, error: RefusedCommandError) -> RecordingError:
    found = scene_error(str(path), [Finding((*home, error.index), error.message)], text)
    return RecordingError(found.source, found.problems)


@one_effort()
def _loads_commands(text: str, path: Path, steps: int) -> CommandFile:
    data = parse(text, str(path)).data
    if isinstance(data, dict) and "commands" in data:
        return CommandFile(path, text, loads_recording(text, path).commands, _OF_RECORDINGS)
    if not isinstance(data, list):
        raise scene_error(str(path), [Finding((), 'commands are a list [[step, "NAME", {...}], ...]')], text)
    commands: list[TimedCommand] = []
    found = decode_all(tuple(data), steps, commands, ())
    if found:
        raise scene_error(str(path), found, text)
    return CommandFile(path, text, tuple(commands), ())
