"""What running belts and turning rollers draw into a gap that is too narrow for it: no drive makes it faster."""

from __future__ import annotations

import math

import pytest

from sandbox import Scene
from sandbox.engine.world import World

BELT = {"type": "static"}
SPEED = 2.0
"""Of the belts (m/s)."""


def pinched(dx: float, friction: float) -> World:
    """Two crates, one on the other, whose upper one is about to be caught below the end of a belt."""
    belts = [
        {"id": "middle", "position": [2, 4], "shapes": [_belt(10.0, -SPEED)], **BELT},
        {"id": "top", "position": [-1.5, 6], "shapes": [_belt(9.0, SPEED)], **BELT},
    ]
    crate = {"shapes": [{"box": [0.7, 0.7], "friction": friction, "density": 0.6}]}
    upper = {"id": "upper", "position": [3.2047 + dx, 5.4052], "angle": -112.0, "velocity": [-1.974, 0.013], **crate}
    lower = {"id": "lower", "position": [3.3472, 4.5998], "velocity": [-2.001, 0.001], **crate}
    return World(Scene(bodies=[*belts, upper, lower], settings={"sleeping": False}))


def _belt(length: float, speed: float) -> dict[str, object]:
    return {"box": [length, 0.5], "radius": 0.24, "friction": 1.0, "surface_speed": speed}


@pytest.mark.parametrize("friction", [0.2, 0.49, 1.0])
@pytest.mark.parametrize("dx", [-0.03, -0.02, -0.01, 0.0, 0.01, 0.02, 0.03])
def test_crates_that_belts_pinch_are_not_shot_off(dx, friction):
    """Both belts draw them in and neither lets them slip, so there are no impulses that fit: passes over the impact
    that added to them until their number was up threw crates off at 14 m/s (Box2D 3)."""
    w = pinched(dx, friction)
    fastest = 0.0
    for _ in range(30):
        w.step()
        fastest = max(fastest, *(math.hypot(*w.body(name).velocity) for name in ("upper", "lower")))
    assert fastest < 3.0 * SPEED
