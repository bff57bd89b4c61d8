"""The session on disk while it is being played, so that neither a crash nor a kill nor a goodbye loses anything.

A journal is a file of JSON lines: first the scene, then what is done, in the words of `journal_words.py`. It is called
`PID-*.session.jsonl` while it is written, and `KEY-*.ended.jsonl` once the session has ended as it should.
"""

from __future__ import annotations

import hashlib
import json
import os
import uuid
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sandbox.engine.arithmetic_version import ARITHMETIC
from sandbox.window.journal_words import Words

if TYPE_CHECKING:
    from sandbox.scene import Scene
    from sandbox.window.session import Session

SUFFIX, ENDED = ".session.jsonl", ".ended.jsonl"
EVERY = 60
"""Steps between two lines that say how far the run has come, while time runs."""
MOST_ENDED = 20
"""Sessions that ended as they should and are kept: the oldest go."""


class Journal:
    """Writes one session down. Where it cannot be written, it is silent: the session goes on."""

    def __init__(self, folder: Path) -> None:
        self.path = folder / f"{os.getpid()}-{uuid.uuid4().hex[:8]}{SUFFIX}"
        self._file: Any = None
        self._words = Words()
        self._scene: Scene | None = None
        self._steps, self._length, self._at, self._stood = 0, 0, -1, -1

    def sync(self, session: Session) -> None:
        """Write down what is new. Nothing is written until something has been done: a scene by itself is no loss."""
        if self._file is None and (not session.touched or not self._open(session)):
            return
        timeline, words = session.timeline, self._words
        words.run(timeline.commands, timeline.length, self._steps)
        words.past(timeline.past)
        self._note_time(timeline.step_count, timeline.length)
        if words.lines:
            self._write(words.lines)
            words.lines.clear()

    def close(self) -> None:
        """The session ends as it should: it is kept under another name, with those that ended so."""
        if self._file and self._scene is not None:
            self._file.close()
            with suppress(OSError):
                ended = self.path.with_name(f"{key(self._scene)}-{uuid.uuid4().hex[:8]}{ENDED}")
                self.path.replace(ended)
                for old in ended_sessions(self.path.parent)[MOST_ENDED:]:
                    old.unlink(missing_ok=True)
        self._file = False

    def _note_time(self, step: int, length: int) -> None:
        """How far the run is known, and where in it the user stands: now and then, and where he stays."""
        if any("keep" in line for line in self._words.lines if isinstance(line, dict)):
            self._steps = length
        rests, self._length = length == self._length, length
        if length >= self._steps + EVERY or (rests and length != self._steps):
            self._steps = length
            self._words.lines.append({"steps": length})
        at = step if step < length else -1  # -1: at the end, which goes on
        if at != self._at and (at == self._stood or at < 0):
            self._at = at
            self._words.lines.append({"at": at, "steps": length} if at >= 0 else {"at": at})
        self._stood = at

    def _open(self, session: Session) -> bool:
        if self._file is False:
            return False
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self._file = self.path.open("x", encoding="utf-8")
        except OSError:
            self._file = False
            return False
        self._scene = scene = session.scene
        words = scene.text if scene.text is not None else json.dumps({"format": 1, **scene.to_data()})
        head = {"source": _source(scene), "from_file": scene.text is not None, "title": scene.title, "scene": words}
        self._write([{**head, "set": scene.set_values, "arithmetic": ARITHMETIC}])
        self._words.script(session.script)
        return bool(self._file)

    def _write(self, lines: list[Any]) -> None:
        if not self._file:
            return
        try:
            self._file.write("".join(json.dumps(line, separators=(",", ":")) + "\n" for line in lines))
            self._file.flush()
        except OSError:
            self._file = False


def key(scene: Scene) -> str:
    """What the names of ended sessions of a scene begin with."""
    return hashlib.sha256(_source(scene).encode()).hexdigest()[:16]


def ended_sessions(folder: Path, scene: Scene | None = None) -> list[Path]:
    """Sessions that ended as they should, the latest first: all, or those of one scene."""
    try:
        found = folder.glob(f"{key(scene) if scene is not None else '*'}-*{ENDED}")
        return sorted(found, key=lambda path: path.stat().st_mtime, reverse=True)
    except OSError:
        return []


def _source(scene: Scene) -> str:
    return str(Path(scene.source).resolve()) if scene.text is not None else scene.source
