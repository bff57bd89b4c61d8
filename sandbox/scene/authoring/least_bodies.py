"""How many bodies a copy of a prefab makes at least: prefabs within prefabs multiply, and nobody waits for too many."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sandbox.scene.authoring.document import Written
from sandbox.scene.limits import MAX_NESTING
from sandbox.scene.plain import is_several


def least_bodies(written: Mapping[str, Written], name: str) -> int:
    """The bodies of a copy of the prefab `name`, and those of the copies that it puts down in turn.

    Only numbers that stand there are counted: what an expression gives may be none, and so may other generators.
    """
    return _least(written, name, {}, 0)


def _least(written: Mapping[str, Written], name: str, known: dict[str, int], depth: int) -> int:
    prefab = written[name].value if name in written else None
    if name in known or depth > MAX_NESTING or not isinstance(prefab, dict):
        return known.get(name, 0)
    known[name] = 0  # where prefabs contain each other, which is refused elsewhere
    if not is_several(prefab):
        known[name] = 1
        return 1
    found = len(_entries(prefab, "bodies"))
    for entry in _entries(prefab, "generate"):
        inner, count = (entry.get("place"), entry.get("count", 1)) if isinstance(entry, dict) else (None, 0)
        if isinstance(inner, str) and type(count) is int and count > 0:
            found += count * _least(written, inner, known, depth + 1)
    known[name] = found
    return found


def _entries(prefab: Mapping[str, Any], key: str) -> list[Any] | tuple[Any, ...]:
    entries = prefab.get(key, ())
    return entries if isinstance(entries, (list, tuple)) else ()
