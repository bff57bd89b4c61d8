"""`sandbox fmt`: lay scene files out anew."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

import typer

from sandbox._printable import told
from sandbox.cli.document import JSON, print_document
from sandbox.cli.failures import FAILED, HOLDS, UNUSABLE, problems
from sandbox.errors import SandboxError
from sandbox.resources import SCENE_SUFFIX

if TYPE_CHECKING:
    from collections.abc import Sequence

STDIN = Path("-")
_FILES = typer.Argument(
    metavar="FILE", help=f"Scene files, or folders to search for *{SCENE_SUFFIX}; - reads stdin and writes stdout."
)
_CHECK = typer.Option("--check", help="Write nothing: tell which files would change, and end with 1 if any would.")


class Result(NamedTuple):
    """What became of a file: whether its text changes, or the error that kept it from being read or written."""

    path: Path
    changes: bool = False
    error: Exception | None = None


def fmt(
    files: Annotated[list[Path], _FILES],
    check: Annotated[bool, _CHECK] = False,
    json: Annotated[bool, JSON] = False,
) -> None:
    """Lay scene files out anew: two spaces a level, 120 columns, short lists and objects on one line.

    Only white space changes: numbers and texts stay as they are written, and keys in their order. Line breaks between
    the fields of an object that is too long for one line stay where their author made them.

    Exit code 0: all are laid out so now; with --check: already were.
    Exit code 1: with --check, a file would change.
    Exit code 2: a file could not be used; the others were still laid out.
    """
    if STDIN in files:
        raise typer.Exit(_pass_through(files, check, json))
    from sandbox.cli.check import find_files

    results = [_result(file, check) for file in find_files(files, verb="lay out")]
    code = _exit_code(results, check)
    _print_document(results, code) if json else _print_lines(results, check)
    _report(results)
    raise typer.Exit(code)


def _pass_through(files: Sequence[Path], check: bool, json: bool) -> int:
    from sandbox.cli.output import put

    if len(files) > 1 or json:
        raise SandboxError("-: stdin is laid out alone, and to stdout: name no files beside it, and no --json")
    source = sys.stdin.buffer.read().decode("utf-8", "surrogateescape")
    text = _laid_out(source, "<stdin>")
    if not check:
        put(text, None)
    return FAILED if check and text != source else HOLDS


def _result(file: Path, check: bool) -> Result:
    from sandbox._atomic_write import write_text
    from sandbox.scene.read import read_text

    try:
        source = read_text(file)
        text = _laid_out(source, str(file))
        if text != source and not check:
            write_text(file, text)
        return Result(file, text != source)
    except (SandboxError, OSError) as error:
        return Result(file, error=error)


def _laid_out(source: str, name: str) -> str:
    from sandbox.scene.known_file import is_recording
    from sandbox.scene.layout import laid_out
    from sandbox.scene.parse import parse

    text = source.removeprefix("\ufeff")
    if is_recording(parse(text, name).data):
        raise SandboxError(f"{told(name)}: this is a recording, and recordings are laid out as they are written")
    return laid_out(text)


def _exit_code(results: Sequence[Result], check: bool) -> int:
    if any(result.error is not None for result in results):
        return UNUSABLE
    return FAILED if check and any(result.changes for result in results) else HOLDS


def _print_lines(results: Sequence[Result], check: bool) -> None:
    changed = [result for result in results if result.changes]
    for result in changed:
        typer.echo(f"{told(result.path)}: {'would change' if check else 'laid out anew'}")
    as_it_was = sum(not result.changes and result.error is None for result in results)
    typer.echo(f"{len(changed)} {'would change' if check else 'changed'}, {as_it_was} as they were")


def _print_document(results: Sequence[Result], code: int) -> None:
    entries = [_entry(result, problems(result.error) if result.error else None) for result in results]
    print_document({"files": entries}, code)


def _entry(result: Result, problems: list[dict[str, Any]] | None) -> dict[str, Any]:
    entry: dict[str, Any] = {"path": result.path.as_posix()}
    return {**entry, "problems": problems} if problems is not None else {**entry, "changes": result.changes}


def _report(results: Sequence[Result]) -> None:
    from sandbox.cli.failures import report

    for result in results:
        if result.error is not None:
            report(result.error)
