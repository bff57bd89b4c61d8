"""What the gallery shows: title and about of scenes, by theme."""

from __future__ import annotations

from pathlib import Path

from sandbox.replay.recording.limits import SUFFIX
from sandbox.resources import SCENE_SUFFIX, scenes_dir
from sandbox.scene import catalog
from sandbox.scene.catalog import Entry, shipped_entries
from sandbox.window.recent import recent_files

RECENT, OWN = "opened lately", "this folder"
MOST_OWN = 200


def scene_entries(state: Path | None = None, folder: Path | None = None) -> list[Entry]:
    """What there is to open: files opened lately, those in `folder` and below, and all shipped scenes by theme.

    `state` is the folder that keeps what was opened lately. The shipped scenes for beginners come first.
    """
    recent = recent_files(state) if state is not None else []
    own = _own_files(folder) if folder is not None else []
    return [
        *(entry_of(path, RECENT) for path in recent),
        *(entry_of(path, OWN) for path in own),
        *shipped_entries(),
    ]


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
    """That of a scene; a recording is known by its name alone."""
    return Entry(path, path.name, "", theme) if path.name.endswith(SUFFIX) else catalog.entry_of(path, theme)
