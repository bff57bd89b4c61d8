"""What a report says, in lines of text: the same on a terminal, in a JUnit file and in an annotation."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Literal

from sandbox._printable import told
from sandbox.cli.junit import JUnitCase
from sandbox.errors import FileError
from sandbox.replay.golden.divergence import Drift
from sandbox.replay.golden.examine import Report

SHOWN_DRIFTS = 3


def reasons(report: Report) -> list[str]:
    """Why a case did not pass, the most important first; if it did, what is to be known nevertheless."""
    if report.verdict == "missing":
        return [f"no recording of {told(report.scene)}"]
    if report.verdict == "orphaned":
        return [f"its scene {told(report.scene)} is gone"]
    if report.verdict == "unusable":
        bare = [replace(problem, excerpt="") for problem in report.problems]
        return FileError(report.source, bare).lines()
    outcome = report.outcome
    if outcome is None:
        return []
    if report.verdict == "passed":
        return list(outcome.notes)
    lines = [f"since it was recorded, {_some(outcome.edits, 5)}"] if outcome.edits else []
    if outcome.divergence is not None:
        lines += outcome.divergence.lines()
    elif outcome.edits:
        lines.append("all steps came out the same nevertheless")
    if outcome.drifts:
        lines.append(f"ended elsewhere: {', '.join(map(_end, outcome.drifts[:SHOWN_DRIFTS]))}")
    lines += [report.where] if report.where else []
    return [*lines, *outcome.notes]


def _end(drift: Drift) -> str:
    """Where a body ended, against where it was recorded; its turn, if that is what puts it among the first."""
    if drift.expected is None or drift.got is None:
        return f"{drift.body}, which is {'gone' if drift.got is None else 'new'}"
    turned = f" and {math.degrees(drift.turn):.3g} degrees" if drift.turn > drift.distance else ""
    return f"{drift.body} by {drift.distance:.3g} m{turned}"


def advice(report: Report) -> list[str]:
    """The commands that show the trouble and that accept it."""
    path, outcome = told(report.case.replay), report.outcome
    if report.fine or report.verdict == "unusable":
        return []
    if report.verdict == "missing":
        return [f"record it:  sandbox replay --update=missing {path}"]
    if report.verdict == "orphaned":
        return [f"remove it:  sandbox replay --prune {path}"]
    lines = []
    if outcome is not None and outcome.divergence is not None:
        lines.append(f"look at it: sandbox run {path} --step {max(outcome.divergence.step - 1, 0)}")
    return [*lines, f"accept it:  sandbox replay --update {path}"]


def junit_case(report: Report) -> JUnitCase:
    """What a CI server is told of a case."""
    path, seconds = report.case.replay, report.outcome.seconds if report.outcome else 0.0
    if report.fine:
        return JUnitCase(path, seconds)
    trouble: Literal["error", "failure"] = "error" if report.verdict == "unusable" else "failure"
    return JUnitCase(path, seconds, trouble, report.verdict, [*reasons(report), *advice(report)])


def _some(texts: tuple[str, ...], most: int) -> str:
    more = f" and {len(texts) - most} more" if len(texts) > most else ""
    return "; ".join(texts[:most]) + more
