"""Pairs of rows as one number each, so that numpy compares and sorts them at once."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.tables import Integers

_BITS = 32
"""Those of the second row: no table has as many."""


def pair_keys(first: Any, second: Any) -> Integers:
    """One number for each pair of rows, in the order of the pairs."""
    keys: Integers = (np.asarray(first, np.int64) << _BITS) | second  # rows may be columns of four bytes
    return keys


def pairs_of(keys: Integers) -> tuple[Integers, Integers]:
    """The pairs of rows that keys stand for."""
    return keys >> _BITS, keys & ((1 << _BITS) - 1)


def differences(keys: Integers, others: Integers) -> tuple[Integers, Integers]:
    """The places of sorted keys that are not in `others`, and those of `others`, which are sorted, not in `keys`."""
    if np.array_equal(keys, others):  # as in most steps
        return _NONE, _NONE
    return np.flatnonzero(~among(keys, others)), np.flatnonzero(~among(others, keys))


_NONE: Integers = np.zeros(0, np.int64)


def among(keys: Integers, others: Integers) -> NDArray[np.bool_]:
    """Which of the keys are also in `others`, which are sorted."""
    place = np.searchsorted(others, keys)
    found: NDArray[np.bool_] = np.zeros(len(keys), np.bool_)
    inside = place < len(others)
    found[inside] = others[place[inside]] == keys[inside]
    return found
