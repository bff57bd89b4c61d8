"""`sandbox sweep`: one scene, many runs, each with other values; a row of a table for each."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING

import typer

from sandbox._printable import told
from sandbox.cli.document import print_document
from sandbox.cli.failures import FAILED, HOLDS
from sandbox.cli.options import takes, values_set
from sandbox.cli.sweep_options import SweepOptions, check_output, check_plot_file, check_set, varied
from sandbox.errors import SandboxError
from sandbox.resources import find_scene

if TYPE_CHECKING:
    from sandbox.sweeps.design import Design
    from sandbox.sweeps.plot import Plot
    from sandbox.sweeps.runners import Job
    from sandbox.sweeps.study import Outcome, Study
    from sandbox.sweeps.table import SweepTable


@takes(SweepOptions)
def sweep(options: SweepOptions) -> None:
    """Run a scene many times, each with other values, and write a table with a row for each run.

    The rows are in the order of the grid and the same, byte for byte, however many processes or machines ran them.
    A sweep that was ended goes on with --resume. A run that fails has the error as its status; the others go on.

    Exit code 0: all runs came to their end.
    Exit code 1: some failed.
    Exit code 2: the scene, or an option, could not be used.
    """
    if options.plot is not None:
        check_plot_file(options.plot, options.scene)
    start = time.perf_counter()
    table, plot = _read(options) if options.is_of_table else _run(options)
    if options.plot is not None and plot is not None:
        from sandbox.sweeps.plot import save_plot

        save_plot(table, plot, options.plot)
    failed = _count_failed(table)
    _tell(table, options, failed, time.perf_counter() - start)
    raise typer.Exit(FAILED if failed else HOLDS)


def _read(options: SweepOptions) -> tuple[SweepTable, Plot]:
    """A table that is there."""
    from sandbox.sweeps.table import read_table

    options.check_table()
    table = read_table(options.scene)
    numbers = [name for name in table.columns if table[name].dtype != object and name != "steps"]
    return table, _plot(options, table.columns[:1], numbers[1:] or numbers)


def _run(options: SweepOptions) -> tuple[SweepTable, Plot | None]:
    """Make all runs, and write the table."""
    from sandbox.cli.compiling import announce_compilation
    from sandbox.cli.opening import open_any
    from sandbox.sweeps.design import grid, sample
    from sandbox.sweeps.study import study_of
    from sandbox.sweeps.sweep import table_of

    if not options.vary:
        raise SandboxError("nothing varies; say what does, such as --vary gravity.1=-12:-2:6")
    vary, values = varied(options.vary), values_set(options.set)
    check_set(values, vary)
    check_output(options)
    design = grid(vary) if options.sample is None else sample(vary, options.sample, options.seed)
    file = find_scene(options.scene)
    scene = open_any(file, values)
    study = study_of(scene, design, options.steps, options.collect or [])
    plot = None
    if options.plot is not None:
        from sandbox.sweeps.plot import check_plot

        plot = _plot(options, design.paths, study.columns, scene.title or file.name)
        check_plot((*design.paths, *study.columns, "steps"), plot)
    announce_compilation()
    table = table_of(study, design, _with_journal(study, design, options, file.name))
    return table, plot


def _with_journal(study: Study, design: Design, options: SweepOptions, name: str) -> list[Outcome]:
    """All outcomes: those that an earlier sweep has left, and the others, which are run; the table is not yet there."""
    from sandbox.sweeps.journal import Journal, journal_of
    from sandbox.sweeps.sweep import table_of

    if options.output is None:
        return list(_progressing(study, list(enumerate(design.runs)), options, (name, 0)))
    journal = Journal(journal_of(options.output), study.fingerprint(design.runs), len(design.runs))
    done = journal.done() if options.resume else {}
    left = [(run, values) for run, values in enumerate(design.runs) if run not in done]
    with journal.writing(goes_on=bool(done)), _telling_how_to_go_on(done, len(design.runs)):
        for outcome in _progressing(study, left, options, (name, len(done))):
            journal.note(outcome)
            done[outcome.run] = outcome
    table_of(study, design, done.values()).save(options.output)
    journal.remove()
    return list(done.values())


@contextmanager
def _telling_how_to_go_on(done: Mapping[int, Outcome], runs: int) -> Iterator[None]:
    """Say what is kept, where runs are interrupted or fail all together."""
    try:
        yield
    except (KeyboardInterrupt, SystemExit, SandboxError):
        print(f"{len(done)} of {runs} runs are kept; --resume goes on with the others", file=sys.stderr)
        raise


def _progressing(study: Study, jobs: Sequence[Job], options: SweepOptions, begun: tuple[str, int]) -> Iterator[Outcome]:
    """Make runs and show how many are done; `begun` is the name of the scene, and how many were done before."""
    from rich.console import Console

    from sandbox.cli.pool import ended_by_sigterm
    from sandbox.cli.progress import SceneProgress
    from sandbox.sweeps.sweep import outcomes_of

    name, before = begun
    with ended_by_sigterm(), SceneProgress(Console(stderr=True), 1, "runs") as progress:
        progress.begin(name, before + len(jobs))
        progress.done(before)
        for done, outcome in enumerate(outcomes_of(study, jobs, options.scheduler or options.jobs or None), 1):
            yield outcome
            progress.done(before + done)


def _plot(options: SweepOptions, varied: Sequence[str], collected: Sequence[str], title: str = "") -> Plot:
    """What to draw: what was asked for, by default the last column that was collected over what varies."""
    from sandbox.sweeps.plot import Plot

    y = tuple(options.y or collected[-1:])
    if not y:
        raise SandboxError("--plot: nothing is collected that could be drawn; add --collect, such as energy")
    is_said = options.x or options.by or options.over
    over = options.over or ("" if is_said or len(varied) != 2 else varied[1])
    return Plot(options.x or varied[0], y, options.by or "", over, title, options.theme)


def _count_failed(table: SweepTable) -> int:
    return sum(status != "ok" for status in table["status"]) if "status" in table.columns else 0


def _tell(table: SweepTable, options: SweepOptions, failed: int, seconds: float) -> None:
    written = [path for path in (None if options.is_of_table else options.output, options.plot) if path is not None]
    if options.json:
        _print_document(table, options, failed, seconds)
        return
    if options.output is None and not options.is_of_table:
        sys.stdout.write(table.csv())
    plural = "run" if len(table) == 1 else "runs"
    words = f"{len(table)} {plural}"
    for path in written:
        print(f"{told(path)}: {words}")
    if failed:
        row = next(row for row in table.rows if row["status"] != "ok")
        print(f"{failed} of {len(table)} runs failed, the first with: {told(row['status'])}", file=sys.stderr)


def _print_document(table: SweepTable, options: SweepOptions, failed: int, seconds: float) -> None:
    files = {"output": options.output, "plot": options.plot}
    facts = {
        "seconds": round(seconds, 3),
        "scene": options.scene.as_posix(),
        **{name: path.as_posix() if path is not None else None for name, path in files.items()},
        "runs": len(table),
        "failed": failed,
        "columns": table.columns,
        "rows": table.rows,
    }
    print_document(facts, FAILED if failed else HOLDS)
