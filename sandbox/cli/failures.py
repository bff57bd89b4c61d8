"""The one place where an exception becomes text on stderr and an exit code."""

from __future__ import annotations

import errno
import os
import sys
import traceback
from contextlib import suppress
from dataclasses import asdict
from typing import Any

from sandbox._printable import printable, printable_lines
from sandbox.errors import FileError, Problem, SandboxError

HOLDS, FAILED, UNUSABLE, NOTHING, BUG = 0, 1, 2, 5, 70
"""Exit codes: all fine; something failed; the input cannot be used; nothing was found; a mistake of this program."""
UNREAD = 141
"""Whoever read what is printed has gone, as `head` does: 128 + SIGPIPE, as of all programs that print."""

_NO_ROOM = (errno.ENOSPC, errno.EFBIG)


class NothingToDoError(SandboxError):
    """Nothing of what was asked for is there."""


TRACEBACK_VARIABLE = "SANDBOX_TRACEBACK"


def report(error: Exception) -> int:
    """Tell the user on stderr what went wrong; the exit code to end with."""
    if os.environ.get(TRACEBACK_VARIABLE):
        traceback.print_exception(error)
    text, code = _told(error)
    if isinstance(error, FileError):
        _print_problems(error)
    else:
        _print_message(text)
    return code


def problems(error: Exception | None) -> list[dict[str, Any]]:
    """What kept a file from being used, as entries of a JSON document."""
    found = error.problems if isinstance(error, FileError) else [Problem(str(error))]
    return [asdict(problem) for problem in found]


def problems_of(error: Exception) -> list[dict[str, Any]]:
    """The same where no entry of the file is around it: each says of which file it is."""
    if isinstance(error, FileError):
        return [entry | {"source": entry["source"] or error.source} for entry in problems(error)]
    return problems(SandboxError(_told(error)[0]))


def exit_code_of(error: Exception) -> int:
    """What a command ends with that an error ended."""
    return _told(error)[1]


def _told(error: Exception) -> tuple[str, int]:
    """What is said of an error, and the exit code to end with."""
    if isinstance(error, SandboxError):
        return printable_lines(str(error)), NOTHING if isinstance(error, NothingToDoError) else UNUSABLE
    if isinstance(error, FileNotFoundError) and _current_folder_is_gone():
        return "the current folder has been deleted: change to one that is there, and try again", UNUSABLE
    if isinstance(error, OSError) and error.filename is not None:
        return printable(f"{error.filename}: {error.strerror}"), UNUSABLE
    if isinstance(error, OSError) and error.errno in _NO_ROOM:
        return f"the output could not be written: {error.strerror}", UNUSABLE
    return _bug_text(error), BUG


def _current_folder_is_gone() -> bool:
    try:
        os.getcwd()
    except FileNotFoundError:
        return True
    return False


def _bug_text(error: Exception) -> str:
    from sandbox._version import __version__

    frames = traceback.extract_tb(error.__traceback__)
    place = f" at {frames[-1].filename}:{frames[-1].lineno}" if frames else ""
    text = " ".join(f"{type(error).__name__}: {error}".split())
    more = "" if os.environ.get(TRACEBACK_VARIABLE) else f" Set {TRACEBACK_VARIABLE}=1 to see the traceback."
    return f"this is a bug in sandbox {__version__}: {text}{place}.{more}"


def _print_message(message: str) -> None:
    from rich.text import Text

    _print(Text.assemble(("sandbox: ", "bold red"), message))


def _print_problems(error: FileError) -> None:
    from rich.text import Text

    for problem in error.problems:
        head, *excerpt = FileError(error.source, [problem]).lines()
        text = Text(head)
        text.stylize("bold", 0, len(head) - len(head.partition(": ")[2]))
        for line in excerpt:
            text.append("\n" + line, style="cyan")
        _print(text)


def _print(text: object) -> None:
    from rich.console import Console

    with suppress(OSError):  # where stderr is full or closed nobody can be told, and the exit code says it
        Console(file=sys.stderr, soft_wrap=True, highlight=False).print(text)
