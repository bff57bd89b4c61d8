"""Sessions that are on disk: read back from their journals, to be gone on with."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from sandbox.engine.arithmetic_version import ARITHMETIC
from sandbox.errors import SandboxError
from sandbox.replay.moment import Future, Moment, Past
from sandbox.replay.recording.command_words import TimedCommand, decode
from sandbox.replay.recording.tape import Tape
from sandbox.scene import Scene, loads_scene
from sandbox.window.journal import SUFFIX

LARGEST = 64 * 1024 * 1024
"""Bytes of a journal that is read back at most."""
_STACKS = ("undo", "redo", "branches", "deeds")


@dataclass(frozen=True)
class Leftover:
    """What a session left: its file, the scene, the script that it began with, what was done in how many steps, where
    the user stood, and what could be undone or gone back to.
    """

    path: Path
    title: str
    scene: Scene
    script: tuple[TimedCommand, ...]
    commands: tuple[TimedCommand, ...]
    steps: int
    at: int
    past: Past

    def discard(self) -> None:
        """Forget it."""
        self.path.unlink(missing_ok=True)


def leftovers(folder: Path) -> list[Leftover]:
    """What sessions left that were cut off, the latest first; those of programs that still run are not among them."""
    try:
        paths = sorted(folder.glob(f"*{SUFFIX}"), key=lambda path: path.stat().st_mtime, reverse=True)
    except OSError:
        return []
    return [found for path in paths if not _runs(path) and (found := read_session(path)) is not None]


def read_session(path: Path) -> Leftover | None:
    """A journal, as far as its lines are whole; None if nothing of use is in it."""
    lines = _lines(path)
    try:
        head = next(lines)
        scene = _scene(head)
    except (StopIteration, SandboxError, KeyError, TypeError, ValueError):
        return None
    found = _Reading()
    found.read(lines)
    if not found.commands and not found.stacks["undo"] and not found.stacks["branches"]:
        return None
    at = found.steps if found.at < 0 else min(found.at, found.steps)
    past = Past(**found.stacks) if head.get("arithmetic") == ARITHMETIC else Past()  # or it may go another way
    title = str(head.get("title", ""))
    return Leftover(path, title, scene, tuple(found.script), tuple(found.commands), found.steps, at, past)


@dataclass
class _Reading:
    """What the lines up to here say."""

    commands: list[TimedCommand] = field(default_factory=list)
    script: list[TimedCommand] = field(default_factory=list)
    steps: int = 0
    at: int = -1
    stacks: dict[str, list[Any]] = field(default_factory=lambda: {name: [] for name in _STACKS})
    _rows: list[TimedCommand] = field(default_factory=list)
    _futures: list[Future] = field(default_factory=list)

    def read(self, lines: Iterable[Any]) -> None:
        """All lines, up to the first that is none."""
        try:
            for line in lines:
                if isinstance(line, list):
                    self.commands.append(self._row(line))
                    self.steps = max(self.steps, self._rows[-1][0])
                else:
                    self._change(line)
        except (LookupError, TypeError, ValueError, AttributeError):
            return

    def _change(self, line: dict[str, Any]) -> None:
        self.commands = self.commands[: line.get("keep", len(self.commands))]
        self.steps = int(line.get("steps", self.steps))
        self.at = int(line.get("at", self.at))
        self.commands += self._in(line.get("again", ()))
        self.script += self._in(line.get("script", ()))
        if "aside" in line:
            self._row(line["aside"])
        if "future" in line:
            label, ranges, length = line["future"]
            script = self._in(ranges)
            self._futures.append(Future(str(label), script, len(script), Tape(), int(length)))
        for name in _STACKS:
            if name in line:
                change = line[name]
                kept = self.stacks[name][change["drop"] :][: change["keep"]]
                self.stacks[name] = kept + [getattr(self, f"_one_of_{name}")(one) for one in change["add"]]
        if "again" in line:
            self.steps = max(self.steps, self.commands[-1][0])

    def _row(self, words: Any) -> TimedCommand:
        command, wrong = decode(words, ())
        if command is None or wrong:
            raise ValueError("no command")
        self._rows.append(command)
        return command

    def _in(self, ranges: Iterable[tuple[int, int]]) -> list[TimedCommand]:
        """The commands of ranges of numbers. Raises `LookupError` for those that were not written."""
        return [self._rows[number] for first, end in ranges for number in range(first, end)]

    def _one_of_branches(self, number: int) -> Future:
        return self._futures[number]

    def _one_of_deeds(self, words: tuple[str, int]) -> tuple[str, TimedCommand]:
        return str(words[0]), self._rows[words[1]]

    def _one_of_undo(self, words: tuple[str, int, int, int, list[int]]) -> Moment:
        label, future, step, applied, branches = words
        others = tuple(self._futures[number] for number in branches)
        return Moment(str(label), self._futures[future], int(step), int(applied), others)

    _one_of_redo = _one_of_undo


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
