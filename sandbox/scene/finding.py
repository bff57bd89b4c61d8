"""A mistake before its place in the text is known."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import islice

from sandbox._printable import printable
from sandbox.errors import Problem

_CONSIDERED = 2000

Path = tuple[str | int, ...]
"""The way to a value in a scene: keys and indices, such as ("bodies", 3, "shapes", 0)."""


@dataclass(frozen=True)
class Finding:
    """A mistake at `path`; `on_key` points at the field's name rather than its value."""

    path: Path
    message: str
    hint: str = ""
    on_key: bool = False

    def problem(self, line: int = 0, column: int = 0, excerpt: str = "") -> Problem:
        """The mistake as the error carries it."""
        return Problem(printable(self.message), pointer(self.path), line, column, printable(self.hint), excerpt)


def pointer(path: Path) -> str:
    """The JSON pointer (RFC 6901) of a path."""
    return printable("".join("/" + str(part).replace("~", "~0").replace("/", "~1") for part in path))


def path_of(pointer: str) -> tuple[str, ...]:
    """The keys of a JSON pointer; indices stay text."""
    return tuple(part.replace("~1", "/").replace("~0", "~") for part in pointer.split("/")[1:])


def nearest(name: str, known: Iterable[str]) -> str | None:
    """The one of the `known` names that is most like `name`, if any is. In Python, a key may be anything."""
    by_folded = {candidate.casefold(): candidate for candidate in islice(known, _CONSIDERED)}
    near = difflib.get_close_matches(str(name)[:200].casefold(), by_folded, n=1, cutoff=0.6)
    return by_folded[near[0]] if near else None


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """The hint with the nearest of the `known` names, empty if none is near."""
    near = nearest(name, known)
    return f'did you mean "{near}"?' if near else ""


def quoted(name: str) -> str:
    """A name from a file in quotes, shortened if it is long."""
    return f'"{name}"' if len(name) <= 60 else f'"{name[:57]}..."'
