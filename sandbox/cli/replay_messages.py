"""What a report says, in lines of text: the same on a terminal, in a JUnit file and in an annotation."""

from __future__ import annotations

from typing import Literal

from sandbox._printable import told
from sandbox.cli.junit import JUnitCase
from sandbox.replay.golden.examine import Report

SHOWN_DRIFTS = 3


def reasons(report: Report) -> list[str]:
    """Why a case did not pass, the most important first; if it did, what is to be known nevertheless."""
    if report.verdict == "missing":
        return [f"no recording of {told(report.scene)}"]
    if report.verdict == "orphaned":
        return [f"its scene {told(report.scene)} is gone"]
    if report.verdict == "unusable":
        return [problem.message for problem in report.problems]
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
        ends = [f"{drift.body} by {drift.distance:.3g} m" for drift in outcome.drifts[:SHOWN_DRIFTS]]
        lines.append(f"ended elsewhere: {', '.join(ends)}")
    lines += [report.where] if report.where else []
    return [*lines, *outcome.notes]


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
