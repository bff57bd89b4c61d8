"""Scenes as they stand on a shelf: file, title, about and theme, and a search among them."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

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


def found_by(entry: Entry, words: str) -> bool:
    """Whether all of the words are in its title, about, theme or name, whatever their case."""
    text = f"{entry.title} {entry.about} {entry.theme} {entry.path.name}".lower()
    return all(word in text for word in words.lower().split())


def entry_of(path: Path, theme: str) -> Entry:
    """Title and about alone are read: whether the scene is right shows when it is opened."""
    name = path.name.removesuffix(SCENE_SUFFIX)
    try:
        if path.stat().st_size > LARGEST:
            return Entry(path, name, "", theme)
        data = json.loads(path.read_text(encoding="utf-8"))
        return Entry(path, str(data.get("title") or name), str(data.get("about", "")), theme)
    except (OSError, ValueError, AttributeError, RecursionError):
        return Entry(path, name, "", theme)
