"""`sandbox compare`: run scenes headless and hold every decision about a pair of shapes against pymunk.

With `--twin`, hold whole runs against pymunk or the simple solver instead.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from sandbox.cli.command import Command
from sandbox.cli.document import JSON, print_document
from sandbox.cli.options import SET, takes, values_set
from sandbox.errors import SandboxError
from sandbox.resources import SCENE_SUFFIX, find_scene

if TYPE_CHECKING:
    from rich.console import Console

    from sandbox.cli.compare_result import Result
    from sandbox.cli.progress import SceneProgress
    from sandbox.reference.others import TwinName

_PATHS = typer.Argument(metavar="PATH", help=f"Scene files, or folders to search for *{SCENE_SUFFIX}.")
_STEPS = typer.Option(
    min=1, max=10_000_000, metavar="N", show_default=False, help="Steps to run instead of a scene's own number."
)
_EVERY = typer.Option(min=1, metavar="N", help="Compare only every N-th step.")
_ONLY = typer.Option("-k", "--only", metavar="TEXT", show_default=False, help="Only files whose path contains TEXT.")
_SAVE = typer.Option(
    metavar="FOLDER", show_default=False, help="Write each disagreement into this folder as a test for pytest."
)
_TWIN = typer.Option(
    "--twin", metavar="[pymunk|simple]", show_default=False,
    help="Simulate the whole scene in pymunk (the default) or by the simple solver too, and show how they drift apart.",
)  # fmt: skip
_PLOT = typer.Option(metavar="FILE", show_default=False, help="With --twin: draw the curves into NAME.svg or NAME.png.")

TWINS: tuple[TwinName, ...] = ("pymunk", "simple")


class CommandClass(Command):
    """`--twin` takes the name of a twin where one follows, and else stands for `--twin=pymunk`."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Give a bare `--twin` its value."""
        end = args.index("--") if "--" in args else len(args)
        said: list[str] = []
        for k, arg in enumerate(args):
            bare = k < end and k > 0 and args[k - 1] == "--twin"
            if bare and (arg in TWINS or _is_misspelt(arg)):
                said[-1] = f"--twin={arg}"
            else:
                said.append("--twin=pymunk" if arg == "--twin" and k < end else arg)
        return super().parse_args(ctx, said)


def _is_misspelt(arg: str) -> bool:
    """Whether it looks like the name of a twin and is no path, nor the name of a shipped scene."""
    from sandbox.scene.near_names import nearest

    return nearest(arg, TWINS) is not None and not find_scene(Path(arg)).exists()


@dataclass(frozen=True)
class CompareOptions:
    """What `sandbox compare` was asked for."""

    paths: Annotated[list[Path], _PATHS]
    steps: Annotated[int | None, _STEPS] = None
    every: Annotated[int, _EVERY] = 1
    only: Annotated[str, _ONLY] = ""
    save: Annotated[Path | None, _SAVE] = None
    twin: Annotated[str, _TWIN] = ""
    plot: Annotated[Path | None, _PLOT] = None
    set: Annotated[list[str] | None, SET] = None
    json: Annotated[bool, JSON] = False


@takes(CompareOptions)
def compare(options: CompareOptions) -> None:
    """Run scenes without a window and ask pymunk about every pair of shapes whose boxes overlap, at every step.

    The pairs are found by looking at all of them, so one that the grid missed shows up. Where the two engines
    disagree, exact arithmetic decides; known errors of pymunk are counted by name.

    With --twin, run each scene a second time in other hands and compare energy, overlap and heights over time.

    Exit code 0: no disagreement and no missed pair.
    Exit code 1: there is one.
    Exit code 2: a file could not be used; the other scenes still ran.
    Exit code 5: there was none to compare.
    """
    from sandbox.cli.check import find_files
    from sandbox.cli.compiling import announce_compilation

    name, values = _twin_of(options.twin), values_set(options.set)
    _check_options(name is not None, options.plot, options.save)
    files = find_files(options.paths, options.only, "compare")
    announce_compilation()
    if name is not None:
        from sandbox.cli.compare_twin import Task, run_twins

        task = Task(name, options.steps, options.every, options.plot, values)
        raise typer.Exit(run_twins(files, task, options.json))
    from sandbox.cli.compare_result import exit_code

    run = _run_for_machines if options.json else _run_for_people
    raise typer.Exit(exit_code(run(files, options)))


def _twin_of(text: str) -> TwinName | None:
    """What `--twin` asks for; None without it. Raises `SandboxError` for a name that no twin has."""
    if not text:
        return None
    for twin in TWINS:
        if text == twin:
            return twin
    from sandbox.scene.near_names import did_you_mean

    raise SandboxError(f"--twin={text}: no twin of that name; {did_you_mean(text, TWINS) or 'pymunk or simple'}")


def _check_options(twin: bool, plot: Path | None, save: Path | None) -> None:
    if plot is not None and not twin:
        raise SandboxError("--plot draws the curves of --twin: give both")
    if save is not None and twin:
        raise SandboxError("--save writes disagreements on single pairs; --twin has none: give one of the two")
    if save is not None and save.exists() and not save.is_dir():
        raise SandboxError(f"{save}: not a folder; --save needs one to write into")


def _run_for_people(files: Sequence[Path], options: CompareOptions) -> list[Result]:
    from rich.console import Console

    from sandbox.cli.compare_table import Table

    out = Console(soft_wrap=True, highlight=False)
    table = Table(out, files)
    table.head()
    start = time.perf_counter()
    # On one terminal the bar and the lines must share a console, or they would overwrite each other.
    bar = out if out.is_terminal else Console(stderr=True)
    results = _run_all(files, options, bar, table.show)
    table.summary(results, time.perf_counter() - start)
    return results


def _run_for_machines(files: Sequence[Path], options: CompareOptions) -> list[Result]:
    from rich.console import Console

    from sandbox.cli.compare_result import exit_code, facts

    start = time.perf_counter()
    results = _run_all(files, options, Console(stderr=True), _report_error)
    print_document(facts(results, time.perf_counter() - start), exit_code(results))
    return results


def _report_error(result: Result) -> None:
    from sandbox.cli.failures import report

    if result.error is not None:
        report(result.error)


def _run_all(
    files: Sequence[Path], options: CompareOptions, console: Console, show: Callable[[Result], None]
) -> list[Result]:
    from sandbox.cli.progress import SceneProgress

    results = []
    with SceneProgress(console, len(files)) as progress:
        for result in _results(files, options, progress):
            show(result)
            results.append(result)
    return results


def _results(files: Sequence[Path], options: CompareOptions, progress: SceneProgress) -> Iterator[Result]:
    from sandbox.cli.compare_result import Result
    from sandbox.cli.opening import open_any
    from sandbox.reference.comparison import compare
    from sandbox.reference.regression import save_regressions
    from sandbox.scene.duration import planned_steps

    values, save = values_set(options.set), options.save
    for file in files:
        try:
            scene = open_any(file, values)
            total = planned_steps(scene) if options.steps is None else options.steps
            progress.begin(file.name, total)
            tally = compare(scene, total, options.every, progress.done)
            saved = save_regressions(scene, file, tally, save) if save is not None else []
            yield Result(file, scene, tally, saved)
        except (SandboxError, OSError) as error:
            yield Result(file, error=error)
