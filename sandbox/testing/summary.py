"""What the end of a test session tells about recordings. It travels with the reports, so that pytest-xdist keeps it."""

from __future__ import annotations

import json
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from sandbox.replay.golden.examine import Report

WRITTEN = "recordings written"
_KEY = "sandbox_written"
_JUDGED = "sandbox_judged"


def note_written(item: pytest.Item, path: str) -> None:
    """A test wrote a recording."""
    item.user_properties.append((_KEY, path))


def written_files(terminalreporter: Any) -> list[str]:
    """The recordings that were written in this session."""
    reports = [one for kind in ("passed", "failed") for one in terminalreporter.getreports(kind)]
    return sorted({str(value) for one in reports for key, value in one.user_properties if key == _KEY})


@dataclass(frozen=True)
class Judged:
    """The recording at `path` was judged: `fine`, or not. `made` is the file of what a test did itself, and `accept`
    says how to accept that.
    """

    path: str
    fine: bool
    made: str = ""
    accept: str = ""


def note_judged(item: pytest.Item, path: str, made: str = "", accept: str = "") -> None:
    """A test judges the recording at a path, against what stands in the file `made` if it is its own run."""
    item.user_properties.append((_JUDGED, json.dumps([path, made, accept])))


def judged_files(terminalreporter: Any) -> list[Judged]:
    """The recordings that were judged in this session, by path."""
    found: dict[str, Judged] = {}
    for kind in ("passed", "failed"):
        for one in terminalreporter.getreports(kind):
            for key, value in one.user_properties:
                if key == _JUDGED:
                    path, made, accept = json.loads(value)
                    found[path] = Judged(path, kind == "passed", made, accept)
    return [found[path] for path in sorted(found)]


def write_page(path: Path, judged: Sequence[Judged]) -> None:
    """The page of `sandbox replay --report`; what failed is judged once more for it. Raises `OSError`."""
    from sandbox.cli.replay_messages import reasons
    from sandbox.report.report_page import write_report
    from sandbox.report.section import Entry
    from sandbox.testing.verdict import mend

    begin = time.perf_counter()
    entries = []
    for one in judged:
        report = _report(one)
        entries.append(Entry(report, reasons(report), mend(report, one.accept)))
    write_report(path, entries, time.perf_counter() - begin)


def _report(one: Judged) -> Report:
    from sandbox.errors import FileError
    from sandbox.replay.golden.cases import Case, find_cases
    from sandbox.replay.golden.examine import ReplaySettings, Report, examine
    from sandbox.replay.recording.recording import Recording
    from sandbox.testing.own_replay import compare

    if one.fine:
        return Report(Case(Path(one.path)), "passed")
    if not one.made:
        return examine(find_cases([Path(one.path)])[0], ReplaySettings())
    try:
        return compare(Recording.load(one.made), Path(one.path), "")
    except FileError as error:
        return Report(Case(Path(one.path)), "unusable", source=error.source, problems=tuple(error.problems))
