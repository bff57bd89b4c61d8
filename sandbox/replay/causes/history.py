"""What git knows of a file; nothing if it is not kept in git."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

DEPTH = 30
"""Versions looked at."""
_SECONDS = 20.0
_OF_HOOKS = ("GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_PREFIX", "GIT_OBJECT_DIRECTORY")


def earlier_texts(path: Path) -> Iterator[tuple[str, str]]:
    """(short name of a revision, the file's text then), the latest first."""
    for revision in revisions_of(path):
        text = git(path.parent, "cat-file", "blob", f"{revision}:./{path.name}")
        if text is not None:
            yield revision, text


def revisions_of(path: Path) -> list[str]:
    """The short names of the revisions that changed a file, the latest first."""
    return (git(path.parent, "log", f"--max-count={DEPTH}", "--format=%h", "--", path.name) or "").split()


def is_kept(path: Path) -> bool:
    """Whether git knows any version of a file."""
    return bool(git(path.parent, "log", "--max-count=1", "--format=%h", "--", path.name))


def is_cut(path: Path) -> bool:
    """Whether git has only the latest revisions here, a shallow clone."""
    return (git(path.parent, "rev-parse", "--is-shallow-repository") or "").strip() == "true"


def git(folder: Path, *arguments: str) -> str | None:
    """What git prints in a folder; None if it cannot."""
    command = ["git", "--no-pager", "-c", "log.showSignature=false", "-C", str(folder.resolve()), *arguments]
    try:
        done = subprocess.run(command, capture_output=True, timeout=_SECONDS, check=False, env=surroundings())
        return done.stdout.decode("utf-8") if done.returncode == 0 else None
    except (OSError, subprocess.SubprocessError, UnicodeDecodeError):
        return None


def surroundings() -> dict[str, str]:
    """The environment for git, without what a hook sets: it would lead to the repository that the hook is for."""
    return {name: value for name, value in os.environ.items() if name not in _OF_HOOKS}
