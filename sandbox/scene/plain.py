"""Reads plain data of a scene that may be wrong anywhere: what has the wrong type is passed over.

The rules between fields work on plain data, so that they find their mistakes in a file that has others too.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import Any, TypeGuard

from sandbox.scene.finding import Path
from sandbox.scene.limits import MAX_SHAPES

Node = tuple[Path, dict[str, Any]]
"""An object of the file and the path to it."""


def mapping(value: object) -> dict[str, Any]:
    """`value` if it is an object, else an empty one."""
    return value if isinstance(value, dict) else {}


def children(parent: object, path: Path) -> Iterator[Node]:
    """The objects in a list or object, each with its path; a longer one than any allowed is cut."""
    if isinstance(parent, dict):
        pairs: Any = parent.items()
    else:
        pairs = enumerate(parent) if isinstance(parent, (list, tuple)) else ()
    for key, value in islice(pairs, MAX_SHAPES):
        if isinstance(value, dict):
            yield (*path, key), value


def patterns(data: dict[str, Any]) -> Iterator[Node]:
    """Every body and prefab."""
    yield from children(data.get("prefabs"), ("prefabs",))
    yield from children(data.get("bodies"), ("bodies",))


def shapes(data: dict[str, Any]) -> Iterator[Node]:
    """Every shape of every body and prefab."""
    for path, pattern in patterns(data):
        yield from children(pattern.get("shapes"), (*path, "shapes"))


def texts(value: object, path: Path) -> Iterator[tuple[Path, str]]:
    """A text, or the texts of a list."""
    if isinstance(value, str):
        yield path, value
    elif isinstance(value, (list, tuple)):
        yield from (((*path, i), entry) for i, entry in enumerate(value) if isinstance(entry, str))


def is_number(value: object) -> TypeGuard[float]:
    """Whether a value is a number a scene can have (true and false are none, nor is one past all limits)."""
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) <= 1e20
