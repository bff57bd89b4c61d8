"""The work behind `sandbox replay`: find, run over processes, tell."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console

from sandbox._printable import told
from sandbox.cli.document import print_document
from sandbox.cli.failures import FAILED, HOLDS, UNUSABLE, NothingToDoError
from sandbox.cli.replay_options import ReplayOptions
from sandbox.cli.replay_result import facts
from sandbox.replay.golden.cases import Case, find_cases, shard
from sandbox.replay.golden.examine import ReplaySettings, Report

if TYPE_CHECKING:
    from sandbox.cli.against import Against


@dataclass(frozen=True)
class Work:
    """What the command line asked for, checked."""

    options: ReplayOptions
    settings: ReplaySettings
    part: tuple[int, int]
    """I and N of `--shard`."""


def run(work: Work) -> int:
    """Do it; the exit code. Raises `NothingToDoError`."""
    cases = _chosen(work)
    if not cases:
        raise NothingToDoError(_nothing(work))
    with _other_engine(work) as other:
        start = time.perf_counter()
        reports = (_run_for_machines if work.options.json else _run_for_people)(work, cases, other)
        seconds = time.perf_counter() - start
        _tell_others(work, reports, seconds, other)
        if work.options.json:  # last, for where a report cannot be written, the document says so instead
            print_document(facts(reports, seconds), exit_code(reports))
    return exit_code(reports)


def _other_engine(work: Work) -> AbstractContextManager[Against | None]:
    if not work.options.against:
        return nullcontext()
    from sandbox.cli.against import Against

    return Against(work.options.against, work.options.engine, work.options.no_jit)


def exit_code(reports: Sequence[Report]) -> int:
    """2 if a file could not be used, else 1 if something is left to be looked at, else 0."""
    if any(report.verdict == "unusable" for report in reports):
        return UNUSABLE
    return HOLDS if all(report.fine for report in reports) else FAILED


def _chosen(work: Work) -> list[Case]:
    from sandbox.cli.last_failed import only_failed

    cases = shard(find_cases(work.options.paths, work.options.only), *work.part)
    return only_failed(cases) if work.options.last_failed else cases


def _nothing(work: Work) -> str:
    where = ", ".join(told(path) for path in work.options.paths)
    if work.options.only:
        where += f" with {work.options.only!r} in the path"
    return f"nothing to replay: no recording, and no scene that expects something, in {where}"


def _run_for_people(work: Work, cases: Sequence[Case], other: Against | None) -> list[Report]:
    from sandbox.cli.replay_table import Table

    out = Console(soft_wrap=True, highlight=False)
    table = Table(out, cases)
    table.head()
    start = time.perf_counter()
    # On one terminal the bar and the lines must share a console, or they would overwrite each other.
    console = out if out.is_terminal else Console(stderr=True)
    reports = _run_all(_reports(work, cases, console, other), work, table.show)
    table.summary(reports, time.perf_counter() - start)
    return reports


def _run_for_machines(work: Work, cases: Sequence[Case], other: Against | None) -> list[Report]:
    return _run_all(_reports(work, cases, Console(stderr=True), other), work, _report_problems)


def _report_problems(report: Report) -> None:
    from sandbox.cli.replay_table import report_problems

    report_problems(report)


def _run_all(coming: Iterator[Report], work: Work, show: Callable[[Report], None]) -> list[Report]:
    from sandbox.cli.compiling import announce_compilation

    if not work.options.no_jit:
        announce_compilation()
    reports = []
    for report in coming:
        show(report)
        reports.append(report)
    return reports


def _reports(work: Work, cases: Sequence[Case], console: Console, other: Against | None) -> Iterator[Report]:
    if other is not None:
        return other.reports(cases, console)
    from sandbox.cli.replay_pool import reports_of

    return reports_of(cases, work.settings, work.options.jobs, work.options.no_jit, console)


def _tell_others(work: Work, reports: Sequence[Report], seconds: float, other: Against | None) -> None:
    """The report for a CI server, notes for GitHub, and the list for `--last-failed`."""
    from sandbox.cli.annotations import annotate
    from sandbox.cli.junit import write_junit
    from sandbox.cli.last_failed import remember
    from sandbox.cli.replay_messages import junit_case
    from sandbox.cli.replay_notes import replay_notes

    remember(reports)
    annotate(replay_notes(reports), to_stderr=work.options.json)
    if work.options.junit is not None:
        write_junit(work.options.junit, "sandbox replay", [junit_case(report) for report in reports], seconds)
    if work.options.report is not None:
        _write_page(work, work.options.report, reports, seconds, other)
        if not work.options.json:
            print(f"{told(work.options.report)}: a report, {work.options.report.stat().st_size / 1000:.0f} kB")


def _write_page(work: Work, path: Path, reports: Sequence[Report], seconds: float, other: Against | None) -> None:
    from sandbox.cli.compiling import announce_compilation
    from sandbox.cli.progress import SceneProgress
    from sandbox.cli.replay_messages import advice, reasons
    from sandbox.report.failure import failure_of
    from sandbox.report.report_page import write_report
    from sandbox.report.section import Entry

    if work.options.no_jit and not all(report.fine for report in reports):
        announce_compilation()  # films are made in this process
    entries = [Entry(report, reasons(report), advice(report)) for report in reports]
    failed = sum(not report.fine for report in reports)
    with SceneProgress(Console(stderr=True), failed) as progress:
        filming = failure_of if other is None else other.failure
        write_report(path, entries, seconds, lambda name: progress.begin(f"report: {name}", None), filming)
