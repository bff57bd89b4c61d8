"""How `sandbox replay` looks to a person: a line a recording, the reasons below, and a summary."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Sequence

from rich.console import Console
from rich.text import Text

from sandbox._printable import told
from sandbox.cli import failures
from sandbox.cli.replay_messages import advice, reasons
from sandbox.errors import FileError
from sandbox.replay.golden.cases import Case
from sandbox.replay.golden.examine import Report


class Table:
    """Prints reports to `console` as they come, aligned for all `cases`."""

    def __init__(self, console: Console, cases: Sequence[Case]) -> None:
        self._console = console
        self._width = max(len("recording"), *(len(told(case.replay)) for case in cases))

    def head(self) -> None:
        """The line of column titles."""
        self._console.print(Text(self._row("recording", "steps", "seconds") + "verdict", style="dim"))

    def show(self, report: Report) -> None:
        """The line of one case; reasons follow if it did not pass, or go to stderr if it could not be used."""
        outcome = report.outcome
        cells = (str(outcome.steps), f"{outcome.seconds:.2f}") if outcome else ("-", "-")
        line = Text(self._row(told(report.case.replay), *cells))
        done = f" ({report.action})" if report.action else ""
        self._console.print(line.append(report.verdict + done, "green" if report.fine else "bold red"))
        if report.verdict == "unusable":
            sys.stdout.flush()
            report_problems(report)
            return
        for reason in [] if report.action else [*reasons(report), *advice(report)]:
            self._console.print(Text(f"  {reason}"))

    def summary(self, reports: Sequence[Report], seconds: float) -> None:
        """One line over all."""
        count = Counter[str](report.verdict for report in reports)
        parts = [f"{count[word]} {word}" for word in ("passed", *_TROUBLES) if count[word] or word == "passed"]
        done = Counter(report.action for report in reports if report.action)
        parts += [f"{number} {action}" for action, number in sorted(done.items())]
        steps = sum(report.outcome.steps for report in reports if report.outcome)
        plural = "" if len(reports) == 1 else "s"
        text = f"{len(reports)} replay{plural}: {', '.join(parts)}; {steps} steps in {seconds:.1f} s"
        self._console.print(Text(text, style="bold"))

    def _row(self, name: str, steps: str, seconds: str) -> str:
        return f"{name:<{self._width}}  {steps:>7}  {seconds:>7}  "


_TROUBLES = ("diverged", "stale", "missing", "orphaned", "unusable")


def report_problems(report: Report) -> None:
    """Tell on stderr what kept a file from being used; nothing for others."""
    if report.problems:
        failures.report(FileError(report.source, list(report.problems)))
