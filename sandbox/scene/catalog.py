"""Scenes as they stand on a shelf: file, title, about and theme, and a search among them."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from sandbox._bounded_read import read_bytes
from sandbox.resources import SCENE_SUFFIX, scenes_dir, shipped_scenes

_BEGINNERS = "first"
LARGEST = 16 * 1024 * 1024
"""Bytes of a file whose title is read."""


@dataclass(frozen=True)
class Entry:
    """One scene file; `theme` is the name of its folder, or where else it comes from."""

    path: Path
    title: str
    about: str
    theme: str


def shipped_entries() -> list[Entry]:
    """All shipped scenes by theme; those for beginners come first."""
    root = scenes_dir()
    shipped = [entry_of(path, path.parent.name if path.parent != root else "") for path in shipped_scenes()]
    return sorted(shipped, key=lambda entry: entry.theme != _BEGINNERS)


def search(entries: Iterable[Entry], words: str) -> list[Entry]:
    """Those that have all of the words in title, about, theme or name, whatever their case; each file once.

    The best come first: words that begin one of the title or of the file's name, then those within one, then others.
    """
    wanted = words.lower().split()
    files = {entry.path: entry for entry in reversed(list(entries))}
    found = [entry for entry in reversed(files.values()) if _has(entry, wanted)]
    return sorted(found, key=lambda entry: sum(_distance(entry, word) for word in wanted))


def _has(entry: Entry, words: list[str]) -> bool:
    text = f"{entry.title} {entry.about} {entry.theme} {entry.path.name}".lower()
    return all(word in text for word in words)


def _distance(entry: Entry, word: str) -> int:
    """How far a word is from the title: 0 at the beginning of a word of it, 1 within one, 2 in theme or about."""
    text = f"{entry.title} {entry.path.name.split('.')[0]}".lower()
    if any(part.startswith(word) for part in re.split(r"[\s-]+", text)) or text.startswith(word):
        return 0
    return 1 if word in text else 2


def entry_of(path: Path, theme: str) -> Entry:
    """Title and about alone are read: whether the scene is right shows when it is opened."""
    name = path.name.removesuffix(SCENE_SUFFIX)
    try:
        text = read_bytes(path, LARGEST + 1)
        if len(text) > LARGEST:
            return Entry(path, name, "", theme)
        data = json.loads(text.decode())
        return Entry(path, str(data.get("title") or name), str(data.get("about", "")), theme)
    except (OSError, ValueError, AttributeError, RecursionError):
        return Entry(path, name, "", theme)
