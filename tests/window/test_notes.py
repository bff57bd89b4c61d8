"""Notes on what just happened: the reason of a failure stands at the end, and is to be read."""

from __future__ import annotations

import errno
import os
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from sandbox.errors import SandboxError
from sandbox.window.hud import NOTE_LINES, note_lines
from sandbox.window.workspace import failed

OVERLAY: Any = SimpleNamespace(width=lambda text, _=0.0: 10.0 * len(text))
"""Letters of ten pixels."""


def test_a_note_has_as_many_lines_as_it_needs() -> None:
    text = "not saved: my/folder/yard.replay.json: Permission denied"
    assert note_lines(OVERLAY, text, 10.0 * len(text)) == [text]
    lines = note_lines(OVERLAY, text, 300.0)
    assert " ".join(lines) == text
    assert max(map(len, lines)) <= 30
    assert note_lines(OVERLAY, "", 300.0) == [""]


@pytest.mark.parametrize("text", ["word " * 100, "x" * 100, "a\nb " * 50])
def test_what_is_too_long_is_cut_in_the_last_line(text: str) -> None:
    lines = note_lines(OVERLAY, text, 200.0)
    assert len(lines) <= NOTE_LINES
    assert max(map(len, lines)) <= 20
    assert any(line.endswith("…") for line in lines)


def test_a_failure_of_the_system_is_told_in_words(tmp_path: Path) -> None:
    """No `[Errno 13]` and no quotes of Python, which took the room of the reason."""
    error = PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(tmp_path / "a.png"))
    assert failed("not saved", error) == f"not saved: {(tmp_path / 'a.png').as_posix()}: {os.strerror(errno.EACCES)}"
    assert failed("not saved", SandboxError("nothing to write")) == "not saved: nothing to write"
