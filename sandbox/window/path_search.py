"""Files by their path: what is typed into the gallery's search when it begins like one."""

from __future__ import annotations

import os
from pathlib import Path

from sandbox.replay.recording.limits import SUFFIX
from sandbox.resources import SCENE_SUFFIX
from sandbox.scene.catalog import Entry
from sandbox.window.scene_index import entry_of

MOST = 200
"""Entries that are shown at most."""


def is_path(text: str) -> bool:
    """Whether a text begins as paths do: with a root, a dot, a tilde or a drive."""
    return text.startswith(("/", "\\", "~", "./", "../", ".\\", "..\\")) or Path(text).drive != ""


def path_entries(text: str) -> list[Entry]:
    """The folders, scenes and recordings whose paths begin with `text`, folders first."""
    whole = os.path.expanduser(text)
    folder, start = os.path.split(whole)
    home = Path(folder or ".")
    try:
        names = sorted(name for name in os.listdir(home) if name.lower().startswith(start.lower()))
    except OSError:
        return []
    names = [name for name in names if not name.startswith(".") or start.startswith(".")]
    folders = [name for name in names if (home / name).is_dir()]
    files = [name for name in names if name.endswith((SCENE_SUFFIX, SUFFIX))]
    theme = str(home)
    found = [Entry(home / name, name + os.sep, "A folder.", theme) for name in folders]
    return (found + [entry_of(home / name, theme) for name in files])[:MOST]
