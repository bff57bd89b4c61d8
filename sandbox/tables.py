"""Record arrays declared as tables: the dtype, the hashed columns and the documentation come from one declaration.

Every field is eight bytes (`f8` or `i8`), or a whole number of four (`i4`), in pairs in what a world stores: so records
have no padding, and their bytes can be hashed as they are.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

Integers: TypeAlias = NDArray[np.int64]
Integers32: TypeAlias = NDArray[np.int32]
Floats: TypeAlias = NDArray[np.float64]
Records: TypeAlias = "np.recarray[Any, Any]"
"""A one-dimensional record array: `bodies[3].velocity_x`, or `bodies.velocity_x` for the column."""

FloatWords: TypeAlias = "memoryview[float]"
WholeWords: TypeAlias = "memoryview[int]"
"""The words of a table or of a row of it, by `words`."""

_LINE = 64
_base_of = np.ndarray.base.__get__
"""What a view is one of. Record arrays look through their columns for every attribute first: a microsecond."""


@dataclass(frozen=True)
class Values:
    """The numbers that a column may hold, from `low` to `high`: what kernels rely on without looking. Never NaN.

    With `row_of`, rows of the table of that name instead, from `low` to its last one: 0, or -1 where that means none.
    It may be `past` the last row by so many. With `count`, it is the first of some rows; that column says how many.
    """

    low: float = -sys.float_info.max
    high: float = sys.float_info.max
    row_of: str = ""
    count: str = ""
    past: int = 0

    def highest(self, sizes: Mapping[str, int]) -> float:
        """The greatest value, given how many rows each table has. An empty run may begin behind the last row."""
        return sizes[self.row_of] - 1 + (1 if self.count else self.past) if self.row_of else self.high


_MOST = 1 << 53
FINITE = Values()
UNLIMITED = Values(-math.inf, math.inf)
FLAG = Values(0, 1)
COUNT = Values(0, _MOST)
STEP_OR_NEVER = Values(-1, _MOST)
"""A step; -1 if never."""
ANY_WHOLE = Values(-(1 << 63), (1 << 63) - 1)


@dataclass(frozen=True)
class Field:
    """One column: its name, unit and meaning; `kind` is `f8`, `i8`, `i4` or `i2`; only `hashed` columns enter the
    digest.

    `values` are those that it may hold, as far as the table may come from outside.
    """

    name: str
    unit: str
    meaning: str
    kind: str = "f8"
    hashed: bool = True
    values: Values = FINITE


def whole(name: str, meaning: str, values: Values, hashed: bool = True) -> Field:
    """A column of whole numbers of those `values`."""
    return Field(name, "-", meaning, "i8", hashed, values)


def whole_i4(name: str, meaning: str, values: Values) -> Field:
    """The same in four bytes; another one follows in the same word."""
    return Field(name, "-", meaning, "i4", True, values)


@dataclass(frozen=True)
class Table:
    """A concept of the world: a name and its columns in storage order."""

    name: str
    fields: tuple[Field, ...]

    @cached_property
    def dtype(self) -> np.dtype[Any]:
        """The structured dtype of one row: always the same object, which makes calls into kernels fast."""
        return np.dtype([(field.name, field.kind) for field in self.fields])

    def places(self, names: Iterable[str], size: int) -> list[int]:
        """Where columns are in a row taken as numbers of `size` bytes; two of four bytes may be in one of eight."""
        return list(dict.fromkeys(self.dtype.fields[name][1] // size for name in names))  # type: ignore[index]

    def run(self, *names: str) -> int:
        """Where some columns begin that lie side by side, in words of eight bytes: for who reads them at once.

        Raises `ValueError` if they do not lie so, in that order.
        """
        places = self.places(names, 8)
        if places != list(range(places[0], places[0] + len(names))):
            raise ValueError(f"the columns {', '.join(names)} of the {self.name} table do not lie side by side")
        return places[0]

    @property
    def hashed_fields(self) -> list[str]:
        """Names of the columns that enter the digest."""
        return [field.name for field in self.fields if field.hashed]

    def zeros(self, count: int) -> Records:
        """A new array of `count` rows, all zero."""
        return as_table(aligned_zeros(count, self.dtype))


def aligned_zeros(count: int, dtype: Any) -> NDArray[Any]:
    """`np.zeros` that begins at a cache line, so that a row of 64 bytes lies in one: 3 % of a step.

    The last byte of its memory, which no row has, says where it begins.
    """
    dtype = np.dtype(dtype)
    memory = np.zeros(count * dtype.itemsize + _LINE, np.uint8)
    offset = memory[-1] = -memory.ctypes.data % _LINE
    return np.ndarray(count, dtype, memory.data, int(offset))


def as_table(rows: NDArray[Any]) -> Records:
    """A plain array as a table. `rows.view(np.recarray)` makes a dtype each time and takes five times as long."""
    return np.ndarray.__new__(np.recarray, rows.shape, _record_dtype(rows.dtype), rows)


@cache
def _record_dtype(dtype: np.dtype[Any]) -> np.dtype[Any]:
    return np.dtype((np.record, dtype))


def taken(rows: Records, index: Any) -> Records:
    """Some rows of a table, by numbers or by flags, as a table of its own."""
    table: Records = np.asarray(rows)[index].view(np.recarray)
    return table


def plain(rows: Any) -> NDArray[Any]:
    """A table as a plain array, whose columns (`plain(rows)["mass"]`) are had ten times as fast."""
    base = _base_of(rows)
    return base if type(base) is np.ndarray and len(base) == len(rows) else np.asarray(rows)


def words(rows: Records) -> tuple[FloatWords, WholeWords]:
    """The words of a table as floats and as whole numbers, row after row, in the order of its fields, all of eight
    bytes.

    For who asks for single numbers: a field of a record array takes eighty times as long.
    """
    flat: Any = plain(rows).view(np.float64)
    return flat.data, flat.view(np.int64).data


def extended(rows: Records, more: NDArray[Any]) -> Records:
    """`longer` for a table."""
    return as_table(longer(plain(rows), more)) if len(more) else rows


def longer(rows: NDArray[Any], more: NDArray[Any]) -> NDArray[Any]:
    """An array with further rows behind those it has.

    They lie in spare memory where it has some; else all move into memory for twice as many rows, so that what a row
    costs does not depend on how many there are, and no more than half of the memory is spare.
    """
    first, count = len(rows), len(rows) + len(more)
    memory = _memory(rows)
    if count > len(memory):
        memory = aligned_zeros(2 * count, rows.dtype)
        copy_rows(memory, rows)
    copy_rows(memory[first:], more)
    return memory[:count]


def joined(parts: Sequence[NDArray[Any]]) -> NDArray[Any]:
    """Arrays of one dtype, one after another. As bytes: numpy looks for a common type of records field by field."""
    whole = aligned_zeros(sum(map(len, parts)), parts[0].dtype)
    first = 0
    for each in parts:
        copy_rows(whole[first:], plain(each))
        first += len(each)
    return whole


def without(rows: Records, left: NDArray[np.bool_], start: int = 0) -> Records:
    """A table without the rows that are not `left`, which tells of those from `start` on: the others close up in its
    memory, those behind become spare."""
    own = plain(rows)
    return as_table(own[: start + close_up(own[start:], left)])


def close_up(rows: NDArray[Any], left: NDArray[np.bool_]) -> int:
    """Move the rows that are `left` to the first places, in their order; returns how many there are."""
    gone = np.flatnonzero(~left)
    if len(gone):
        first, end = int(gone[0]), int(gone[-1]) + 1
        if end - first > len(gone):
            kept = rows[first:end].take(np.flatnonzero(left[first:end]))
            copy_rows(rows[first:], kept)
            first += len(kept)
        copy_rows(rows[first:], rows[end:])
    return len(rows) - len(gone)


def copy_rows(target: NDArray[Any], rows: NDArray[Any]) -> None:
    """Write rows to the first of `target`; both may share memory. As bytes: numpy copies records field by field."""
    if len(rows):
        np.frombuffer(target, np.uint8)[: rows.nbytes] = np.frombuffer(rows, np.uint8)


def _memory(rows: NDArray[Any]) -> NDArray[Any]:
    """The memory of an array, with its spare rows: what `longer` returns are the first rows of it."""
    raw = rows.base
    if not isinstance(raw, np.ndarray) or raw.dtype != np.uint8:
        return rows
    offset = int(raw[-1])  # as `aligned_zeros` has it
    return np.ndarray((len(raw) - 1 - offset) // rows.itemsize, rows.dtype, raw.data, offset)
