"""The arguments of machine code as 64-bit words: what a block holds of each, and tuples that several blocks share.

A number is one word, an array its address, shape and strides, a row its address. Of a tuple a block has the address of
a `Bundle`, which holds the words of all its items, one after another.
"""

from __future__ import annotations

import ctypes
import struct
from typing import Any

import numpy as np

INTEGER, FLOAT = "q", "d"
_NONE = object()
_bytes_of = ctypes.c_char.from_buffer


class Bundle:
    """A tuple, with tuples in it, that is an argument of several calls: all of them see it when it is filled anew."""

    __slots__ = ("_fields", "_memory", "_parts", "value")

    def __init__(self, value: tuple[Any, ...]) -> None:
        self.value = value
        self._fields: list[tuple[int, struct.Struct]] = []
        self._memory: Any = None
        self._parts: list[Any] = []

    @property
    def address(self) -> int:
        """Where its words are: there as long as it is itself. They are laid out when it is asked for the first time."""
        if self._memory is None:
            end = 0
            for part in parts(self.value):
                field = struct.Struct("=" + word_format(part))
                self._fields.append((end, field))
                end += field.size
            self._memory = ctypes.create_string_buffer(end + 1)
            self._parts = [_NONE] * len(self._fields)
            self.fill(self.value)
        return ctypes.addressof(self._memory)

    def fill(self, value: tuple[Any, ...]) -> None:
        """Take other items of the same kinds. Those that are the same objects as before cost nothing."""
        self.value = value
        if self._memory is not None:
            items = parts(value)
            for part, before, (offset, field) in zip(items, self._parts, self._fields, strict=True):
                if part is not before:
                    field.pack_into(self._memory, offset, *words(part))
            self._parts = items


def unbundled(argument: Any) -> Any:
    """What an argument stands for."""
    return argument.value if isinstance(argument, Bundle) else argument


def parts(value: tuple[Any, ...]) -> list[Any]:
    """What is in a tuple and in the tuples in it."""
    found: list[Any] = []
    for each in value:
        if isinstance(each, tuple):
            found += parts(each)
        else:
            found.append(each)
    return found


def words(value: Any) -> tuple[Any, ...]:
    """The words of what is no tuple."""
    if isinstance(value, np.ndarray):
        return (_address(value), *value.shape, *value.strides)
    if isinstance(value, np.void):
        return (np.frombuffer(value, np.uint8).ctypes.data,)
    if isinstance(value, np.bool_):
        return (int(value),)
    return () if value is None else (value,)


def _address(array: np.ndarray[Any, Any]) -> int:
    """Of an array with all its items in a row by way of its bytes: half the time of `ctypes.data`, which is asked for
    others. `__array_interface__` has it too, but describes all columns before it tells it, which takes 30 us."""
    flags = array.flags
    if array.size and flags.c_contiguous and flags.writeable:
        return ctypes.addressof(_bytes_of(np.frombuffer(array, np.uint8).data))
    return int(array.ctypes.data)


def word_format(value: Any) -> str:
    """The letters of `struct` for the words of what is no tuple."""
    if isinstance(value, np.ndarray):
        return (1 + 2 * value.ndim) * INTEGER
    if isinstance(value, (float, np.floating)):
        return FLOAT
    if isinstance(value, (int, np.integer, np.bool_, np.void)):
        return INTEGER
    if value is None:
        return ""
    raise TypeError(f"an entry point takes numbers, arrays, rows and tuples of them, no {type(value).__name__}")
