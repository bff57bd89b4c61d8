"""How `sandbox compare` looks to a person: a line a scene, what is wrong below it, and a summary."""

from __future__ import annotations

import math
import sys
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from rich.text import Text

from sandbox._printable import told
from sandbox.cli import failures
from sandbox.cli.compare_result import Result

if TYPE_CHECKING:
    from rich.console import Console

    from sandbox.reference.comparison_result import Comparison, Disagreement

_STYLES = {"agrees": "green", "disagrees": "bold red", "unusable": "bold red"}
_COLUMNS = (
    ("steps", 5), ("pairs", 8), ("agreed", 8), ("touch", 6), ("trapped", 7), ("disagreed", 9), ("missed", 6),
    ("depth m", 7), ("normal °", 8),
)  # fmt: skip
_SHOWN = 5


class Table:
    """Prints results to `console` as they come, aligned for all `files`."""

    def __init__(self, console: Console, files: Sequence[Path]) -> None:
        self._console = console
        self._width = max(len("scene"), *(len(told(file)) for file in files))

    def head(self) -> None:
        """The line of column titles."""
        self._console.print(Text(self._row("scene", [name for name, _ in _COLUMNS]) + "verdict", style="dim"))

    def show(self, result: Result) -> None:
        """The line of one file; what is wrong follows, or goes to stderr if the file could not be used."""
        line = Text(self._row(told(result.path), _cells(result.tally)))
        self._console.print(line.append(result.verdict, _STYLES[result.verdict]))
        for text, style in _remarks(result):
            self._console.print(Text("  " + text, style=style))
        if result.error is not None:
            sys.stdout.flush()
            failures.report(result.error)

    def summary(self, results: Sequence[Result], seconds: float) -> None:
        """One line over all files."""
        count = Counter(result.verdict for result in results)
        tallies = [result.tally for result in results if result.tally]
        parts = [f"{count['agrees']} agree"]
        parts += [f"{count['disagrees']} disagree"] if count["disagrees"] else []
        parts += [f"{count['unusable']} could not be used"] if count["unusable"] else []
        plural = "" if len(results) == 1 else "s"
        pairs, steps = sum(tally.pairs for tally in tallies), sum(tally.steps for tally in tallies)
        text = f"{len(results)} scene{plural}: {', '.join(parts)}; {pairs} pairs at {steps} steps in {seconds:.1f} s"
        self._console.print(Text(text, style="bold"))

    def _row(self, name: str, cells: Sequence[str]) -> str:
        aligned = (f"{cell:>{width}}  " for cell, (_, width) in zip(cells, _COLUMNS, strict=True))
        return f"{name:<{self._width}}  " + "".join(aligned)


def _cells(tally: Comparison | None) -> list[str]:
    if tally is None:
        return ["-"] * len(_COLUMNS)
    counts = (tally.steps, tally.pairs, tally.agreed, tally.touching, tally.pymunk_wrong.total(), tally.disagreed)
    worst = (tally.depth_error, math.degrees(tally.normal_error))
    return [str(count) for count in (*counts, tally.missed)] + [f"{value:.0e}" if value else "0" for value in worst]


def _remarks(result: Result) -> list[tuple[str, str]]:
    """Lines below that of a scene, each with its style."""
    tally = result.tally
    if tally is None:
        return []
    remarks = [
        (f"trapped: pymunk is wrong {count} times by {name!r}", "dim")
        for name, count in sorted(tally.pymunk_wrong.items())
    ]
    remarks += [(_tell(found), "") for found in tally.disagreements[:_SHOWN]]
    remarks += _more(tally.disagreed - _SHOWN, "disagreements")
    for miss in tally.misses[:_SHOWN]:
        remarks.append((f"step {miss.step}: the grid missed {miss.names[0]} and {miss.names[1]}", ""))
    remarks += _more(tally.missed - _SHOWN, "missed pairs")
    return remarks + [(f"saved {told(path)}", "dim") for path in result.saved[:_SHOWN]]


def _more(count: int, what: str) -> list[tuple[str, str]]:
    return [(f"and {count} more {what}; --json tells and --save keeps up to 100", "dim")] if count > 0 else []


def _tell(found: Disagreement) -> str:
    indent = "\n      "
    return (
        f"step {found.step}: {found.names[0]} and {found.names[1]} ({found.pair.kinds}), {found.what}:"
        f" {found.who_is_wrong} is wrong{indent}sandbox: {found.ours}{indent}pymunk:  {found.theirs}"
        f"{indent}exact:   {found.ruling.truth}"
    )
