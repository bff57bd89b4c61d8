"""Which files were opened last, kept between runs."""

from __future__ import annotations

import json
from contextlib import suppress
from pathlib import Path

from sandbox._atomic_write import write_text

NAME = "recent.json"
MOST = 12


def recent_files(folder: Path) -> list[Path]:
    """Those that are still there, the last one first. A damaged list is an empty one."""
    try:
        names = json.loads((folder / NAME).read_text(encoding="utf-8"))
        return [path for name in names[:MOST] if (path := Path(name)).is_file()]
    except (OSError, ValueError, TypeError):
        return []


def note_recent(folder: Path, path: Path) -> None:
    """Put a file at the head of the list. Where the list cannot be written, nothing is noted."""
    here = path.resolve()
    names = [str(here), *(str(one) for one in recent_files(folder) if one != here)]
    with suppress(OSError):
        folder.mkdir(parents=True, exist_ok=True)
        write_text(folder / NAME, json.dumps(names[:MOST], indent=1) + "\n")
