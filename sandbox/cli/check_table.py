"""How `sandbox check` looks to a person: a line a scene, the reasons below a failed one, and a summary."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from rich.text import Text

from sandbox._printable import printable, told
from sandbox.cli import failures
from sandbox.cli.annotations import Note, notes_of_error
from sandbox.cli.check_result import Result
from sandbox.cli.junit import JUnitCase

if TYPE_CHECKING:
    from rich.console import Console

    from sandbox.replay.expectations import Verdict

_STYLES = {"holds": "green", "failed": "bold red", "unusable": "bold red"}


class Table:
    """Prints results to `console` as they come, aligned for all `files`."""

    def __init__(self, console: Console, files: Sequence[Path]) -> None:
        self._console = console
        self._width = max(len("scene"), *(len(told(file)) for file in files))

    def head(self) -> None:
        """The line of column titles."""
        self._console.print(Text(self._row("scene", "steps", "ms/step", "digest") + "verdict", style="dim"))

    def show(self, result: Result) -> None:
        """The line of one file; reasons follow if it failed, or go to stderr if it could not be used."""
        run = result.run
        cells = (str(run.steps), f"{run.milliseconds:.3f}", run.digest) if run else ("-", "-", "-")
        line = Text(self._row(told(result.path), *cells))
        self._console.print(line.append(self._verdict(result), _STYLES[result.verdict]))
        for reason in reasons(result):
            self._console.print(Text(reason))
        if result.error is not None:
            sys.stdout.flush()
            failures.report(result.error)

    def summary(self, results: Sequence[Result], seconds: float) -> None:
        """One line over all files."""
        count = Counter(result.verdict for result in results)
        parts = [f"{count['holds']} hold"]
        parts += [f"{count['failed']} failed"] if count["failed"] else []
        parts += [f"{count['unusable']} could not be used"] if count["unusable"] else []
        steps = sum(result.run.steps for result in results if result.run)
        plural = "" if len(results) == 1 else "s"
        text = f"{len(results)} scene{plural}: {', '.join(parts)}; {steps} steps in {seconds:.1f} s"
        self._console.print(Text(text, style="bold"))

    def _row(self, name: str, steps: str, milliseconds: str, digest: str) -> str:
        return f"{name:<{self._width}}  {steps:>7}  {milliseconds:>8}  {digest:<16}  "

    def _verdict(self, result: Result) -> str:
        if result.verdict == "holds" and result.run is not None and not result.run.verdicts:
            return "holds (expects nothing)" if not result.run.unreached else "holds (nothing is expected so early)"
        if result.run is not None and result.run.holds and result.run.unreached:
            return f"holds ({result.run.unreached} not reached)"
        return result.verdict


def reasons(result: Result) -> list[str]:
    """Why a scene failed, in lines; empty if it did not."""
    run = result.run
    if run is None:
        return []
    lines = [_reason(result, verdict) for verdict in run.verdicts if not verdict.holds]
    if result.lacking:
        lines.append('  it expects nothing: say under "expect" what must hold, or leave out --require-expect')
    return lines + [f"  {body} was frozen at step {step}: its numbers went bad" for body, step in run.frozen]


def notes(results: Sequence[Result]) -> Iterator[Note]:
    """What GitHub shows beside the files: each expectation that failed at its line, each mistake at its own."""
    for result in results:
        title = f"check {result.verdict}"
        if result.error is not None:
            yield from notes_of_error(result.path, result.error, title)
        elif result.verdict == "failed":
            failed = [verdict for verdict in result.run.verdicts if not verdict.holds] if result.run else []
            for verdict in failed:
                yield Note(result.path.as_posix(), result.line(verdict), title, _outcome(verdict))
            rest = [reason.strip() for reason in reasons(result)[len(failed) :]]
            yield from (Note(result.path.as_posix(), 0, title, reason) for reason in rest)


def junit_case(result: Result) -> JUnitCase:
    """What a CI server is told of a file."""
    if result.run is None:
        return JUnitCase(result.path, 0.0, "error", result.verdict, str(result.error).split("\n"))
    seconds = result.run.steps * result.run.milliseconds / 1000.0
    if result.verdict == "holds":
        return JUnitCase(result.path, seconds)
    return JUnitCase(result.path, seconds, "failure", result.verdict, "\n".join(reasons(result)).split("\n"))


def _reason(result: Result, verdict: Verdict) -> str:
    return f"  {told(result.path)}:{result.line(verdict)}: {printable(result.text(verdict))}\n    {_outcome(verdict)}"


def _outcome(verdict: Verdict) -> str:
    return f"at step {verdict.step}: expected {verdict.expected}; got: {verdict.got}"
