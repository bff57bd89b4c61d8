"""Whether a file is a recording, before it is read as one."""

from __future__ import annotations

from pathlib import Path

from sandbox._lent import is_lent
from sandbox.replay.recording.limits import MAX_BYTES, SUFFIX
from sandbox.scene.known_file import is_recording, outermost


def holds_recording(path: Path) -> bool:
    """As its name says. What a shell lends, as `<(command)`, has none, and what is in it tells."""
    return path.name.endswith(SUFFIX) or (is_lent(path) and is_recording(outermost(path, MAX_BYTES)))
