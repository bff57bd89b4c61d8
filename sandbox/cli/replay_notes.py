"""Where GitHub shows what became of a recording: at the edit that is the cause, or at the step that differs."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from sandbox._bounded_read import is_regular
from sandbox.cli.annotations import Note, notes_of_error
from sandbox.cli.replay_messages import advice, reasons
from sandbox.errors import FileError
from sandbox.replay.golden.examine import Report
from sandbox.scene.excerpt import line_column
from sandbox.scene.locate import locate

_EDITED = re.compile(r"(.+?\.json):(\d+):\d+: ")


def replay_notes(reports: Sequence[Report]) -> Iterator[Note]:
    """A note for each report that is not fine, or for each mistake of a file that could not be used."""
    for report in reports:
        if report.problems:
            error = FileError(report.source, list(report.problems))
            yield from notes_of_error(report.case.replay, error, f"replay {report.verdict}")
        elif not report.fine:
            yield Note(*_place(report), f"replay {report.verdict}", "\n".join([*reasons(report), *advice(report)]))


def _place(report: Report) -> tuple[str, int]:
    """File and line: those of the edit that is the cause, if it is known."""
    cause = report.outcome.divergence.cause if report.outcome and report.outcome.divergence else None
    edited = _EDITED.match(cause.said[0]) if cause is not None and cause.kind in ("scene", "command") else None
    if edited is not None:
        return edited[1], int(edited[2])
    file = report.scene if report.verdict == "missing" else report.case.replay.as_posix()
    return file, _line(report)


def _line(report: Report) -> int:
    """The line of the fingerprint of the first step that differs; 0 if there is none."""
    if report.outcome is None or report.outcome.divergence is None or not is_regular(report.case.replay):
        return 0
    text = report.case.replay.read_text(encoding="utf-8")
    path = ("digests", max(report.outcome.divergence.step - 1, 0))
    return line_column(text, locate(text, [path])[path].value_span[0])[0]
