"""What was changed in the engine's source: files, and the lines themselves if they are few."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from difflib import SequenceMatcher
from pathlib import Path

from sandbox._printable import printable

PACKAGES = (
    "_jit.py",
    "_linking.py",
    "_machine_code.py",
    "_way_in.py",
    "tables.py",
    "geometry",
    "scene",
    "world",
    "engine",
)
"""What of the package decides about the bits of a run."""
_LINES = 3
"""Changed lines that are shown."""
_FILES = 5
"""Changed files that are named."""
_WIDTH = 100


@dataclass(frozen=True)
class FileEdit:
    """A changed file, by its path from the folder above the package; a text is empty where there was no such file."""

    path: str
    old: str
    new: str

    def lines(self) -> Iterator[str]:
        """`PATH:LINE: was A, is B` for each changed line of code, with the line's number in the new text."""
        before, after = self.old.splitlines(), self.new.splitlines()
        for what, a0, a1, b0, b1 in SequenceMatcher(None, before, after, autojunk=False).get_opcodes():
            if what == "equal":
                continue
            for k in range(max(a1 - a0, b1 - b0)):
                was = before[a0 + k].strip() if a0 + k < a1 else ""
                now = after[b0 + k].strip() if b0 + k < b1 else ""
                yield f"{self.path}:{min(b0 + k + 1, len(after))}: was `{_cut(was)}`, is `{_cut(now)}`"


def told(edits: list[FileEdit]) -> list[str]:
    """The names of changed files; of a change of a few lines the lines themselves."""
    lines: list[str] = []
    for edit in edits[:_LINES]:
        for line in edit.lines():
            lines.append(line)
            if len(lines) > _LINES:
                break
    if len(edits) <= _LINES and len(lines) <= _LINES:
        return lines
    names = [edit.path for edit in edits[:_FILES]]
    more = f" and {len(edits) - _FILES} more" if len(edits) > _FILES else ""
    return [", ".join(names) + more]


def between_folders(old: Path, new: Path) -> list[FileEdit]:
    """What differs in the engine of two checkouts, by the folders above the package."""
    before, after = _files(old), _files(new)
    found = []
    for path in sorted(before | after):
        texts = [_read(root / path) for root in (old, new)]
        if texts[0] != texts[1]:
            found.append(FileEdit(path, *texts))
    return found


def is_engine(path: str) -> bool:
    """Whether a path such as `sandbox/engine/step.py` can decide about bits."""
    parts = path.split("/")
    return len(parts) > 1 and parts[0] == "sandbox" and parts[1] in PACKAGES and path.endswith(".py")


def _files(root: Path) -> set[str]:
    found = (path.relative_to(root).as_posix() for path in (root / "sandbox").rglob("*.py"))
    return {path for path in found if is_engine(path)}


def _read(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return ""


def _cut(text: str) -> str:
    text = printable(text)
    return text if len(text) <= _WIDTH else text[: _WIDTH - 3] + "..."
