"""How `sandbox bench` looks to a person: a table a scene, a line an engine."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from rich.table import Table
from rich.text import Text

from sandbox._printable import printable
from sandbox.cli import failures
from sandbox.resources import scene_name

if TYPE_CHECKING:
    from rich.console import Console

    from sandbox.bench.race import Race, Result
    from sandbox.cli.bench_result import BenchResult

_COLUMNS = ("build ms", "first ms", "step ms", "ratio", "overlap mm", "energy J", "escaped")
WIDTH = 100
"""What the table needs: on a narrower terminal, wrapped lines are better than cut numbers."""


def show(console: Console, result: BenchResult) -> None:
    """The table of one scene; or, on stderr, why it could not be used."""
    if result.race is None:
        sys.stdout.flush()
        if result.error is not None:
            failures.report(result.error)
        return
    console.print(_head(printable(scene_name(result.path)), result.race), soft_wrap=True)
    console.print(_table(result.race))
    for line in _below(result.race):
        console.print(Text(line, style="dim"), soft_wrap=True)
    console.print()


def _head(name: str, race: Race) -> Text:
    own = next((each.own for each in race.results if each.own), None)
    parts = [_count(race.bodies, "body", "bodies"), _count(race.shapes, "shape"), _count(race.joints, "joint")]
    parts += [_count(own.contacts, "contact")] if own else []
    parts.append(_count(race.steps, "step"))
    return Text.assemble((name, "bold"), "  ", ", ".join(parts))


def _count(number: int, one: str, many: str = "") -> str:
    return f"{number:,} {one if number == 1 else many or one + 's'}"


def _table(race: Race) -> Table:
    table = Table(box=None, pad_edge=False, header_style="dim", padding=(0, 2, 0, 0))
    table.add_column("", no_wrap=True, min_width=24)
    for name in _COLUMNS:
        table.add_column(name, justify="right", no_wrap=True, min_width=7)
    for result in race.results:
        table.add_row(result.label, *_cells(result))
    return table


def _cells(result: Result) -> list[str]:
    quality = result.quality
    return [
        f"{result.build:.1f}",
        f"{result.first:.2f}",
        "-" if result.step is None else f"{result.step:.3f}",
        "-" if result.ratio is None or result.name == "sandbox" else f"{result.ratio:.2f}",
        f"{1e3 * quality.deepest:.2f}",
        f"{quality.kinetic:.3g}",
        "-" if quality.escaped is None else str(quality.escaped),
    ]


def _below(race: Race) -> list[str]:
    lines = [f"  {each.label}: {note}" for each in race.results for note in each.notes]
    lines += [
        f"  {each.label}: what is changed between steps takes {each.changes:.3f} ms a step of the turns"
        for each in race.results
        if each.changes
    ]
    lines += [
        f"  {each.label}: the numbers of {_count(each.quality.lost, 'body', 'bodies')} are none"
        for each in race.results
        if each.quality.lost
    ]
    for label, own in ((each.label, each.own) for each in race.results if each.own):
        frozen = f", {own.frozen} frozen" if own.frozen else ""
        memory = f"tables {own.table_bytes / 2**20:.1f} MiB"
        lines.append(f"  {label}: digest {own.digest}, {own.awake:,} awake{frozen}, {memory}")
        if own.stages:
            told = ", ".join(f"{name} {milliseconds:.3f}" for name, milliseconds in own.stages.items())
            lines.append(f"  {label}, ms a step: {told}")
    return lines
