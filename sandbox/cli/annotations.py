"""Notes that GitHub shows beside the files of a pull request, where a run finds itself there."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator
from itertools import islice
from pathlib import Path
from typing import Literal, NamedTuple

from sandbox._printable import printable, printable_lines
from sandbox.errors import FileError

MOST = 10
"""GitHub shows no more of one step."""


class Note(NamedTuple):
    """A `text` for a `line` of a file, 0 for the file as a whole."""

    file: str
    line: int
    title: str
    text: str
    level: Literal["error", "warning"] = "error"


def annotate(notes: Iterable[Note], to_stderr: bool) -> None:
    """Print the first `MOST` of these; nothing outside of GitHub Actions."""
    if os.environ.get("GITHUB_ACTIONS") != "true":
        return
    for note in islice(notes, MOST):
        place = f",line={note.line}" if note.line else ""
        line = f"::{note.level} file={_property(_in_repository(note.file))}{place},title={_property(note.title)}"
        print(f"{line}::{_data(printable_lines(note.text))}", file=sys.stderr if to_stderr else sys.stdout)


def notes_of_error(file: Path, error: Exception, title: str) -> Iterator[Note]:
    """A note for each mistake that keeps a file from being used, where it is."""
    if not isinstance(error, FileError):
        yield Note(file.as_posix(), 0, title, str(error))
        return
    for problem in error.problems:
        text = f"{problem.message}: {problem.hint}" if problem.hint else problem.message
        yield Note(problem.source or error.source, problem.line, title, text)


def _in_repository(file: str) -> str:
    """The way to a file from the root of the repository, from where GitHub looks for it."""
    root = os.environ.get("GITHUB_WORKSPACE", "")
    path = os.path.abspath(file)
    inside = root and path.startswith(os.path.join(os.path.abspath(root), ""))
    return Path(os.path.relpath(path, root) if inside else file).as_posix()


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(printable(text)).replace(":", "%3A").replace(",", "%2C")
