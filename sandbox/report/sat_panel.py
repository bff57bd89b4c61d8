"""The separating-axis table of the pair where two runs part, with every number in which they differ."""

from __future__ import annotations

import base64

from sandbox.geometry.sat_rows import SatRow
from sandbox.geometry.sat_table import SatTable
from sandbox.render.number_text import plain
from sandbox.render.sat_figure import FIGURES
from sandbox.render.sat_labels import axis_name, headline, shortened, way_out
from sandbox.render.sat_page import SatFigure
from sandbox.report.markup import Node, node
from sandbox.report.pairs import Pair

_TITLES = ("axis", "amax", "amin", "bmax", "bmin", "gap")
_NUMBERS = ("amax", "amin", "bmax", "bmin")
_NAME = 17
_MOST_AXES = 24


def sat_panel(pair: Pair) -> list[Node]:
    """A sentence, the table and a picture."""
    a, b = pair.names
    said = [f"{a} and {b} after step {pair.step}: {headline(pair.got, pair.names)}."]
    if pair.expected is not None and headline(pair.expected, pair.names) != headline(pair.got, pair.names):
        said.append(f" Expected: {headline(pair.expected, pair.names)}.")
    table = node("table", "sat", *_rows(pair))
    left = len(pair.got.rows) - _MOST_AXES
    more = [node("p", "soft", f"{left} more axes are not shown.")] if left > 0 else []
    note = [] if pair.expected is None else [_key()]
    figure = node(
        "img", "sat-picture", src=_picture(pair), alt=f"{a} and {b} with the axes of their separating-axis test"
    )
    return [node("p", "", *said), node("div", "wide", table), *note, *more, figure]


def _key() -> Node:
    text = "Numbers that differ are red, with all digits; the expected one is below in blue."
    return node("p", "soft", text)


def _rows(pair: Pair) -> list[Node]:
    head = node("tr", "", *(node("th", "", title) for title in _TITLES), node("th", "words", "from"), node("th"))
    others = {} if pair.expected is None else {row.number: row for row in pair.expected.rows}
    rows = [_row(pair, row, others.get(row.number)) for row in pair.got.rows[:_MOST_AXES]]
    return [node("thead", "", head), node("tbody", "", *rows)]


def _row(pair: Pair, row: SatRow, other: SatRow | None) -> Node:
    cells = [node("td", "", str(row.number))]
    for name in _NUMBERS:
        cells.append(_cell(getattr(row, name), getattr(other, name, None)))
    gap = "Yes" if row.gap else "No"
    was = gap if other is None else "Yes" if other.gap else "No"
    cells.append(node("td", "", gap) if was == gap else node("td", "other", gap, node("s", "", was)))
    cells += [node("td", "words", axis_name(row, pair.names)), node("td", "words", way_out(row))]
    return node("tr", _kind(pair.got, row), *cells)


def _kind(table: SatTable, row: SatRow) -> str:
    return "way" if row is table.mtv_row else "stop" if row.stopped else ""


def _cell(value: float, other: float | None) -> Node:
    if other is None or other == value:
        return node("td", "", plain(value))
    return node("td", "other", repr(value), node("s", "", repr(other)))


def _picture(pair: Pair) -> str:
    names = shortened(pair.names[0], _NAME), shortened(pair.names[1], _NAME)
    svg = FIGURES["whole"](SatFigure(pair.got, names)).to_text()
    return "data:image/svg+xml;base64," + base64.b64encode(svg.encode()).decode("ascii")
