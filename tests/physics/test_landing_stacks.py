"""What lands as a whole rebounds as a whole: stacks, walls and pyramids with restitution, however many land at once."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import sandbox

SURFACE = {"restitution": 0.3, "friction": 0.6}
STEPS = 30
"""They fall by 1 m, for 0.452 s, and land in the last of 28 steps."""


def brick(name: str, x: float, row: int, width: float = 1.0) -> dict[str, Any]:
    return {"id": name, "position": [x, 1.5 + row], "shapes": [{"box": [width, 1.0], **SURFACE}]}


def landed(bricks: list[dict[str, Any]], steps: int = STEPS) -> tuple[np.ndarray, np.ndarray]:
    """Velocities (m/s) at which all rise or fall after so many steps, and how fast they turn (rad/s)."""
    ground = {"id": "ground", "type": "static", "position": [0, -1], "shapes": [{"box": [4000, 2], **SURFACE}]}
    world = sandbox.World(sandbox.Scene(bodies=[ground, *bricks], settings={"sleeping": False}))
    world.step(steps)
    state = world.state.bodies
    return state.velocity_y[1:].copy(), state.angular_velocity[1:].copy()


def stacks(count: int, height: int) -> list[dict[str, Any]]:
    return [brick(f"{k}-{row}", 3.0 * k, row) for k in range(count) for row in range(height)]


def pyramid(rows: int) -> list[dict[str, Any]]:
    return [brick(f"{row}-{k}", 1.1 * k + 0.55 * row, row) for row in range(rows) for k in range(rows - row)]


RISES = 0.3 * 4.4145 - 9.81 * (STEPS - 27) / 60.0
"""m/s: after the blow, at the end of the steps; a substep of gravity is 0.04."""


@pytest.mark.parametrize("height", [10, 40])
def test_a_stack_that_lands_rebounds_as_one_body(height):
    speeds, turning = landed(stacks(1, height))
    assert speeds == pytest.approx(RISES, abs=0.05)
    assert turning == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize("rows", [8, 12])
def test_a_pyramid_that_lands_rebounds_as_one_body(rows):
    speeds, _ = landed(pyramid(rows))
    assert speeds == pytest.approx(RISES, abs=0.1)


def test_no_stack_knows_how_many_others_land_with_it():
    alone, _ = landed(stacks(1, 5))
    many, _ = landed(stacks(240, 5))
    assert np.array_equal(many.reshape(240, 5)[:, 0] > 0.0, np.full(240, True))
    assert many.reshape(240, 5) == pytest.approx(np.tile(alone, (240, 1)), abs=1e-6)
