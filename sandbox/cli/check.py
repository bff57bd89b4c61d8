"""`sandbox check`: run scenes headless and judge what they say must hold."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

import typer

from sandbox._printable import told
from sandbox.cli.import_options import open_any
from sandbox.cli.options import SET, WORKERS, values_set
from sandbox.errors import SandboxError
from sandbox.resources import SCENE_SUFFIX, files_below, find_scene

if TYPE_CHECKING:
    from rich.console import Console

    from sandbox.cli.check_result import Result
    from sandbox.cli.progress import SceneProgress

_PATHS = typer.Argument(
    metavar="PATH", help=f"Scenes, files that `import` takes, or folders to search for *{SCENE_SUFFIX}."
)
_STEPS = typer.Option(
    min=1,
    max=10_000_000,
    metavar="N",
    show_default=False,
    help="Steps to run instead of a scene's own number.",
)
_ONLY = typer.Option("-k", "--only", metavar="TEXT", show_default=False, help="Only files whose path contains TEXT.")
_JSON = typer.Option("--json", help="Print one JSON document instead of the table.")


def check(
    paths: Annotated[list[Path], _PATHS],
    steps: Annotated[int | None, _STEPS] = None,
    only: Annotated[str, _ONLY] = "",
    workers: Annotated[int, WORKERS] = 1,
    set: Annotated[list[str] | None, SET] = None,
    json: Annotated[bool, _JSON] = False,
) -> None:
    """Run scenes without a window and judge what each says must hold.

    A scene runs for its own number of steps, or on to the last step that its expectations name. With --steps N, what
    is expected later than step N is left open.

    Exit code 0: all hold.
    Exit code 1: an expectation failed, or bad numbers froze a body.
    Exit code 2: a file could not be used; the other scenes still ran.
    """
    values = values_set(set)
    files = find_files(paths, only)
    from sandbox.cli.check_result import exit_code
    from sandbox.cli.compiling import announce_compilation

    announce_compilation()
    work = Work(files, steps, workers, values)
    results = _run_for_machines(work) if json else _run_for_people(work)
    raise typer.Exit(exit_code(results))


class Work(NamedTuple):
    """What is to be run: `steps` instead of a scene's own number, by so many `workers`, with
    `values` for what the scenes say.
    """

    files: Sequence[Path]
    steps: int | None
    workers: int
    values: Mapping[str, Any]


def find_files(paths: Sequence[Path], only: str = "", verb: str = "check") -> list[Path]:
    """The scene files meant by `paths`, each once, in order. Raises `SandboxError` if there is nothing to `verb`."""
    found = [file for path in paths for file in _files_of(path, verb)]
    files = [file for file in dict.fromkeys(found) if only in file.as_posix()]
    if not files:
        raise SandboxError(f"nothing to {verb}: no path contains {only!r}")
    return files


def _files_of(path: Path, verb: str) -> list[Path]:
    if not path.is_dir():
        return [find_scene(path)]
    files = files_below(path, SCENE_SUFFIX)
    if not files:
        raise SandboxError(f"nothing to {verb}: no *{SCENE_SUFFIX} in {told(path)} or below")
    return files


def _run_for_people(work: Work) -> list[Result]:
    from rich.console import Console

    from sandbox.cli.check_table import Table

    out = Console(soft_wrap=True, highlight=False)
    table = Table(out, work.files)
    table.head()
    start = time.perf_counter()
    # On one terminal the bar and the lines must share a console, or they would overwrite each other.
    results = _run_all(work, out if out.is_terminal else Console(stderr=True), table.show)
    table.summary(results, time.perf_counter() - start)
    return results


def _run_for_machines(work: Work) -> list[Result]:
    import json

    from rich.console import Console

    from sandbox.cli.check_result import document

    start = time.perf_counter()
    results = _run_all(work, Console(stderr=True), _report_error)
    print(json.dumps(document(results, time.perf_counter() - start), indent=2, ensure_ascii=False))
    return results


def _report_error(result: Result) -> None:
    from sandbox.cli.failures import report

    if result.error is not None:
        report(result.error)


def _run_all(work: Work, console: Console, show: Callable[[Result], None]) -> list[Result]:
    from sandbox.cli.progress import SceneProgress

    results = []
    with SceneProgress(console, len(work.files)) as progress:
        for result in _results(work, progress):
            show(result)
            results.append(result)
    return results


def _results(work: Work, progress: SceneProgress) -> Iterator[Result]:
    from sandbox.cli.check_result import Result
    from sandbox.replay.headless_run import planned_steps, run_headless

    for file in work.files:
        try:
            scene = open_any(file, work.values)
            progress.begin(file.name, planned_steps(scene, work.steps))
            yield Result(file, scene, run_headless(scene, work.steps, progress.done, work.workers))
        except (SandboxError, OSError) as error:
            yield Result(file, error=error)
