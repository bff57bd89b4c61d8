"""Who sleeps is said in a line."""

from __future__ import annotations

import pytest

import sandbox
from sandbox.window.at_rest import asleep
from tests.render.overlays.looks import GROUND, crate


@pytest.mark.parametrize(("up", "said"), [((), ""), ((0.5,), "all"), ((0.5, 40.0), "1"), ((40.0,), "")])
def test_who_sleeps_is_counted_of_those_that_can_move(up: tuple[float, ...], said: str) -> None:
    world = sandbox.World(sandbox.Scene(bodies=[GROUND, *(crate(f"crate-{k}", 3 * k, y) for k, y in enumerate(up))]))
    world.step(60)
    assert asleep(world) == said
