"""Something heavy lands on what is light: it does not bounce, and what bears it stays where it is."""

from __future__ import annotations

import pytest

from sandbox.engine.world import World
from tests.flat import body, box, scene
from tests.physics.truth.blows import HEIGHTS, drop
from tests.physics.truth.ours import OurRun


@pytest.mark.parametrize(
    ("ratio", "rows", "side"),
    [(12, 8, 2.0), (30, 8, 1.0), (100, 10, 1.0), (300, 5, 1.0), (300, 10, 3.0), (1000, 10, 1.0)],
)
def test_a_pyramid_bears_a_heavy_box_from_any_height(ratio, rows, side):
    found = [drop(OurRun, rows, float(ratio), height, side) for height in HEIGHTS]
    assert max(rebound for rebound, _ in found) < 0.15
    assert max(moved for _, moved in found) < 0.05


@pytest.mark.parametrize(("ratio", "count"), [(1.0, 2), (30.0, 1), (30.0, 10), (1000.0, 10), (1000.0, 20)])
def test_what_a_blow_meets_goes_on_together_with_it(ratio, count):
    """A box strikes a row of boxes that touch, far from all else: all go on at the speed of their centre of mass."""
    row = [body(f"light-{k}", box(1.0, 1.0), position=(float(k), 0.0)) for k in range(count)]
    heavy = body("heavy", box(1.0, 1.0, density=ratio), position=(-1.05, 0.0), velocity=(6.0, 0.0))
    world = World(scene(heavy, *row, gravity=(0.0, 0.0)))
    world.step(2)
    for name in world.names:
        assert world.body(name).velocity == pytest.approx((6.0 * ratio / (ratio + count), 0.0), abs=0.06)
