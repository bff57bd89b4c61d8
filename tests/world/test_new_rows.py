"""Rows close up: each old one is looked for among those that are left."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from sandbox.world.new_rows import NewRows
from tests.examples import examples


@examples(200)
@given(st.lists(st.booleans(), max_size=12), st.integers(0, 12), st.data())
def test_new_rows_are_places_among_those_that_are_left(left, first, data):
    left[:first] = [True] * len(left[:first])
    first = min(first, len(left))
    rows = NewRows.of(first, np.array(left[first:], np.bool_))
    assert len(rows) == len(left)
    asked = data.draw(st.lists(st.integers(-1, len(left) - 1), max_size=20))
    kept = [row for row in range(len(left)) if left[row]]
    expected = [kept.index(row) if row in kept else -1 for row in asked]
    assert rows[np.array(asked, np.int64)].tolist() == expected
