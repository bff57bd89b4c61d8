"""Vectors of four numbers as arrays of numpy: what `_vectors.py` does without the compiler."""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np

WIDTH = 4
"""Numbers in a vector: 256 bits. Twice as many serve a thousand equal parts better by a quarter, but a part that has no
like, whose other lanes are empty, takes up to twice the time."""

Vector: TypeAlias = Any
"""Four floats; its operators take vectors and floats and give vectors, or masks where they compare."""
Mask: TypeAlias = Any
"""Four truths; `&`, `|` and `~`."""
Number: TypeAlias = Any
"""A float or a `Vector`, in laws that hold for both."""


def load(values: Any, at: int) -> Vector:
    """A copy: what is loaded does not change when its place does."""
    return np.array(values[at : at + WIDTH])


def store(values: Any, at: int, vector: Vector) -> None:
    """The other way."""
    values[at : at + WIDTH] = vector


def load_fields(table: Any, row: int, first: int) -> Vector:
    """Four fields of a row, one after the other from number `first` on, where each eight bytes are a field.

    Those of whole numbers can be read with others and written back, but mean nothing as floats.
    """
    return _numbers_of(table)[row, first : first + WIDTH].copy()


def store_fields(table: Any, row: int, first: int, vector: Vector) -> None:
    """The other way."""
    _numbers_of(table)[row, first : first + WIDTH] = vector


def _numbers_of(table: Any) -> Any:
    """The same memory, a row of numbers each."""
    return np.ndarray((len(table), table.dtype.itemsize // 8), np.float64, table)


def transpose(a: Vector, b: Vector, c: Vector, d: Vector) -> tuple[Vector, Vector, Vector, Vector]:
    """Of four vectors the first numbers, the second ones, the third and the fourth."""
    one, two, three, four = np.array([a, b, c, d]).T.copy()
    return one, two, three, four


def lane_numbers() -> Vector:
    """0.0 in the first lane, 1.0 in the second, and so on."""
    return np.arange(float(WIDTH))


def lanes(vector: Vector) -> tuple[float, float, float, float]:
    """The number of each lane."""
    one, two, three, four = vector.tolist()
    return one, two, three, four


def spread(number: float) -> Vector:
    """The same number in every lane."""
    return np.full(WIDTH, float(number))


def select(truth: Any, one: Number, other: Number) -> Number:
    """Lane by lane, or one of two numbers."""
    if isinstance(truth, np.ndarray):
        return np.where(truth, one, other)
    return one if truth else other


def any_lane(truth: Any) -> bool:
    """Whether a mask, or a single truth, holds anywhere."""
    return bool(truth.any()) if isinstance(truth, np.ndarray) else bool(truth)


def absolute(number: Number) -> Number:
    """Without the sign."""
    return abs(number)


def root(number: Number) -> Number:
    """The square root."""
    return np.sqrt(number) if isinstance(number, np.ndarray) else math.sqrt(number)
