"""Where a value stands in the text of a JSON file.

Runs only when a mistake has to be shown, over text that `json` has accepted: it need not check the grammar.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any

from sandbox.scene.finding import Path

_TOKEN = re.compile(r'"[^"\\]*(?:\\.[^"\\]*)*"|[{}\[\]:,]|[^\s{}\[\]:,"]+')

Span = tuple[int, int]
"""First character and the one after the last, counted from 0."""


@dataclass(frozen=True)
class Place:
    """A value in the text: its depth, the key or index it stands under, and the spans of both."""

    depth: int
    key: str | int | None
    key_span: Span
    value_span: Span
    opens: bool


@dataclass
class _Frame:
    """An object or list being read; `key` is None where an object's next key is due."""

    is_object: bool
    key: str | int | None
    key_span: Span = (0, 0)


def places(text: str) -> Iterator[Place]:
    """Every value of a JSON text in the order of the text; an object or list comes before what is in it."""
    stack: list[_Frame] = []
    for match in _TOKEN.finditer(text):
        token, span = match.group(), match.span()
        frame = stack[-1] if stack else None
        if token in "]}":
            stack.pop()
        elif token == ",":
            assert frame is not None
            frame.key = None if frame.is_object else int(frame.key or 0) + 1
        elif frame is not None and frame.is_object and frame.key is None:
            frame.key, frame.key_span = json.loads(token, strict=False), span
        elif token != ":":
            key, key_span = (frame.key, frame.key_span) if frame else (None, span)
            yield Place(len(stack), key, key_span if frame and frame.is_object else span, span, token in "{[")
            if token in "{[":
                stack.append(_Frame(token == "{", None if token == "{" else 0))


@dataclass
class _Wanted:
    """A tree of the paths looked for; `found` is the last value read at this path."""

    children: dict[str, _Wanted] = field(default_factory=dict)
    found: Place | None = None


def locate(text: str, paths: Iterable[Path]) -> dict[Path, Place]:
    """The place of each path, or of its nearest ancestor that is there. A path's indices may be text."""
    paths = list(paths)
    root = _Wanted()
    for path in paths:
        node = root
        for part in path:
            node = node.children.setdefault(str(part), _Wanted())
    _search(text, root)
    return {path: _nearest(root, path) for path in paths}


def _search(text: str, root: _Wanted) -> None:
    way: list[_Wanted | None] = []
    for place in places(text):
        del way[place.depth :]
        parent = way[-1] if way else None
        node = root if place.depth == 0 else parent.children.get(str(place.key)) if parent else None
        way.append(node)
        if node is not None:
            node.found = place


def _nearest(root: _Wanted, path: Path) -> Place:
    node, best = root, root.found
    for part in path:
        node = node.children[str(part)]
        best = node.found or best
    return best or Place(0, None, (0, 0), (0, 0), False)


def duplicate_keys(text: str) -> list[tuple[Path, Span]]:
    """Path and key span of every key that stands twice in one object."""
    way: list[Any] = []
    seen: list[set[str]] = []
    repeated: list[tuple[Path, Span]] = []
    for place in places(text):
        del way[place.depth :], seen[place.depth :]
        way.append(place.key)
        seen.append(set())
        if isinstance(place.key, str):
            if place.key in seen[-2]:
                repeated.append((tuple(way[1:]), place.key_span))
            seen[-2].add(place.key)
    return repeated


def too_deep(text: str, limit: int) -> Span | None:
    """The first object or list nested deeper than `limit`. Works on text of any depth."""
    depth = 0
    for match in _TOKEN.finditer(text):
        depth += (match.group() in "{[") - (match.group() in "}]")
        if depth > limit:
            return match.span()
    return None
