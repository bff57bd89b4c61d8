"""The session on disk while it is being played, so that a crash or a kill loses nothing.

A journal is a file of JSON lines: first the scene, then the commands as recordings have them, with lines that say how
far the run has come and how much of it was taken back. A last line that was cut off is left out.
"""

from __future__ import annotations

import json
import os
import sys
import uuid
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sandbox.errors import SandboxError
from sandbox.replay.moment import common_prefix
from sandbox.replay.recording.command_words import TimedCommand, decode, encode
from sandbox.scene import Scene, loads_scene

if TYPE_CHECKING:
    from sandbox.window.session import Session

SUFFIX = ".session.jsonl"
EVERY = 60
"""Steps between two lines that say how far the run has come."""
LARGEST = 64 * 1024 * 1024
"""Bytes of a journal that is read back at most."""


class Journal:
    """Writes one session down. Where it cannot be written, it is silent: the session goes on."""

    def __init__(self, folder: Path) -> None:
        self.path = folder / f"{os.getpid()}-{uuid.uuid4().hex[:8]}{SUFFIX}"
        self._file: Any = None
        self._written: list[TimedCommand] = []
        self._count = 0
        self._steps = 0

    def sync(self, session: Session) -> None:
        """Write down what is new. Nothing is written until something has been done: a scene by itself is no loss."""
        commands = session.timeline.commands
        if self._file is None and (not commands or not self._open(session)):
            return
        if commands is not self._written or len(commands) < self._count:
            same = common_prefix(self._written[: self._count], commands)
            if same < self._count or session.timeline.length < self._steps:
                self._line({"keep": same, "steps": session.timeline.length})
                self._steps = session.timeline.length
            self._written, self._count = commands, same
        for step, command in commands[self._count :]:
            self._line([step, *encode(command)])
        self._count = len(commands)
        if session.timeline.length >= self._steps + EVERY:
            self._steps = session.timeline.length
            self._line({"steps": self._steps})

    def close(self) -> None:
        """The session ends as it should: nothing needs to be kept."""
        if self._file:
            self._file.close()
            self.path.unlink(missing_ok=True)
        self._file = False

    def _open(self, session: Session) -> bool:
        if self._file is False:
            return False
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self._file = self.path.open("x", encoding="utf-8")
        except OSError:
            self._file = False
            return False
        scene = session.scene
        words = scene.text if scene.text is not None else json.dumps({"format": 1, **scene.to_data()})
        source = str(Path(scene.source).resolve()) if scene.text is not None else scene.source
        head = {"source": source, "from_file": scene.text is not None, "title": scene.title, "scene": words}
        self._line({**head, "set": scene.set_values})
        return bool(self._file)

    def _line(self, content: Any) -> None:
        if not self._file:
            return
        try:
            self._file.write(json.dumps(content, separators=(",", ":")) + "\n")
            self._file.flush()
        except OSError:
            self._file = False


@dataclass(frozen=True)
class Leftover:
    """What a session that ended without a goodbye left: its file, the scene, what was done, how many steps it came."""

    path: Path
    title: str
    scene: Scene
    commands: tuple[TimedCommand, ...]
    steps: int

    def discard(self) -> None:
        """Forget it."""
        self.path.unlink(missing_ok=True)


def leftovers(folder: Path) -> list[Leftover]:
    """What earlier sessions left, the newest first; those of programs that still run are not among them."""
    try:
        paths = sorted(folder.glob(f"*{SUFFIX}"), key=lambda path: path.stat().st_mtime, reverse=True)
    except OSError:
        return []
    return [found for path in paths if not _runs(path) and (found := _read(path)) is not None]


def _runs(path: Path) -> bool:
    """Whether the program that writes a journal still runs."""
    number = path.name.partition("-")[0]
    if not number.isdigit() or int(number) == os.getpid():
        return number.isdigit()
    if sys.platform == "win32":  # an open file cannot be renamed there, and signal 0 would not be harmless
        try:
            path.rename(path)
        except OSError:
            return True
        return False
    try:
        os.kill(int(number), 0)
    except (ProcessLookupError, OverflowError):
        return False
    except OSError:
        return True  # somebody else's, or a system that does not say
    return True


def _scene(head: Any) -> Scene:
    if head["from_file"]:
        return loads_scene(head["scene"], head["source"], head.get("set"))
    return Scene(**json.loads(head["scene"]))


def _read(path: Path) -> Leftover | None:
    """A journal; None if nothing of use is in it."""
    lines = _lines(path)
    try:
        head = next(lines)
        scene = _scene(head)
    except (StopIteration, SandboxError, KeyError, TypeError, ValueError):
        return None
    commands: list[TimedCommand] = []
    steps = 0
    for line in lines:
        if isinstance(line, dict):
            commands = commands[: line.get("keep", len(commands))]
            steps = int(line.get("steps", steps))
        else:
            command, wrong = decode(line, ())
            if command is None or wrong:
                break
            commands.append(command)
            steps = max(steps, command[0])
    return Leftover(path, str(head.get("title", "")), scene, tuple(commands), steps) if commands else None


def _lines(path: Path) -> Iterator[Any]:
    """The lines that are whole."""
    try:
        if path.stat().st_size > LARGEST:
            return
        for line in path.read_text(encoding="utf-8", errors="replace").splitlines(keepends=True):
            if not line.endswith("\n"):
                return
            yield json.loads(line)
    except (OSError, ValueError):
        return
