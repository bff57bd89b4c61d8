"""What the gallery shows: title and about of scenes, by theme."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

from sandbox.replay.recording.limits import SUFFIX
from sandbox.resources import SCENE_SUFFIX, scenes_dir, shipped_scenes
from sandbox.window.recent import recent_files

_BEGINNERS = "first"
RECENT, OWN = "opened lately", "this folder"
MOST_OWN = 200
LARGEST = 16 * 1024 * 1024
"""Bytes of a file whose title is read."""


@dataclass(frozen=True)
class Entry:
    """One scene file; `theme` is the name of its folder, or where else it comes from."""

    path: Path
    title: str
    about: str
    theme: str


def scene_entries(state: Path | None = None, folder: Path | None = None) -> list[Entry]:
    """What there is to open: files opened lately, those in `folder` and below, and all shipped scenes by theme.

    `state` is the folder that keeps what was opened lately. The shipped scenes for beginners come first.
    """
    root = scenes_dir()
    shipped = [entry_of(path, path.parent.name if path.parent != root else "") for path in shipped_scenes()]
    shipped = sorted(shipped, key=lambda entry: entry.theme != _BEGINNERS)
    recent = recent_files(state) if state is not None else []
    own = _own_files(folder) if folder is not None else []
    return [
        *(entry_of(path, RECENT) for path in recent),
        *(entry_of(path, OWN) for path in own),
        *shipped,
    ]


def found_by(entry: Entry, words: str) -> bool:
    """Whether all of the words are in its title, about, theme or name, whatever their case."""
    text = f"{entry.title} {entry.about} {entry.theme} {entry.path.name}".lower()
    return all(word in text for word in words.lower().split())


def _own_files(folder: Path) -> list[Path]:
    """Scenes and recordings of the folder that the program was started in; none if it holds the shipped ones."""
    here = folder.resolve()
    if scenes_dir().resolve().is_relative_to(here) or here.is_relative_to(scenes_dir().resolve()):
        return []
    if here in (Path.home().resolve(), Path(here.anchor)):
        return []  # too much to search
    found = [*sorted(here.glob(f"*{SCENE_SUFFIX}")), *sorted(here.glob(f"*{SUFFIX}"))]
    found += sorted(here.glob(f"*/*{SCENE_SUFFIX}"))
    return found[:MOST_OWN]


def entry_of(path: Path, theme: str) -> Entry:
    """Title and about alone are read: whether the scene is right shows when it is opened."""
    name = path.name.removesuffix(SCENE_SUFFIX)
    try:
        if path.name.endswith(SUFFIX) or path.stat().st_size > LARGEST:
            return Entry(path, name, "", theme)
        data = json.loads(path.read_text(encoding="utf-8"))
        return Entry(path, str(data.get("title") or name), str(data.get("about", "")), theme)
    except (OSError, ValueError, AttributeError, RecursionError):
        return Entry(path, name, "", theme)
