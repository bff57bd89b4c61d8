"""Pairs of rows are found in tables whose columns have four bytes, however many shapes there are."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox.engine.events.pair_keys import pair_keys, pairs_of
from sandbox.reference.compare_answers import find_rows


@pytest.mark.parametrize("shapes", [100_000, 2_000_000])
def test_pairs_of_the_last_of_many_shapes(shapes: int) -> None:
    table = np.array([(0, 1), (50_000, 50_001), (shapes - 3, shapes - 1), (shapes - 2, shapes - 1)], np.int32)
    wanted = np.array([(shapes - 2, shapes - 1), (0, 2), (50_000, 50_001), (shapes - 3, shapes - 1)])
    assert find_rows(wanted, table, shapes).tolist() == [3, -1, 1, 2]


def test_keys_of_rows_of_four_bytes() -> None:
    first, second = np.array([0, 7, 2_000_000_000], np.int32), np.array([3, 9, 2_000_000_001], np.int32)
    keys = pair_keys(first, second)
    assert keys.dtype == np.int64
    assert keys.tolist() == sorted(keys.tolist())
    assert [column.tolist() for column in pairs_of(keys)] == [first.tolist(), second.tolist()]
