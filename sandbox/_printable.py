"""Text from outside (names of files, titles) as it goes to a terminal: no control characters, no breaks of lines."""

from __future__ import annotations

from pathlib import PurePath


def printable(text: str) -> str:
    """Text that any terminal can take: control characters and lone surrogates become question marks."""
    return text if text.isprintable() else "".join(c if c.isprintable() else "?" for c in text)


def printable_lines(text: str) -> str:
    """The same for a text of several lines."""
    return "\n".join(map(printable, text.split("\n")))


def told(path: str | PurePath) -> str:
    """A path on a terminal: in one line, with / on every system."""
    return printable(PurePath(path).as_posix())
