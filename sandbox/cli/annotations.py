"""Notes that GitHub shows beside the files of a pull request, where a run finds itself there."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Sequence

from sandbox._bounded_read import is_regular
from sandbox.cli.replay_messages import advice, reasons
from sandbox.replay.golden.examine import Report
from sandbox.scene.excerpt import line_column
from sandbox.scene.locate import locate

_EDITED = re.compile(r"(.+?\.json):(\d+):\d+: ")

MOST = 10
"""GitHub shows no more of one step."""


def annotate(reports: Sequence[Report], to_stderr: bool) -> None:
    """Print a note for each report that is not fine, the first `MOST` of them; nothing outside of GitHub Actions."""
    if os.environ.get("GITHUB_ACTIONS") != "true":
        return
    for report in [report for report in reports if not report.fine][:MOST]:
        print(_note(report), file=sys.stderr if to_stderr else sys.stdout)


def _note(report: Report) -> str:
    file, line = _place(report)
    place = f",line={line}" if line else ""
    title = f"replay {report.verdict}"
    text = "\n".join([*reasons(report), *advice(report)])
    return f"::error file={_property(file)}{place},title={_property(title)}::{_data(text)}"


def _place(report: Report) -> tuple[str, int]:
    """File and line: those of the edit that is the cause, if it is known."""
    cause = report.outcome.divergence.cause if report.outcome and report.outcome.divergence else None
    edited = _EDITED.match(cause.said[0]) if cause is not None and cause.kind in ("scene", "command") else None
    if edited is not None:
        return edited[1], int(edited[2])
    file = report.scene if report.verdict == "missing" else report.case.replay.as_posix()
    return file, _line(report)


def _line(report: Report) -> int:
    """The line of the mistake, or of the fingerprint of the first step that differs; 0 if there is none."""
    if report.problems:
        return report.problems[0].line
    if report.outcome is None or report.outcome.divergence is None or not is_regular(report.case.replay):
        return 0
    text = report.case.replay.read_text(encoding="utf-8")
    path = ("digests", max(report.outcome.divergence.step - 1, 0))
    return line_column(text, locate(text, [path])[path].value_span[0])[0]


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
