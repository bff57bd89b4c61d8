"""What an author changed in a scene: each key with its place in the text of now, what it was and what it is."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from sandbox._printable import printable
from sandbox.scene.excerpt import line_column
from sandbox.scene.finding import Path
from sandbox.scene.locate import locate

MOST = 5
"""Edits that are told; of further ones only the number."""
_SILENT = {"title", "about", "$schema", "view", "expect"}
"""Members of a scene that move nothing; neither does a colour anywhere."""
_WIDTH = 60
_NOTHING = object()


@dataclass(frozen=True)
class Edit:
    """The value at `path` of the data of now was `old` and is `new`; `name` is the way to it as people write it."""

    path: Path
    name: str
    old: Any
    new: Any

    def __str__(self) -> str:
        if self.old is _NOTHING:
            return f"{self.name} is new: {_shown(self.new)}"
        if self.new is _NOTHING:
            return f"{self.name} was {_shown(self.old)} and is gone"
        return f"{self.name} was {_shown(self.old)} and is {_shown(self.new)}"


def edits_in_text(old: Any, new: Any, text: str, file: str, home: Path = ()) -> tuple[str, ...]:
    """`FILE:LINE:COLUMN: KEY was A and is B` for what differs in the data of two scenes.

    `text` holds the new one at the path `home`.
    """
    found = list(edits(old, new))
    paths = [(*home, *edit.path) for edit in found[:MOST]]
    places = locate(text, paths)
    told = []
    for path, edit in zip(paths, found, strict=False):
        line, column = line_column(text, places[path].value_span[0])
        told.append(f"{file}:{line}:{column}: {edit}")
    return (*told, f"and {len(found) - MOST} more") if len(found) > MOST else tuple(told)


def edits(old: Any, new: Any) -> Iterator[Edit]:
    """The values that differ in two scenes as plain data, in the order of the new one."""
    for key in dict.fromkeys([*new, *old]):
        if key not in _SILENT:
            yield from _differing((key,), str(key), old.get(key, _NOTHING), new.get(key, _NOTHING))


def _differing(path: Path, name: str, old: Any, new: Any) -> Iterator[Edit]:
    if isinstance(old, dict) and isinstance(new, dict):
        for key in dict.fromkeys([*new, *old]):
            yield from _differing((*path, key), f"{name}.{key}", old.get(key, _NOTHING), new.get(key, _NOTHING))
    elif _has_parts(old) and _has_parts(new):
        yield from _in_lists(path, name, old, new)
    elif old != new and path[-1] != "color":
        yield Edit(path, name, old, new)


def _in_lists(path: Path, name: str, old: list[Any], new: list[Any]) -> Iterator[Edit]:
    """Entries belong together by their ids, those without by their places."""
    before = {_id(entry, place): entry for place, entry in enumerate(old)}
    after = {_id(entry, place): (place, entry) for place, entry in enumerate(new)}
    for key, (place, entry) in after.items():
        yield from _differing((*path, place), f"{name}[{key}]", before.get(key, _NOTHING), entry)
    for key, entry in before.items():
        if key not in after:
            yield Edit(path, f"{name}[{key}]", entry, _NOTHING)


def _has_parts(value: Any) -> bool:
    """Lists of objects are looked into; rows of numbers are told as a whole."""
    return isinstance(value, list) and any(isinstance(entry, dict) for entry in value)


def _id(entry: Any, place: int) -> Any:
    named = isinstance(entry, dict) and isinstance(entry.get("id"), str)
    return entry["id"] if named else place


def _shown(value: Any) -> str:
    text = printable(json.dumps(value, ensure_ascii=False))
    return text if len(text) <= _WIDTH else text[: _WIDTH - 3] + "..."
