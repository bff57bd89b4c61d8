"""Something heavy lands on what is light: it does not bounce, and what bears it stays where it is."""

from __future__ import annotations

import pytest

from tests.physics.truth.blows import HEIGHTS, MOVED, drop
from tests.physics.truth.ours import OurRun


@pytest.mark.parametrize(
    ("ratio", "rows", "side"), [(12, 8, 2.0), (30, 8, 1.0), (100, 10, 1.0), (300, 5, 1.0), (300, 10, 3.0)]
)
def test_a_pyramid_bears_a_heavy_box_from_any_height(ratio, rows, side):
    found = [drop(OurRun, rows, float(ratio), height, side) for height in HEIGHTS]
    assert max(rebound for rebound, _ in found) < 0.35
    assert max(moved for _, moved in found) < MOVED
