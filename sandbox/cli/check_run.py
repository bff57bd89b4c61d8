"""The work behind `sandbox check`: run, over processes if that is asked for, and tell."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from rich.console import Console

from sandbox._printable import told
from sandbox.cli.check_options import CheckOptions
from sandbox.cli.check_result import Result, exit_code, facts
from sandbox.cli.document import print_document
from sandbox.cli.progress import SceneProgress
from sandbox.errors import CapacityError, SandboxError


class Work(NamedTuple):
    """What is to be run, as the options say, with `values` for what the scenes say."""

    files: Sequence[Path]
    options: CheckOptions
    values: Mapping[str, Any]


def run(work: Work) -> list[Result]:
    """What became of each of the files, in their order, told as it is asked for."""
    from sandbox.cli.annotations import annotate
    from sandbox.cli.check_table import notes
    from sandbox.cli.compiling import announce_compilation

    announce_compilation()
    start = time.perf_counter()
    results = (_for_machines if work.options.json else _for_people)(work)
    seconds = time.perf_counter() - start
    if work.options.junit is not None:
        _write_junit(work.options.junit, results, seconds)
    annotate(notes(results), to_stderr=work.options.json)
    if work.options.json:  # last, for where the report cannot be written, the document says so instead
        print_document(facts(results, seconds), exit_code(results))
    return results


def _for_people(work: Work) -> list[Result]:
    from sandbox.cli.check_table import Table

    out = Console(soft_wrap=True, highlight=False)
    table = Table(out, work.files)
    table.head()
    start = time.perf_counter()
    # On one terminal the bar and the lines must share a console, or they would overwrite each other.
    console = out if out.is_terminal else Console(stderr=True)
    results = _shown(_results(work, console), table.show)
    table.summary(results, time.perf_counter() - start)
    return results


def _for_machines(work: Work) -> list[Result]:
    return _shown(_results(work, Console(stderr=True)), _report_error)


def _report_error(result: Result) -> None:
    from sandbox.cli.failures import report

    if result.error is not None:
        report(result.error)


def _shown(coming: Iterator[Result], show: Callable[[Result], None]) -> list[Result]:
    results = []
    for result in coming:
        show(result)
        results.append(result)
    return results


def _results(work: Work, console: Console) -> Iterator[Result]:
    """In this process for one job, else in others."""
    files = work.files
    jobs = min(work.options.jobs or os.cpu_count() or 1, len(files))
    examine = partial(examined, options=work.options, values=work.values)
    if jobs == 1:
        with SceneProgress(console, len(files)) as progress:
            yield from (examine(file, progress=progress) for file in files)
        return
    from sandbox.cli.pool import elsewhere
    from sandbox.engine.compile_first import compile_first

    with SceneProgress(console, 1, "files") as progress:
        progress.begin("scenes", len(files))
        compile_first()
        for done, result in enumerate(elsewhere(examine, files, jobs), 1):
            progress.done(done)
            yield result


def examined(
    file: Path, options: CheckOptions, values: Mapping[str, Any], progress: SceneProgress | None = None
) -> Result:
    """One scene, run and judged."""
    from sandbox.cli.opening import open_any
    from sandbox.replay.headless_run import run_headless
    from sandbox.scene.duration import planned_steps

    try:
        scene = open_any(file, values)
        if progress is not None:
            progress.begin(file.name, planned_steps(scene, options.steps))
        on_steps = progress.done if progress is not None else None
        outcome = run_headless(scene, options.steps, on_steps, options.workers)
        return Result(file, scene, outcome, lacking=options.require_expect and not scene.expect)
    except CapacityError as error:
        return Result(file, error=SandboxError(f"{told(file)}: {error}"))
    except (SandboxError, OSError) as error:
        return Result(file, error=error)


def _write_junit(path: Path, results: Sequence[Result], seconds: float) -> None:
    from sandbox.cli.check_table import junit_case
    from sandbox.cli.junit import write_junit

    write_junit(path, "sandbox check", [junit_case(result) for result in results], seconds)
