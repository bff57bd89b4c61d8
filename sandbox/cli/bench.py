"""`sandbox bench`: the same scene in several engines, side by side: speed, and quality beside it."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from sandbox._atomic_write import write_text
from sandbox.arguments import MOST_WORKERS
from sandbox.cli.document import JSON
from sandbox.cli.options import SET, takes, values_set
from sandbox.cli.output import FORCE, check_new, put
from sandbox.errors import MissingDependencyError, SandboxError

if TYPE_CHECKING:
    from rich.console import Console

    from sandbox.cli.bench_result import BenchResult
    from sandbox.cli.progress import SceneProgress

_SCENES = typer.Argument(
    metavar="SCENE", show_default=False,
    help="Scene files, or names of scenes that come with the package. \\[default: the benchmark scenes]",
)  # fmt: skip
_ENGINES = typer.Option(metavar="NAMES", help="Who takes part, of sandbox, pymunk and box2d (needs pyb2d3).")
_STEPS = typer.Option(
    min=1, max=10_000_000, metavar="N", show_default=False, help="Steps to run instead of a scene's own number."
)
_WORKERS = typer.Option(
    "--workers",
    metavar="N,...",
    help="Threads that share a step of ours: one after another takes part. \\[times: clock]",
)
_PROFILE = typer.Option("--profile", help="Show how long each part of our step takes.")
_OUTPUT = typer.Option(
    "-o", "--output", metavar="FILE", show_default=False,
    help="Write the JSON document there as well, anew after each scene.",
)  # fmt: skip


@dataclass(frozen=True)
class BenchOptions:
    """What `sandbox bench` was asked for."""

    scenes: Annotated[list[Path] | None, _SCENES] = None
    engines: Annotated[str, _ENGINES] = "sandbox,pymunk,box2d"
    steps: Annotated[int | None, _STEPS] = None
    workers: Annotated[str, _WORKERS] = "1"
    profile: Annotated[bool, _PROFILE] = False
    set: Annotated[list[str] | None, SET] = None
    json: Annotated[bool, JSON] = False
    output: Annotated[Path | None, _OUTPUT] = None
    force: Annotated[bool, FORCE] = False


@takes(BenchOptions)
def bench(options: BenchOptions) -> None:
    """Run scenes in several engines, a few steps each in turns, and tell who takes how long and how well it goes.

    Times are CPU times of this process, with several workers those of a clock; a step's is the median of ten turns.
    Ratio: our time over that engine's, the median of the turns' ratios; below 1 we are faster. Beside it: deepest
    overlap, energy of motion and bodies that have left where they belong, all at the end and measured by the same code.
    The first step is left out of the turns.

    Exit code 0: all scenes ran.
    Exit code 2: a scene or an option could not be used; the other scenes still ran.
    Exit code 5: none of the engines is installed.
    """
    from sandbox.cli.bench_result import exit_code
    from sandbox.cli.compiling import announce_compilation
    from sandbox.cli.failures import NothingToDoError

    files = _files(options.scenes or [])
    if options.output is not None:
        _check_document(options.output, options.force, files)
    wanted = _checked(options.engines)
    counts = _checked_workers(options.workers)
    engines = _with_workers(_installed(wanted), counts)
    if not engines:
        raise NothingToDoError(f"nothing to bench: none of {', '.join(wanted)} is installed")
    announce_compilation()
    run = _run_for_machines if options.json else _run_for_people
    raise typer.Exit(exit_code(run(files, engines, options)))


def _check_document(output: Path, force: bool, files: Sequence[Path]) -> None:
    """Raises `SandboxError` where the document would go over a scene or a recording, which `--force` hardly means."""
    from sandbox._printable import told
    from sandbox.replay.recording.limits import SUFFIX
    from sandbox.resources import SCENE_SUFFIX

    if output.name.endswith((SCENE_SUFFIX, SUFFIX)):
        raise SandboxError(f"{told(output)}: that is how scenes and recordings are named; name it such as bench.json")
    check_new(output, force, files)


def _checked(text: str) -> list[str]:
    from sandbox.bench.contestants import ENGINES
    from sandbox.scene.near_names import did_you_mean

    names = list(dict.fromkeys(name.strip() for name in text.split(",")))
    for name in names:
        if name not in ENGINES:
            known = did_you_mean(name, ENGINES) or f"there are {', '.join(ENGINES)}"
            raise SandboxError(f"--engines {text}: no engine has the name {name!r}; {known}")
    return names


def _checked_workers(text: str) -> list[int]:
    words = [word.strip() for word in text.split(",")]
    if not all(word.isdecimal() and 1 <= int(word) <= MOST_WORKERS for word in words):
        raise SandboxError(f"--workers {text}: takes numbers from 1 to {MOST_WORKERS} with commas between, as 1,2")
    return list(dict.fromkeys(map(int, words)))


def _with_workers(engines: Sequence[str], counts: Sequence[int]) -> list[str]:
    """The engines, ours once for each number of workers."""
    from sandbox.bench.contestants import with_workers

    return [each for name in engines for each in (map(with_workers, counts) if name == "sandbox" else [name])]


def _files(paths: Sequence[Path]) -> list[Path]:
    from sandbox.resources import benchmark_scenes, find_scene

    return list(dict.fromkeys(find_scene(path) for path in paths)) if paths else benchmark_scenes()


def _installed(names: Sequence[str]) -> list[str]:
    """Those `names` that can be used; the others are named on stderr."""
    import sys

    from sandbox.reference.box2d_run import require_pyb2d3

    missing = ""
    try:
        if "box2d" in names:
            require_pyb2d3()
    except MissingDependencyError as error:
        missing = "box2d"
        print(f"sandbox: {missing} is left out. {error}", file=sys.stderr)
    return [name for name in names if name != missing]


def _run_for_people(files: Sequence[Path], engines: Sequence[str], options: BenchOptions) -> list[BenchResult]:
    from rich.console import Console

    from sandbox.cli.bench_table import WIDTH, show

    out = Console(highlight=False)
    out.width = max(out.width, WIDTH)
    # On one terminal the bar and the table must share a console, or they would overwrite each other.
    bar = out if out.is_terminal else Console(stderr=True)
    results, _ = _run_all(files, engines, options, bar, lambda result: show(out, result))
    return results


def _run_for_machines(files: Sequence[Path], engines: Sequence[str], options: BenchOptions) -> list[BenchResult]:
    from rich.console import Console

    results, told = _run_all(files, engines, options, Console(stderr=True), _report_error)
    put(told, None)
    return results


def _report_error(result: BenchResult) -> None:
    from sandbox.cli.failures import report

    if result.error is not None:
        report(result.error)


def _run_all(
    files: Sequence[Path],
    engines: Sequence[str],
    options: BenchOptions,
    console: Console,
    show: Callable[[BenchResult], None],
) -> tuple[list[BenchResult], str]:
    """Run all scenes; returns what became of them, also as the JSON document."""
    from sandbox.cli.bench_result import text
    from sandbox.cli.progress import SceneProgress

    results: list[BenchResult] = []
    told = text(results, 0.0)
    start = time.perf_counter()
    with SceneProgress(console, len(files)) as progress:
        for result in _results(files, engines, options, progress):
            show(result)
            results.append(result)
            told = text(results, time.perf_counter() - start)
            if options.output is not None:  # a run of an hour may be interrupted
                write_text(options.output, told, over=options.force or len(results) > 1)
    return results, told


def _results(
    files: Sequence[Path], engines: Sequence[str], options: BenchOptions, progress: SceneProgress
) -> Iterator[BenchResult]:
    from sandbox.bench.course import Course
    from sandbox.bench.race import run_race
    from sandbox.cli.bench_result import BenchResult
    from sandbox.cli.opening import open_any
    from sandbox.resources import scene_name

    values = values_set(options.set)
    for file in files:
        try:
            scene = open_any(file, values)
            steps = scene.settings.steps if options.steps is None else options.steps
            progress.begin(file.name, steps)
            race = run_race(Course(scene, scene_name(file)), engines, steps, options.profile, progress.done)
            yield BenchResult(file, scene.title, race)
        except (SandboxError, OSError) as error:
            yield BenchResult(file, error=error)
