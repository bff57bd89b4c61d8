"""Where a value stands in the text of a JSON file.

Runs only when a place has to be shown, over text that `json` has accepted: it need not check the grammar. Only the
way to the values looked for is walked; everything beside it is skipped at the speed of the `json` module.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from dataclasses import dataclass, field

from sandbox.scene.finding import Path

_SPACE = re.compile(r"[ \t\n\r]*")
_TOKEN = re.compile(r'"[^"\\]*(?:\\.[^"\\]*)*"?|[{}\[\]]')
_DECODER = json.JSONDecoder(strict=False, parse_int=float)

Span = tuple[int, int]
"""First character and the one after the last, counted from 0."""


@dataclass(frozen=True)
class Place:
    """Where a value stands, and the key before it (a list's entry has none: its value instead)."""

    key_span: Span
    value_span: Span


@dataclass
class _Wanted:
    """A tree of the paths looked for; `found` is the place of the value at this path."""

    children: dict[str, _Wanted] = field(default_factory=dict)
    found: Place | None = None

    def forget(self) -> None:
        """A key given again replaces all that stood under it."""
        self.found = None
        for child in self.children.values():
            child.forget()


def locate(text: str, paths: Iterable[Path]) -> dict[Path, Place]:
    """The place of each path, or of its nearest ancestor that is there. A path's indices may be text."""
    paths = list(paths)
    root = _Wanted()
    for path in paths:
        node = root
        for part in path:
            node = node.children.setdefault(str(part), _Wanted())
    _read(text, _after_space(text, 0), root, None)
    return {path: _nearest(root, path) for path in paths}


def _nearest(root: _Wanted, path: Path) -> Place:
    node, best = root, root.found
    for part in path:
        node = node.children[str(part)]
        best = node.found or best
    return best or Place((0, 0), (0, 0))


def _read(text: str, start: int, wanted: _Wanted, key_span: Span | None) -> int:
    """Note where the value at `start` stands, and what is wanted in it; return its end."""
    if wanted.found:
        wanted.forget()
    container = text[start] in "{["
    end = start + 1 if container else _skip(text, start)
    wanted.found = Place(key_span or (start, end), (start, end))
    if not container:
        return end
    return _read_members(text, start, wanted) if wanted.children else _skip(text, start)


def _read_members(text: str, start: int, wanted: _Wanted) -> int:
    """Go through an object or list that begins at `start`; return its end."""
    is_object = text[start] == "{"
    position, index = _after_space(text, start + 1), 0
    while text[position] not in "}]":
        key, key_span = str(index), None
        if is_object:
            key, key_end = _DECODER.raw_decode(text, position)
            key_span = (position, key_end)
            position = _after_space(text, _after_space(text, key_end) + 1)
        child = wanted.children.get(key)
        position = _read(text, position, child, key_span) if child else _skip(text, position)
        position = _after_space(text, position)
        if text[position] == ",":
            position = _after_space(text, position + 1)
        index += 1
    return position + 1


def _skip(text: str, start: int) -> int:
    """The end of the value that begins at `start`."""
    return _DECODER.raw_decode(text, start)[1]


def _after_space(text: str, start: int) -> int:
    match = _SPACE.match(text, start)
    assert match is not None
    return match.end()


def too_deep(text: str, limit: int) -> Span | None:
    """The first object or list nested deeper than `limit`. Works on text of any depth."""
    depth = 0
    for match in _TOKEN.finditer(text):
        depth += (match.group() in "{[") - (match.group() in "}]")
        if depth > limit:
            return match.span()
    return None
