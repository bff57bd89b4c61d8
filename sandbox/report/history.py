"""Earlier texts of a file, if it is kept in git; nothing if it is not."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from pathlib import Path

DEPTH = 30
"""Versions looked at."""
_SECONDS = 20.0


def earlier_texts(path: Path) -> Iterator[tuple[str, str]]:
    """(short name of a revision, the file's text then), the latest first."""
    listed = _git(path, "log", f"--max-count={DEPTH}", "--format=%h", "--", path.name)
    for revision in (listed or "").split():
        text = _git(path, "show", f"{revision}:./{path.name}")
        if text is not None:
            yield revision, text


def _git(path: Path, *arguments: str) -> str | None:
    command = ["git", "--no-pager", "-C", str(path.resolve().parent), *arguments]
    try:
        done = subprocess.run(command, capture_output=True, timeout=_SECONDS, check=False)
        return done.stdout.decode("utf-8") if done.returncode == 0 else None
    except (OSError, subprocess.SubprocessError, UnicodeDecodeError):
        return None
