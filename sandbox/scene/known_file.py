"""What a JSON file is, told from its name and its outermost keys."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from sandbox._bounded_read import read_bytes
from sandbox.resources import SCENE_SUFFIX
from sandbox.scene.limits import MAX_BYTES

_OF_SCENES = {"bodies", "generate"}
_OF_RECORDINGS = {"scene", "steps", "digests"}


def looks_like_a_scene(path: Path) -> bool:
    """Whether its author took it for a scene: by its name, or because it has bodies."""
    if path.name.endswith(SCENE_SUFFIX):
        return True
    try:
        data = json.loads(read_bytes(path, MAX_BYTES))
    except (OSError, ValueError, RecursionError):
        return False
    return isinstance(data, dict) and bool(_OF_SCENES & data.keys())


def is_recording(data: Any) -> bool:
    """Whether parsed JSON is a recording."""
    return isinstance(data, dict) and data.keys() >= _OF_RECORDINGS
