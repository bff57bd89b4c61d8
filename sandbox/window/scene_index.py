"""The shipped scenes as the list shows them: title and about, by theme."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

from sandbox.resources import SCENE_SUFFIX, scenes_dir, shipped_scenes

_BEGINNERS = "first"


@dataclass(frozen=True)
class Entry:
    """One scene file; `theme` is the name of its folder."""

    path: Path
    title: str
    about: str
    theme: str


def scene_entries() -> list[Entry]:
    """All shipped scenes, by folder, then by file name; the folder for beginners comes first."""
    entries = [_entry(path, scenes_dir()) for path in shipped_scenes()]
    return sorted(entries, key=lambda entry: entry.theme != _BEGINNERS)


def _entry(path: Path, root: Path) -> Entry:
    """Title and about alone are read: whether the scene is right shows when it is opened."""
    name = path.name.removesuffix(SCENE_SUFFIX)
    theme = path.parent.name if path.parent != root else ""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        return Entry(path, str(data.get("title") or name), str(data.get("about", "")), theme)
    except (OSError, ValueError, AttributeError):
        return Entry(path, name, "", theme)
