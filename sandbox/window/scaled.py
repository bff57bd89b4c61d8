"""Entries of bodies in another size."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

_LENGTHS = ("circle", "box", "capsule", "segment", "polygon", "chain", "holes", "ghosts", "radius", "at")


def whole_body(entry: dict[str, Any], prefabs: Mapping[str, dict[str, Any]]) -> dict[str, Any]:
    """A body's entry with the fields of its prefab written out."""
    given = {name: value for name, value in entry.items() if name != "prefab"}
    return {**prefabs.get(entry.get("prefab", ""), {}), **given}


def scaled_body(entry: dict[str, Any], factor: float) -> dict[str, Any]:
    """A body's entry of a scene file with all lengths of its shapes times `factor`, about its origin.

    Masses that are given outright go with the area, inertias with its square.
    """
    given = {"mass": factor**2, "inertia": factor**4}
    result = {name: value * given.get(name, 1.0) if name in given else value for name, value in entry.items()}
    if "center" in entry:
        result["center"] = _times(entry["center"], factor)
    result["shapes"] = [
        {name: _times(value, factor) if name in _LENGTHS else value for name, value in shape.items()}
        for shape in entry.get("shapes", ())
    ]
    return result


def _times(value: Any, factor: float) -> Any:
    """A number, or a list of lists of numbers, times `factor`."""
    return [_times(one, factor) for one in value] if isinstance(value, (list, tuple)) else value * factor
