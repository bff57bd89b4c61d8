"""`sat_table`: the whole separating-axis test of one pair as data, with what the engine makes of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict, dataclass, replace
from typing import Any

from sandbox.geometry.checks import check_shapes
from sandbox.geometry.collide import Contact, collide
from sandbox.geometry.sat_rows import SatRow, Vec, count_axes, sat_rows
from sandbox.geometry.shapes import Shape

_PARALLEL = 1e-9
"""Sine of the angle below which two axes count as the same line."""


@dataclass(frozen=True)
class SatTable:
    """One pair, axis by axis.

    `rows` end at the first gap unless all axes were asked for; `contact` is what the engine's kernels say of the same
    pair, None where an axis separates it.
    """

    a: Shape
    b: Shape
    rows: tuple[SatRow, ...]
    contact: Contact | None

    @property
    def colliding(self) -> bool:
        """The verdict of the engine. Touching is not colliding."""
        return self.contact is not None

    @property
    def mtv(self) -> Vec | None:
        """Minimum translation vector in metres: b moved by it just leaves a. None where the two are apart."""
        return None if self.contact is None else self.contact.mtv

    @property
    def stopped(self) -> SatRow | None:
        """The row that separates the shapes: the test ends there. None where no axis does."""
        return next((row for row in self.rows if row.stopped), None)

    @property
    def mtv_row(self) -> SatRow | None:
        """The row whose axis gave the translation vector."""
        return None if self.contact is None else _row_of(self.contact, self.rows)

    @property
    def runner_up(self) -> SatRow | None:
        """The shortest way out along any other line than the first one's."""
        first = self.mtv_row
        others = [row for row in self.rows if first is not None and not _same_line(row.axis, first.axis)]
        return max(others, key=lambda row: row.separation, default=None)

    @property
    def axis_count(self) -> int:
        """How many axes there are, tested or not."""
        return count_axes(self.a, self.b)

    def to_data(self) -> dict[str, Any]:
        """The table as plain values for JSON."""
        first, second, stopped = self.mtv_row, self.runner_up, self.stopped
        return {
            "colliding": self.colliding,
            "axes": self.axis_count,
            "rows": [asdict(row) for row in self.rows],
            "stopped_at": None if stopped is None else stopped.number,
            "mtv": self.mtv,
            "depth": None if self.contact is None else self.contact.depth,
            "mtv_axis": None if first is None else first.number,
            "runner_up": None if second is None else second.number,
            "points": [] if self.contact is None else [list(point) for point in self.contact.points],
        }


def sat_table(a: Shape, b: Shape, all_axes: bool = False) -> SatTable:
    """The separating-axis table of two shapes: one row an axis, up to the first gap, or every axis.

    Rows are exact arithmetic over the author's own vertices; verdict, translation vector and points come from
    `sandbox.collide`, hence from the kernels of the engine.
    """
    check_shapes("sat_table", a, b)
    rows = _up_to_gap(sat_rows(a, b), all_axes)
    return SatTable(a, b, tuple(rows), collide(a, b))


def _up_to_gap(rows: Iterator[SatRow], all_axes: bool) -> Iterator[SatRow]:
    stopped = False
    for row in rows:
        yield replace(row, stopped=row.gap and not stopped)
        stopped = stopped or row.gap
        if stopped and not all_axes:
            return


def _row_of(contact: Contact, rows: tuple[SatRow, ...]) -> SatRow | None:
    """The row of the axis that a contact names; a line has two faces and one row."""
    own = (row for row in rows if row.owner == contact.axis_owner)
    return next((row for row in own if contact.axis_edge is None or row.edge == contact.axis_edge + 1), None)


def _same_line(u: Vec, v: Vec) -> bool:
    cross = u[0] * v[1] - u[1] * v[0]
    return cross * cross <= _PARALLEL**2 * (u[0] * u[0] + u[1] * u[1]) * (v[0] * v[0] + v[1] * v[1])
