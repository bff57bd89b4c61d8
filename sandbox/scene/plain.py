"""Reads plain data of a scene that may be wrong anywhere: what has the wrong type is passed over.

The rules between fields work on plain data, so that they find their mistakes in a file that has others too.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import Any, TypeGuard

from sandbox.scene.finding import Path
from sandbox.scene.limits import MAX_ACTIONS, MAX_CONTROLS, MAX_RULES, MAX_SHAPES

Node = tuple[Path, dict[str, Any]]
"""An object of the file and the path to it."""


SEVERAL = ("bodies", "joints", "generate")
"""What makes a prefab one of several bodies."""


def is_several(prefab: object) -> bool:
    """Whether a prefab has bodies, rather than being one."""
    return isinstance(prefab, dict) and any(key in prefab for key in SEVERAL)


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
    """Every body and prefab, those that rules and controls bring included."""
    yield from children(data.get("prefabs"), ("prefabs",))
    yield from entries(data)


def entries(data: dict[str, Any]) -> Iterator[Node]:
    """Every body, those that rules and controls bring included."""
    yield from children(data.get("bodies"), ("bodies",))
    yield from spawns(data)


def spawns(data: dict[str, Any]) -> Iterator[Node]:
    """Every body that rules and controls bring."""
    for path, action in actions(data):
        if isinstance(action.get("spawn"), dict):
            yield (*path, "spawn"), action["spawn"]


def actions(data: dict[str, Any]) -> Iterator[Node]:
    """Every action of every rule and control."""
    for path, rule in islice(children(data.get("rules"), ("rules",)), MAX_RULES):
        yield from islice(children(rule.get("do"), (*path, "do")), MAX_ACTIONS)
    for path, control in islice(children(data.get("controls"), ("controls",)), MAX_CONTROLS):
        for occasion in OCCASIONS:
            yield from islice(children(control.get(occasion), (*path, occasion)), MAX_ACTIONS)


OCCASIONS = ("press", "hold", "release")
"""When a control does something."""


def shapes(data: dict[str, Any]) -> Iterator[Node]:
    """Every shape of every pattern."""
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
