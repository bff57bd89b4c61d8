"""What few steps need is loaded before the first one, if it is compiled: a step in the midst of a run does not wait."""

from __future__ import annotations

import pytest

from sandbox._jit import jit_enabled
from sandbox.engine.continuous_collision.solve_continuous import solve_continuous
from sandbox.engine.restitution.strike_batch import strike_batch
from sandbox.engine.world import World
from tests.flat import body, circle, ground, scene

pytestmark = pytest.mark.skipif(not jit_enabled(), reason="nothing is compiled")


def dropped(restitution: float) -> World:
    ball = body("ball", circle(0.5, restitution=restitution), position=(0.0, 20.0), velocity=(0.0, -5.0))
    return World(scene(ground(), ball))


@pytest.fixture
def _nothing_loaded(monkeypatch: pytest.MonkeyPatch) -> None:
    dropped(0.5).step(150)  # so that all of it is kept
    for entry in (solve_continuous, strike_batch):
        monkeypatch.setattr(entry, "_versions", {})


@pytest.mark.usefixtures("_nothing_loaded")
@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_nothing_is_loaded_after_the_first_step(restitution: float) -> None:
    world = dropped(restitution)
    world.step()
    loaded = [len(entry._versions) for entry in (solve_continuous, strike_batch)]
    assert loaded == [1, 1 if restitution > 0.0 else 0]
    world.step(150)
    assert [len(entry._versions) for entry in (solve_continuous, strike_batch)] == loaded
