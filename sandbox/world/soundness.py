"""Whether tables that come from outside hold what kernels rely on: these look at no index, count or flag again.

What a column may hold is said where it is declared (`Values` in `tables.py`), and checked here for all tables in the
same way; how rows fit together is in `row_relations.py`.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.errors import SnapshotError
from sandbox.tables import FINITE, Field, Table, Values
from sandbox.world.records import TABLES
from sandbox.world.row_relations import broken_relations

Rows = Mapping[str, NDArray[Any]]
"""The rows of every table by its name, as plain arrays."""


def check_tables(rows: Rows, sound: Collection[str] = ()) -> None:
    """Raise `SnapshotError` with the table, row and field of the first number that cannot be.

    Tables whose rows are known to be `sound`, among tables as long as these, are not looked at again.
    """
    sizes = {name: len(table) for name, table in rows.items()}
    with np.errstate(all="ignore"):
        for table in _CHECKED:
            if table.name not in sound:
                for fault in table.faults(rows[table.name], sizes):
                    raise SnapshotError(f"the snapshot is damaged: {fault}")
        for fault in broken_relations(rows, sound):
            raise SnapshotError(f"the snapshot is damaged: {fault}")


class _CheckedTable:
    """What the columns of a table may hold, laid out so that all of them are looked at together."""

    def __init__(self, table: Table) -> None:
        self.name = table.name
        self._bounded = [_Bounded(table, kind) for kind in ("i4", "i8", "f8")]
        self._finite = [field for field in table.fields if field.kind == "f8" and field.values == FINITE]
        self._words = table.places([field.name for field in self._finite], 8)
        self._runs = [field for field in table.fields if field.values.count]

    def faults(self, rows: NDArray[Any], sizes: Mapping[str, int]) -> Iterator[str]:
        """What is wrong with some rows, in words; `sizes` says how many rows each table has."""
        if not len(rows):
            return
        for bounded in self._bounded:
            for field in bounded.outside(rows, sizes):
                yield from _outside(self.name, field, rows, sizes)
        # Whatever is not finite shows in the sum; so may what is huge, which is then looked at row by row.
        # As a product: numpy takes four times as long to sum up columns.
        sums = (np.ones(len(rows)) @ rows.view(np.float64).reshape(len(rows), -1))[self._words]
        for k in np.flatnonzero(~np.isfinite(sums)).tolist():
            yield from _outside(self.name, self._finite[k], rows, sizes)
        for field in self._runs:
            yield from _beyond(self.name, field, rows, sizes[field.values.row_of])


class _Bounded:
    """The columns of one kind that are bounded, and their least and greatest values."""

    def __init__(self, table: Table, kind: str) -> None:
        self._kind = kind
        self._fields = [
            field for field in table.fields if field.kind == kind and (kind != "f8" or field.values != FINITE)
        ]
        self._columns = table.places([field.name for field in self._fields], np.dtype(kind).itemsize)
        values = [field.values for field in self._fields]
        self._low = np.array([each.low for each in values], kind)
        self._high = np.array([-1 if each.row_of else each.high for each in values], kind)
        self._rows = [(k, each) for k, each in enumerate(values) if each.row_of]

    def outside(self, rows: NDArray[Any], sizes: Mapping[str, int]) -> list[Field]:
        """The columns in which some value lies outside."""
        if not self._columns:
            return []
        high = self._high.copy()
        for k, values in self._rows:
            high[k] = values.highest(sizes)
        found = rows.view(self._kind).reshape(len(rows), -1)[:, self._columns]
        sound = (found.min(axis=0) >= self._low) & (found.max(axis=0) <= high)  # false for what is no number
        return [] if sound.all() else [self._fields[k] for k in np.flatnonzero(~sound).tolist()]


def _outside(table: str, field: Field, rows: NDArray[Any], sizes: Mapping[str, int]) -> Iterator[str]:
    """The first row in which a field is what it cannot be."""
    values, column = field.values, rows[field.name]
    high = values.highest(sizes)
    for row in np.flatnonzero(~((column >= values.low) & (column <= high)))[:1].tolist():
        yield f"{field.name} is {column[row]} in row {row} of its {table} table, {_wanted(values, high)}"


def _wanted(values: Values, high: float) -> str:
    if values == FINITE:
        return "which is no finite number"
    if values.row_of and high < values.low:
        return f"but there are no {values.row_of} rows"
    return f"not {values.low} to {high}"


def _beyond(table: str, field: Field, rows: NDArray[Any], size: int) -> Iterator[str]:
    """The first row whose run of rows ends beyond the table that it lies in."""
    values, first, count = field.values, rows[field.name], rows[field.values.count]
    for row in np.flatnonzero(count > size - first)[:1].tolist():
        found = f"{field.name} is {first[row]} and {values.count} {count[row]} in row {row} of its {table} table"
        yield f"{found}, but there are {size} {values.row_of} rows"


_CHECKED = tuple(map(_CheckedTable, TABLES))
