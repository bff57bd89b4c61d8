"""A mistake before its place in the text is known."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox._printable import printable
from sandbox.errors import Problem

Path = tuple[str | int, ...]
"""The way to a value in a scene: keys and indices, such as ("bodies", 3, "shapes", 0)."""

COPIES = "copies"
"""Stands among what is lacking for the ids within prefabs: where one is given twice, all copies have it twice."""
TAKEN = "taken"
"""Stands there for ids that were meant otherwise: of two that are alike, one has the name of what is missed."""


@dataclass(frozen=True)
class Finding:
    """A mistake at `path`; `on_key` points at the field's name rather than its value, `within` at a part of a text.

    `lacks` are the fields that would declare what is not known: where these are wrong themselves, nothing is said.
    What is about a name is told `once`, however many places have it.
    """

    path: Path
    message: str
    hint: str = ""
    on_key: bool = False
    within: tuple[int, int] | None = None
    lacks: tuple[str, ...] = ()
    once: bool = False

    def problem(self, line: int = 0, column: int = 0, excerpt: str = "") -> Problem:
        """The mistake as the error carries it."""
        return Problem(printable(self.message), pointer(self.path), line, column, printable(self.hint), excerpt)


def pointer(path: Path) -> str:
    """The JSON pointer (RFC 6901) of a path."""
    return printable("".join("/" + str(part).replace("~", "~0").replace("/", "~1") for part in path))


def path_of(pointer: str) -> tuple[str, ...]:
    """The keys of a JSON pointer; indices stay text."""
    return tuple(part.replace("~1", "/").replace("~0", "~") for part in pointer.split("/")[1:])


def quoted(name: str) -> str:
    """A name from a file in quotes, shortened if it is long."""
    shown = printable(name if len(name) <= 60 else f"{name[:57]}...")
    return f'"{shown}"'
