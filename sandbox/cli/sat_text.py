"""How `sandbox sat` prints: a row an axis, then the verdict in words."""

from __future__ import annotations

from collections.abc import Sequence

from sandbox.cli.sat_pair import SatPair
from sandbox.geometry.sat_rows import SatRow
from sandbox.geometry.sat_table import SatTable
from sandbox.render.number_text import metres, plain, point
from sandbox.render.sat_labels import axis_name, headline, way_out

_TITLES = ("", "amax", "amin", "bmax", "bmin", "gap")


def report(pair: SatPair, table: SatTable, wide: bool) -> list[str]:
    """The table, and what follows from it; `wide` also tells where each axis comes from."""
    lines = [pair.note, ""] if pair.note else []
    return [*lines, *table_lines(pair, table, wide), "", *verdict(pair, table)]


def table_lines(pair: SatPair, table: SatTable, wide: bool = False) -> list[str]:
    """The rows in columns: number, amax, amin, bmax, bmin, gap."""
    titles = [*_TITLES, *(("axis", "from", "", "") if wide else ())]
    return aligned([titles, *(_cells(pair, table, row, wide) for row in table.rows)], left=(6, 7, 8, 9))


def verdict(pair: SatPair, table: SatTable) -> list[str]:
    """One to three sentences."""
    a, b = pair.names
    lines = [f"{a} and {b} are {'' if table.colliding else 'not '}colliding: {headline(table, pair.names)}."]
    left = table.axis_count - len(table.rows)
    if left:
        lines.append(f"{left} more {'axis was' if left == 1 else 'axes were'} not needed.")
    if table.mtv is not None:
        lines.append(f"The shortest way out moves {b} by {point(table.mtv)} m.")
        second = table.runner_up
        if second is not None:
            lines.append(f"The second shortest is {metres(-second.separation)} along axis {second.number}.")
    return lines


def aligned(rows: Sequence[Sequence[str]], left: Sequence[int] = ()) -> list[str]:
    """Cells in columns, to the right except for the columns `left`; no blanks at the ends of lines."""
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return [
        "  ".join(f"{cell:{'<' if i in left else '>'}{widths[i]}}" for i, cell in enumerate(row)).rstrip()
        for row in rows
    ]


def _cells(pair: SatPair, table: SatTable, row: SatRow, wide: bool) -> list[str]:
    numbers = [plain(value) for value in (row.amax, row.amin, row.bmax, row.bmin)]
    cells = [str(row.number), *numbers, "Yes" if row.gap else "No"]
    if wide:
        mark = "the test stops here" if row.stopped else "the way out" if row is table.mtv_row else ""
        cells += [point(row.axis), axis_name(row, pair.names), way_out(row), mark]
    return cells
