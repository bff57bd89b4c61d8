"""`sandbox sat --step-by-step`: the test told in six steps, with the numbers of this very pair."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.cli.sat_clip_text import clipping_lines
from sandbox.cli.sat_pair import SatPair
from sandbox.cli.sat_text import aligned, table_lines, verdict
from sandbox.geometry.sat_rows import SatRow, author_edges, corners_in_order
from sandbox.geometry.sat_table import SatTable
from sandbox.geometry.shapes import Shape
from sandbox.render.number_text import metres, plain, point
from sandbox.render.sat_labels import axis_name


def explanation(pair: SatPair, table: SatTable) -> list[str]:
    """All lines of it."""
    lines = [pair.note, ""] if pair.note else []
    for number, (title, body) in enumerate(_steps(pair, table), start=1):
        lines += [f"{number}. {title}", *(f"   {line}".rstrip() for line in body), ""]
    return [*lines, *verdict(pair, table)]


def _steps(pair: SatPair, table: SatTable) -> Iterator[tuple[str, list[str]]]:
    yield "Axes", _axes(pair, table)
    yield "Projections", _projections(pair, table)
    yield "Early exit", _exit(pair, table)
    if table.mtv_row is None:
        return
    yield "Minimum", _minimum(table, table.mtv_row)
    yield "Orientation", _orientation(pair, table, table.mtv_row)
    yield "Clipping", clipping_lines(pair, table)


def _axes(pair: SatPair, table: SatTable) -> list[str]:
    """Edges and their perpendiculars."""
    lines = ["An edge is the vector from one vertex to the next; its perpendicular (-y, x) is an axis.", ""]
    cells: list[tuple[str, ...]] = [("", "vertices", "edge", "axis")]
    for name, shape in zip(pair.names, (pair.a, pair.b), strict=True):
        for number, start, end in author_edges(shape):
            edge, axis = (end[0] - start[0], end[1] - start[1]), (start[1] - end[1], end[0] - start[0])
            ends = f"{point(start)} to {point(end)}"
            cells.append((f"edge {number} of {name}", ends, point(edge), point((axis[0] + 0.0, axis[1] + 0.0))))
    lines += aligned(cells, left=(0, 1, 2, 3)) if len(cells) > 1 else ["Discs have no edges."]
    if pair.a.radius or pair.b.radius:
        lines += [
            "",
            "Rounded shapes add one axis: from vertex to vertex (centre, for a disc) where those are nearest.",
        ]
    return lines


def _projections(pair: SatPair, table: SatTable) -> list[str]:
    """Dot products of every vertex with every axis tested."""
    lines = ["The dot product of a vertex and an axis tells how far along the axis it lies, times the axis' length."]
    for row in table.rows:
        lines += ["", f"axis {row.number}, {point(row.axis)}, from {axis_name(row, pair.names)}"]
        cells = [
            _dots(row, name, shape, low, high)
            for name, shape, low, high in (
                (pair.names[0], pair.a, row.amin, row.amax),
                (pair.names[1], pair.b, row.bmin, row.bmax),
            )
        ]
        lines += [f"  {line}" for line in aligned(cells, left=(0, 1, 2))]
    return lines


def _dots(row: SatRow, name: str, shape: Shape, low: float, high: float) -> tuple[str, str, str]:
    dots = ", ".join(plain(x * row.axis[0] + y * row.axis[1]) for x, y in corners_in_order(shape))
    rounded = f", and {plain(shape.radius * row.length)} more for the radius" if shape.radius else ""
    return name, f"{plain(low)} to {plain(high)}", f"({dots}{rounded})"


def _exit(pair: SatPair, table: SatTable) -> list[str]:
    """The inequality, axis by axis."""
    lines = ["The intervals overlap if amin < bmax and bmin < amax. One axis on which they do not ends the test.", ""]
    lines += [*table_lines(pair, table), ""]
    row = table.stopped
    if row is None:
        count = table.axis_count
        tested = f"All {count} axes were tested and none leaves a gap." if count > 1 else "It is the only axis: no gap."
        return [*lines, tested]
    first = f"{plain(row.amin)} < {plain(row.bmax)}", row.amin < row.bmax
    second = f"{plain(row.bmin)} < {plain(row.amax)}", row.bmin < row.amax
    false = " and ".join(text for text, holds in (first, second) if not holds)
    lines.append(
        f"Axis {row.number}: {false or 'to rounding, ' + first[0]} is false. That is a gap: the test stops here."
    )
    return lines


def _minimum(table: SatTable, least: SatRow) -> list[str]:
    """Ways out in metres."""
    lines = [
        "An overlap divided by the axis' length is metres: how far the second shape has to go along that axis.",
        "",
    ]
    cells = [("axis", "overlap", "length", "way out")]
    for row in table.rows:
        overlap = plain(-row.separation * row.length) if row.owner == "corners" else plain(_overlap(row))
        mark = "  the least" if row is least else ""
        cells.append((str(row.number), overlap, plain(row.length), metres(-row.separation) + mark))
    return [*lines, *aligned(cells, left=(3,))]


def _overlap(row: SatRow) -> float:
    return min(row.amax - row.bmin, row.bmax - row.amin)


def _orientation(pair: SatPair, table: SatTable, row: SatRow) -> list[str]:
    """Which way along the axis."""
    assert table.contact is not None
    b = pair.names[1]
    forwards, backwards = row.amax - row.bmin, row.bmax - row.amin
    way = "forwards" if forwards <= backwards else "backwards"
    return [
        f"{b} leaves forwards, along the axis, by amax - bmin = {plain(forwards)},",
        f"or backwards, against it, by bmax - amin = {plain(backwards)}. The shorter one is {way}:",
        f"normal {point(table.contact.normal)}, depth {metres(table.contact.depth)}. The centres play no part.",
    ]
