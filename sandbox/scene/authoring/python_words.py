"""A scene from Python, whose parts may be models, as far as prefabs are to be worked out in it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sandbox.scene.base import Model
from sandbox.scene.body import Body


def in_words(data: Mapping[str, Any]) -> dict[str, Any]:
    """The same data with plain objects for prefabs, generators and bodies with parameters."""
    words = dict(data)
    if isinstance(data.get("prefabs"), dict):
        words["prefabs"] = {name: _plain(prefab) for name, prefab in data["prefabs"].items()}
    if isinstance(data.get("generate"), (list, tuple)):
        words["generate"] = [_plain(generator) for generator in data["generate"]]
    bodies = data.get("bodies")
    if isinstance(bodies, (list, tuple)) and any(isinstance(body, Body) and body.params for body in bodies):
        words["bodies"] = [_plain(body) if isinstance(body, Body) and body.params else body for body in bodies]
    return words


def as_written(value: Any) -> Any:
    """Data from Python as a file would hold it: models in words, sequences as lists."""
    if isinstance(value, Model):
        return value.to_data()
    if isinstance(value, Mapping):
        return {key: as_written(entry) for key, entry in value.items()}
    value = value.tolist() if hasattr(value, "tolist") else value
    return [as_written(entry) for entry in value] if isinstance(value, (list, tuple)) else value


def _plain(part: Any) -> Any:
    return part.to_data() if isinstance(part, Model) else part
