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
    return bool(_OF_SCENES & outermost(path, MAX_BYTES).keys())


def is_scene(data: Any) -> bool:
    """Whether parsed JSON is a scene, and no recording."""
    return isinstance(data, dict) and bool(_OF_SCENES & data.keys()) and not _OF_RECORDINGS & data.keys()


def is_recording(data: Any) -> bool:
    """Whether parsed JSON is a recording."""
    return isinstance(data, dict) and data.keys() >= _OF_RECORDINGS


def outermost(path: Path, limit: int) -> dict[str, Any]:
    """What the first `limit` bytes of a file are as JSON; empty if they are no object."""
    try:
        data = json.loads(read_bytes(path, limit))
    except (OSError, ValueError, RecursionError):
        return {}
    return data if isinstance(data, dict) else {}
