"""What a sweep gives: a table with a row for each run, in the order of the grid, whatever the order of finishing."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Mapping, Sequence
from html import escape
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox._atomic_write import write_bytes, write_text
from sandbox._bounded_read import read_bytes
from sandbox._printable import told
from sandbox.arguments import check_kind, check_path, shown
from sandbox.errors import ArgumentError, MissingDependencyError, SandboxError
from sandbox.scene.near_names import did_you_mean

Column = NDArray[Any]
SUFFIXES = (".csv", ".parquet")
_SHOWN = 40
_LARGEST = 1 << 30
"""Bytes of a table that is read at most."""


class SweepTable:
    """Columns of equal length by name, NumPy arrays: `table["crate_x"]`. Parameters first, `status` last.

    Numbers are float64 or int64; texts are arrays of Python's. NaN stands where a run has no value. Raises
    `ArgumentError` for what are no columns.
    """

    def __init__(self, columns: Mapping[str, Sequence[Any]]) -> None:
        check_kind("SweepTable", "columns by their names", columns, Mapping)
        self._columns: dict[str, Column] = {name: _column(values) for name, values in columns.items()}

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of the columns, in order."""
        return tuple(self._columns)

    @property
    def rows(self) -> list[dict[str, Any]]:
        """A dictionary for each run, with Python's own numbers and texts."""
        lists = [column.tolist() for column in self._columns.values()]
        return [dict(zip(self._columns, values, strict=True)) for values in zip(*lists, strict=True)]

    def __getitem__(self, name: str) -> Column:
        """A column. Raises `ArgumentError` with the nearest name."""
        if not isinstance(name, str) or name not in self._columns:
            hint = did_you_mean(str(name), self._columns) or f"there are {', '.join(self._columns)}"
            raise ArgumentError(f"the table has no column {shown(name)}; {hint}")
        return self._columns[name]

    def __len__(self) -> int:
        return len(next(iter(self._columns.values()), ()))

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def to_csv(self, path: str | Path) -> None:
        """Write it as CSV: the shortest digits that give the same doubles. Raises `OSError` and `ArgumentError`."""
        check_path("to_csv", path)
        write_text(Path(path), self.csv())

    def csv(self) -> str:
        """The table as the text of a CSV file."""
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(self._columns)
        for row in zip(*(column.tolist() for column in self._columns.values()), strict=True):
            writer.writerow(["" if value != value else value for value in row])
        return text.getvalue()

    def to_parquet(self, path: str | Path) -> None:
        """Write it as Parquet. Raises `MissingDependencyError` without pyarrow, `OSError` and `ArgumentError`."""
        check_path("to_parquet", path)
        arrow, parquet = require_arrow()
        data = io.BytesIO()
        table = arrow.table({name: _of_one_type(column.tolist()) for name, column in self._columns.items()})
        parquet.write_table(table, data)
        write_bytes(Path(path), data.getvalue())

    def save(self, path: str | Path) -> None:
        """Write it as CSV or Parquet, by the ending of `path`. Raises what these raise."""
        check_path("save", path)
        (self.to_parquet if Path(path).suffix.lower() == ".parquet" else self.to_csv)(path)

    def to_pandas(self) -> Any:
        """A `pandas.DataFrame`. Raises `MissingDependencyError` where pandas is not installed."""
        try:
            import pandas
        except ImportError as error:
            raise MissingDependencyError("to_pandas needs pandas: python -m pip install pandas") from error
        return pandas.DataFrame(self._columns)

    def _repr_html_(self) -> str:
        """How Jupyter shows it: the first rows."""
        head = "".join(f"<th>{escape(name)}</th>" for name in self._columns)
        body = "".join(f"<tr>{''.join(_cell(value) for value in row.values())}</tr>" for row in self.rows[:_SHOWN])
        more = f"<p>{len(self)} runs; the first {_SHOWN} are shown</p>" if len(self) > _SHOWN else ""
        return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{more}"

    def __repr__(self) -> str:
        return f"<SweepTable of {len(self)} runs: {', '.join(self._columns)}>"


def read_table(path: Path) -> SweepTable:
    """The table in a CSV or Parquet file. Raises `SandboxError` and `OSError`."""
    if path.suffix.lower() == ".parquet":
        _, parquet = require_arrow()
        try:
            return SweepTable(parquet.read_table(io.BytesIO(read_bytes(path, _LARGEST))).to_pydict())
        except (ValueError, OSError) as error:
            raise SandboxError(f"{told(path)}: this is no Parquet file ({str(error).splitlines()[0]})") from None
    try:
        names, *rows = csv.reader(io.StringIO(read_bytes(path, _LARGEST).decode("utf-8-sig")))
        return SweepTable({name: _read_column(name, [row[k] for row in rows if row]) for k, name in enumerate(names)})
    except (ValueError, IndexError, csv.Error):
        raise SandboxError(f"{told(path)}: this is no table in CSV, in UTF-8 and with a line of names first") from None


def require_arrow() -> tuple[Any, Any]:
    """The packages that write Parquet. Raises `MissingDependencyError` where they are not installed."""
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError as error:
        text = "Parquet is written by pyarrow, which is not installed: python -m pip install pyarrow; CSV needs nothing"
        raise MissingDependencyError(text) from error
    return pyarrow, pyarrow.parquet


def _column(values: Sequence[Any]) -> Column:
    """Numbers as numbers, anything else as Python's own values: a text may be the name of a material, such as 1e3."""
    kinds = {type(value) for value in values}
    if kinds <= {int}:
        return np.array(values, np.int64)
    if kinds <= {int, float}:
        return np.array(values, np.float64)
    found = np.empty(len(values), object)
    found[:] = values
    return found


def _read_column(name: str, texts: Sequence[str]) -> Sequence[Any]:
    """What the texts of a file stand for: numbers, if all are; a digest may look like one."""
    for kind, blank in ((int, "x"), (float, "nan")) if name != "digest" else ():
        try:
            return [kind(text or blank) for text in texts]
        except ValueError:
            continue
    return texts


def _of_one_type(values: list[Any]) -> list[Any]:
    """What Parquet takes as a column: numbers and texts in one become texts."""
    return values if len({type(value) for value in values}) <= 1 else [str(value) for value in values]


def _cell(value: Any) -> str:
    text = f"{value:.6g}" if isinstance(value, float) else str(value)
    return f"<td>{escape(text)}</td>"
