"""Where a command writes a text that it makes: to a file, or to stdout."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Sequence
from io import TextIOWrapper
from pathlib import Path

import typer

from sandbox._atomic_write import check_writable, write_text
from sandbox._printable import told
from sandbox.errors import SandboxError

OUTPUT = typer.Option("-o", "--output", metavar="FILE", show_default=False, help="Write it there instead of printing.")
FORCE = typer.Option("--force", help="Write over a file that is there.")


def check_new(path: Path, force: bool, sources: Iterable[Path]) -> None:
    """Raises `SandboxError` if there is a file at `path` and `force` is not given, or if it is one of the `sources`,
    which not even `force` writes over; `OSError` if none can be written.

    Nothing is lost in a pipe or a device, and a folder stays whatever is forced.
    """
    is_no_file = path.exists() and not path.is_file()
    if os.path.lexists(path) and not is_no_file:
        check_not_source(path, sources)
        if not force:
            raise SandboxError(f"{told(path)}: there is a file of that name already; --force writes over it")
    check_writable(path)


def check_not_source(path: Path, sources: Iterable[Path]) -> None:
    """Raises `SandboxError` if what is written would take the place of what it is made of, by whatever name."""
    if any(_is_same_file(path, source) for source in sources):
        raise SandboxError(f"{told(path)}: it would go over what it is made of; give it another name")


def _is_same_file(one: Path, other: Path) -> bool:
    """Whether both are there and are the same file, by whatever names and links."""
    try:
        return os.path.samefile(one, other)
    except (OSError, ValueError):
        return False


def check_report(option: str, path: Path | None, suffixes: Sequence[str], sources: Iterable[Path]) -> None:
    """Raises `SandboxError` if a report that an option asks for ends in none of these, so that none goes over a scene
    or a recording, or if it is one of the `sources`, and `OSError` if it cannot be written."""
    if path is None:
        return
    if path.suffix.lower() not in suffixes:
        raise SandboxError(f"{option} {told(path)}: the name must end in {suffixes[0]}")
    check_not_source(path, sources)
    check_writable(path)


def put(text: str, output: Path | None, over: bool = True) -> None:
    """Write `text` to a file, with `over` also to one that is there, or print it. Raises `OSError`."""
    if output is not None:
        write_text(output, text, over)
        return
    if isinstance(sys.stdout, TextIOWrapper):  # names of files may hold what no encoding has bytes for
        sys.stdout.reconfigure(encoding="utf-8", errors=sys.stdout.errors)
    sys.stdout.write(text)
