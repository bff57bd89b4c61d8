"""Springs of contacts bear what is put down without sinking, and forget loads that are gone."""

from __future__ import annotations

import pytest

from sandbox.engine.world import World
from tests.flat import body, box, ground, world


def _tower(heavy: float = 1.0) -> World:
    light = [body(f"b{k}", box(1.0, 1.0, friction=0.6), position=(0.0, k + 0.5)) for k in range(5)]
    return world(ground(friction=0.6), *light, body("top", box(1.0, 1.0, density=heavy), position=(0.0, 5.5)))


@pytest.mark.parametrize("heavy", [1.0, 20.0, 400.0])
def test_what_is_put_down_stays_where_it_was_put(heavy):
    w = _tower(heavy)
    w.step(120)
    for k in range(5):
        assert w.body(f"b{k}").position == pytest.approx((0.0, k + 0.5), abs=2e-9 * (1.0 + heavy))


def test_what_has_sunk_already_is_not_raised():
    """A scene taken from a world in which springs bear by sinking, as they do below what has fallen."""
    w = world(ground(), body("box", box(1.0, 1.0), position=(0.0, 0.51)))
    w.step(120)
    sunk = w.body("box").position[1]
    again = world(ground(), body("box", box(1.0, 1.0), position=(0.0, sunk)))
    again.step(120)
    assert sunk < 0.5
    assert again.body("box").position[1] == pytest.approx(sunk, abs=1e-8)


def test_a_spring_forgets_a_load_that_is_gone():
    """What is left is thrown up no higher than springs without a length would throw it, which had sunk by as much."""
    w = _tower(20.0)
    w.step(2)
    w.delete("top")
    highest = 0.0
    for _ in range(90):
        w.step()
        highest = max(highest, w.body("b4").position[1])
    assert highest < 4.5 + 0.04
    assert w.body("b4").position[1] == pytest.approx(4.5, abs=3e-3)
