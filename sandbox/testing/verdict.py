"""A report of a recording as the text of a failed test."""

from __future__ import annotations

from sandbox._printable import told
from sandbox.cli.replay_messages import advice, reasons
from sandbox.errors import FileError
from sandbox.replay.golden.examine import Report


def verdict(report: Report, accept: str = "") -> str:
    """Verdict, reasons, and the commands that show it and accept it; `accept` says how, if it is another way."""
    if report.problems:
        return "\n".join(FileError(report.source, list(report.problems)).lines())
    lines = [*reasons(report), *mend(report, accept)]
    return "\n".join([f"{told(report.case.replay)}: {report.verdict}", *(f"  {line}" for line in lines)])


def mend(report: Report, accept: str = "") -> list[str]:
    """The commands that show the trouble and accept it; `accept` says how, if it is another way."""
    told = [line for line in advice(report) if not (accept and line.startswith(("accept it", "record it")))]
    return [*told, accept] if accept and not report.fine else told
