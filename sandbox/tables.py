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
