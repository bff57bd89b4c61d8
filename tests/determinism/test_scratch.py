"""How much scratch memory a world has, and what it did before, makes no difference to its digests."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.scene.flat import FlatScene, FlatSettings
from tests.flat import body, box, circle, ground


def crowd(sleeping: bool) -> FlatScene:
    """Towers that fall into each other and a wheel with more contacts than there are colours."""
    hub = body("hub", circle(4.0), position=(0.0, 4.0))
    count = 80
    turns = [2 * np.pi * k / count for k in range(count)]
    rim = [
        body(f"r{k}", circle(0.15), position=(float(4.14 * np.cos(t)), float(4.0 + 4.14 * np.sin(t))))
        for k, t in enumerate(turns)
    ]
    towers = [
        body(f"t{x}-{y}", box(0.5, 0.5), position=(6.0 + 1.5 * x + 0.05 * y, 0.25 + 0.5 * y))
        for x in range(3)
        for y in range(8)
    ]
    return FlatScene((ground(60.0), hub, *rim, *towers), settings=FlatSettings(sleeping=sleeping))


@pytest.mark.slow
@pytest.mark.parametrize("sleeping", [True, False])
def test_scratch_that_has_grown_makes_no_difference(sleeping):
    """A fresh world has little room and grows; a restored one has what the snapshot needs: the same bits."""
    long = World(crowd(sleeping))
    for _ in range(200):
        saved = long.snapshot()
        long.step()
        if long.step_count % 5 == 0 or long.step_count < 10:
            fresh = World(crowd(sleeping))
            fresh.restore(saved)
            fresh.step()
            assert fresh.digest() == long.digest(), long.step_count


def test_the_crowd_needs_serial_blocks():
    world = World(crowd(False))
    world.step()
    assert world.state.counters[0].color_count == 63


def laden_plank() -> FlatScene:
    """A plank with 300 crates on it falls asleep and is struck: waking needs more memory than a fresh world has."""
    plank = body("plank", box(40.0, 0.5), position=(0.0, 0.25))
    crates = [body(f"c{k}", box(0.1, 0.1), position=(0.12 * (k - 150), 0.56)) for k in range(300)]
    visitor = body("visitor", circle(0.1), position=(-19.9, 60.0))
    return FlatScene((ground(60.0), plank, *crates, visitor), settings=FlatSettings())


def test_waking_a_crowd_does_not_depend_on_scratch_memory():
    world = World(laden_plank())
    asleep = woken = False
    before = 302
    for _ in range(230):
        saved = world.snapshot()
        world.step()
        now = int(world.bodies.awake.sum())
        asleep, woken = asleep or now < 10, woken or (before < 10 and now > 290)
        if now != before or world.step_count % 50 == 0:
            fresh = World(laden_plank())
            fresh.restore(saved)
            fresh.step()
            assert fresh.digest() == world.digest(), world.step_count
        before = now
    assert asleep
    assert woken


def falling_asleep() -> FlatScene:
    """Two stacks and a late visitor that wakes one of them."""
    stacks = [body(f"{x}-{y}", box(1.0, 1.0), position=(4.0 * x, 0.5 + y)) for x in range(2) for y in range(3)]
    visitor = body("visitor", circle(0.3, density=5.0), position=(0.2, 30.0))
    return FlatScene((ground(), *stacks, visitor), settings=FlatSettings(sleeping=True))


def test_sleep_and_waking_survive_a_restore():
    world = World(falling_asleep())
    asleep = woken = False
    for _ in range(240):
        saved = world.snapshot()
        before = int(world.bodies.awake.sum())
        world.step()
        now = int(world.bodies.awake.sum())
        asleep, woken = asleep or now < before, woken or now > before
        fresh = World(falling_asleep())
        fresh.restore(saved)
        fresh.step()
        assert fresh.digest() == world.digest(), world.step_count
    assert asleep
    assert woken
