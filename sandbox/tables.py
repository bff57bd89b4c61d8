"""Record arrays declared as tables: the dtype, the hashed columns and the documentation come from one declaration.

Every field is eight bytes (`f8` or `i8`), so records have no padding and their bytes can be hashed as they are.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

Integers: TypeAlias = NDArray[np.int64]
Floats: TypeAlias = NDArray[np.float64]
Records: TypeAlias = "np.recarray[Any, Any]"
"""A one-dimensional record array: `bodies[3].velocity_x`, or `bodies.velocity_x` for the column."""

_LINE = 64


@dataclass(frozen=True)
class Field:
    """One column: its name, unit and meaning; `kind` is `f8` or `i8`; only `hashed` columns enter the digest."""

    name: str
    unit: str
    meaning: str
    kind: str = "f8"
    hashed: bool = True


@dataclass(frozen=True)
class Table:
    """A concept of the world: a name and its columns in storage order."""

    name: str
    fields: tuple[Field, ...]

    @cached_property
    def dtype(self) -> np.dtype[Any]:
        """The structured dtype of one row: always the same object, which makes calls into kernels fast."""
        return np.dtype([(field.name, field.kind) for field in self.fields])

    @property
    def hashed_fields(self) -> list[str]:
        """Names of the columns that enter the digest."""
        return [field.name for field in self.fields if field.hashed]

    def zeros(self, count: int) -> Records:
        """A new array of `count` rows, all zero."""
        return aligned_zeros(count, self.dtype).view(np.recarray)


def aligned_zeros(count: int, dtype: Any) -> NDArray[Any]:
    """`np.zeros` that begins at a cache line, so that a row of 64 bytes lies in one: 3 % of a step."""
    dtype = np.dtype(dtype)
    memory = np.zeros(count * dtype.itemsize + _LINE, np.uint8)
    return np.ndarray(count, dtype, memory.data, -memory.ctypes.data % _LINE)


def taken(rows: Records, index: Any) -> Records:
    """Some rows of a table, by numbers or by flags, as a table of its own."""
    table: Records = np.asarray(rows)[index].view(np.recarray)
    return table


def plain(rows: Any) -> NDArray[Any]:
    """A table as a plain array, whose columns (`plain(rows)["mass"]`) are had ten times as fast."""
    base = rows.base
    return base if type(base) is np.ndarray and len(base) == len(rows) else np.asarray(rows)


def extended(rows: Records, more: NDArray[Any]) -> Records:
    """A table with further rows behind those it has.

    They lie in spare memory where it has some; else all move into memory for twice as many rows, so that what a row
    costs does not depend on how many there are, and no more than half of the memory is spare.
    """
    first, count = len(rows), len(rows) + len(more)
    if len(more) == 0:
        return rows
    memory = _memory(rows)
    if count > len(memory):
        memory = aligned_zeros(2 * count, plain(rows).dtype)
        copy_rows(memory, plain(rows))
    copy_rows(memory[first:], more)
    return memory[:count].view(np.recarray)


def without(rows: Records, left: NDArray[np.bool_]) -> Records:
    """A table without the rows that are not `left`: the others close up in its memory, those behind become spare."""
    gone = np.flatnonzero(~left)
    if len(gone) == 0:
        return rows
    memory, first, end = _memory(rows), int(gone[0]), int(gone[-1]) + 1
    if end - first > len(gone):
        kept = memory[first:end].take(np.flatnonzero(left[first:end]))
        copy_rows(memory[first:], kept)
        first += len(kept)
    copy_rows(memory[first:], memory[end : len(rows)])
    return memory[: len(rows) - len(gone)].view(np.recarray)


def copy_rows(target: NDArray[Any], rows: NDArray[Any]) -> None:
    """Write rows to the first of `target`; both may share memory. As bytes: numpy copies records field by field."""
    if len(rows):
        target[: len(rows)].view(np.uint8)[:] = rows.view(np.uint8)


def _memory(rows: Records) -> NDArray[Any]:
    """The memory of a table, with its spare rows: what `extended` and `without` return are the first rows of it."""
    own = plain(rows)
    raw = own.base
    if not isinstance(raw, np.ndarray) or raw.dtype != np.uint8:
        return own
    offset = own.ctypes.data - raw.ctypes.data
    return np.ndarray((len(raw) - offset) // own.itemsize, own.dtype, raw.data, offset)
