"""In what the running engine differs from the one that made a recording, as far as git and the recording tell."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import sandbox
from sandbox._version import __version__
from sandbox.engine.arithmetic_version import ARITHMETIC
from sandbox.replay.causes.engine_edits import FileEdit, is_engine, told
from sandbox.replay.causes.history import git, revisions_of
from sandbox.replay.golden.rerun import version_notes
from sandbox.replay.recording.environment import environment
from sandbox.replay.recording.recording import Recording


@dataclass(frozen=True)
class EngineChanges:
    """`said` tells what is another, empty if nothing is known to be; `revision` is one whose engine is worth a run
    (`--against`), "" if git knows none; `same` says what was looked at and is the same; `remarks` what is otherwise
    around the engine, and should make no difference.
    """

    said: tuple[str, ...]
    revision: str = ""
    same: str = ""
    remarks: tuple[str, ...] = ()


def engine_since(recording: Recording) -> EngineChanges:
    """What is known to be another engine than when the recording was made."""
    said = [*_version_news(recording)]
    root = Path(sandbox.__file__).resolve().parents[1]
    revision, why = _revision(recording, root)
    if not revision:
        return EngineChanges(tuple(said), same=why, remarks=_surroundings(recording))
    edits = _edits_since(root, revision)
    if edits:
        said += [f"its source differs from that of revision {revision}, {why}:", *told(edits)]
    same = f"the engine's source is that of revision {revision}, {why}"
    return EngineChanges(tuple(said), revision, same, _surroundings(recording))


def _version_news(recording: Recording) -> tuple[str, ...]:
    if recording.arithmetic != ARITHMETIC:
        return version_notes(recording)
    return (f"sandbox {recording.version} recorded this, and {__version__} runs",) * (recording.version != __version__)


def _surroundings(recording: Recording) -> tuple[str, ...]:
    before, now = recording.environment, environment()
    return (f"recorded with {before}; runs with {now}",) * (bool(before) and before != now)


def _revision(recording: Recording, root: Path) -> tuple[str, str]:
    """The revision of the engine that is nearest to the recording, and what it is; "" and why there is none."""
    top = git(root, "rev-parse", "--show-toplevel")
    if top is None or git(root, "ls-files", "--error-unmatch", "sandbox/__init__.py") is None:
        return "", "the engine that runs is not kept in git here"
    file = recording.source
    if file is not None and git(file.parent, "rev-parse", "--show-toplevel") == top:
        known = revisions_of(file)
        if known:
            return known[0], f"with which {file.name} was committed"
    head = git(root, "rev-parse", "--short", "HEAD")
    return (head.strip(), "the last one") if head else ("", "the engine's repository has no commit")


@lru_cache(maxsize=8)
def _edits_since(root: Path, revision: str) -> list[FileEdit]:
    listed = git(root, "diff", "--name-only", "--relative", revision, "--", "sandbox") or ""
    found = []
    for path in filter(is_engine, listed.splitlines()):
        old = git(root, "cat-file", "blob", f"{revision}:./{path}") or ""
        file = root / path
        new = file.read_text(encoding="utf-8", errors="replace") if file.is_file() else ""
        found.append(FileEdit(path, old, new))
    return found
