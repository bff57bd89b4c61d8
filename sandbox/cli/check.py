"""`sandbox check`: run scenes headless and judge what they say must hold."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

import typer

from sandbox._bounded_read import read_ahead
from sandbox._printable import told
from sandbox.cli.check_options import CheckOptions
from sandbox.cli.failures import NothingToDoError
from sandbox.cli.options import takes, values_set
from sandbox.cli.output import check_report
from sandbox.resources import SCENE_SUFFIX, files_below, find_scene
from sandbox.scene.limits import MAX_BYTES


@takes(CheckOptions)
def check(options: CheckOptions) -> None:
    """Run scenes without a window and judge what each says must hold.

    A scene runs for its own number of steps, or on to the last step that its expectations name. With --steps N, what
    is expected later than step N is left open.

    Exit code 0: all hold.
    Exit code 1: an expectation failed, or bad numbers froze a body.
    Exit code 2: a file could not be used; the other scenes still ran.
    Exit code 5: there was none to run.
    """
    values = values_set(options.set)
    files = find_files(options.paths, options.only)
    check_report("--junit", options.junit, [".xml"], files)
    from sandbox.cli.check_result import exit_code
    from sandbox.cli.check_run import Work, run

    raise typer.Exit(exit_code(run(Work(files, options, values))))


def find_files(paths: Sequence[Path], only: str = "", verb: str = "check") -> list[Path]:
    """The scene files meant by `paths`, each once, in order. Raises `NothingToDoError` if there is none."""
    found = [file for path in paths for file in _files_of(path, verb)]
    files = [file for file in dict.fromkeys(found) if only in file.as_posix()]
    if not files:
        raise NothingToDoError(f"nothing to {verb}: no path contains {only!r}")
    return files


def _files_of(path: Path, verb: str) -> list[Path]:
    if not os.path.isdir(path):
        read_ahead(path, MAX_BYTES)
        return [find_scene(path)]
    files = files_below(path, SCENE_SUFFIX)
    if not files:
        raise NothingToDoError(f"nothing to {verb}: no *{SCENE_SUFFIX} in {told(path)} or below")
    return files
