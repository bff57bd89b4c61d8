"""A file, or what came from Python, as plain data that remembers where it stands."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path as FilePath
from typing import Any

from sandbox.scene.authoring.mistake import MARK
from sandbox.scene.finding import Finding, Path


@dataclass(frozen=True, eq=False)
class Document:
    """Plain `data`, the `text` that it was read from (None from Python) and the `source` that messages name.

    `file` is where it was read from, if includes may be looked for beside it. `changed` are the paths that were set
    from outside, with the words in which that was done; `repeats` are keys that are given twice.
    """

    source: str
    data: Any
    text: str | None = None
    file: FilePath | None = None
    changed: Mapping[Path, str] = field(default_factory=dict)
    repeats: Sequence[Finding] = ()

    @cached_property
    def calculates(self) -> bool:
        """Whether there can be expressions in it."""
        if self.text is None or self.changed:
            return True
        return f'"{MARK}' in self.text or "\\u003d" in self.text.lower()

    def value(self, path: Path) -> Any:
        """What stands at a path; None if nothing does."""
        node = self.data
        for part in path:
            try:
                node = node[part]
            except (KeyError, IndexError, TypeError):
                return None
        return node


@dataclass(frozen=True)
class Fault:
    """A mistake and the document it is in."""

    document: Document
    finding: Finding


@dataclass(frozen=True)
class Written:
    """A value where it was written."""

    document: Document
    path: Path
    value: Any

    def at(self, *parts: str | int) -> Written:
        """What stands in it, if anything does."""
        path = (*self.path, *parts)
        node = self.value
        for part in parts:
            try:
                node = node[part]
            except (KeyError, IndexError, TypeError):
                node = None
        return Written(self.document, path, node)

    def fault(self, message: str, hint: str = "", on_key: bool = False) -> Fault:
        """A mistake at this place."""
        return Fault(self.document, Finding(self.path, message, hint, on_key))
