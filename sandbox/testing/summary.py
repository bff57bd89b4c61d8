"""What the end of a test session tells about recordings. It travels with the reports, so that pytest-xdist keeps it."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import pytest

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


def note_judged(item: pytest.Item, path: str) -> None:
    """A test judges the recording at a path."""
    item.user_properties.append((_JUDGED, path))


def judged_files(terminalreporter: Any) -> dict[str, bool]:
    """The recordings that were judged in this session, and whether they passed."""
    found: dict[str, bool] = {}
    for kind in ("passed", "failed"):
        for one in terminalreporter.getreports(kind):
            found |= {str(value): kind == "passed" for key, value in one.user_properties if key == _JUDGED}
    return dict(sorted(found.items()))


def write_page(path: Path, judged: dict[str, bool]) -> None:
    """The page of `sandbox replay --report`; what failed is judged once more for it. Raises `OSError`."""
    from sandbox.cli.replay_words import advice, reasons
    from sandbox.replay.golden.cases import Case, find_cases
    from sandbox.replay.golden.examine import Demands, Report, examine
    from sandbox.report.report_page import write_report
    from sandbox.report.section import Entry

    begin = time.perf_counter()
    reports = [
        Report(Case(Path(name)), "passed") if fine else examine(find_cases([Path(name)])[0], Demands())
        for name, fine in judged.items()
    ]
    write_report(path, [Entry(one, reasons(one), advice(one)) for one in reports], time.perf_counter() - begin)
