"""What the rows of a separating-axis table say, in words; pictures and the command line use the same ones."""

from __future__ import annotations

from sandbox.geometry.sat_rows import SatRow
from sandbox.geometry.sat_table import SatTable
from sandbox.render.number_text import metres


def axis_name(row: SatRow, names: tuple[str, str]) -> str:
    """Where an axis comes from."""
    if row.owner == "corners":
        ends = zip((row.edge, row.other), row.centers, strict=True)
        return " to ".join("centre" if center else f"vertex {number}" for number, center in ends)
    return f"edge {row.edge} of {names[0] if row.owner == 'a' else names[1]}"


def way_out(row: SatRow) -> str:
    """The gap, or how far b has to go along the axis."""
    if not row.gap:
        return f"way out {metres(-row.separation)}"
    return "touching" if row.separation == 0.0 else f"gap {metres(row.separation)}"


def headline(table: SatTable, names: tuple[str, str]) -> str:
    """Why the verdict is what it is."""
    row = deciding_row(table)
    place = f"axis {row.number}, {axis_name(row, names)}"
    if table.contact is not None:
        return f"{metres(table.contact.depth)} deep along {place}"
    if row.separation == 0.0:
        return f"they only touch along {place}"
    return f"{place}, leaves a gap of {metres(row.separation)}"


def deciding_row(table: SatTable) -> SatRow:
    """The row that separates the shapes, or that gave the way out."""
    row = table.stopped or table.mtv_row
    assert row is not None, "every pair of shapes has an axis, and either a gap or a contact"
    return row


def shortened(name: str, letters: int) -> str:
    """A body's name that leaves room for the rest of a line."""
    return name if len(name) <= letters else name[: letters - 1] + "…"
