"""What lies aslant is looked at along its faces first: it has the contacts that it has when everything is turned."""

from __future__ import annotations

import math
import random

import pytest

from sandbox import Scene, World

SPACING = 40.0
PLANKS = 60


def turned(angle: float, x: float, y: float) -> list[float]:
    c, s = math.cos(angle), math.sin(angle)
    return [c * x - s * y, s * x + c * y]


def touching(angle: float, shape: dict[str, object]) -> list[int]:
    """Which of many balls touch or are about to touch their planks, if each pair is turned by `angle`."""
    draw = random.Random(11)
    bodies = []
    for k in range(PLANKS):
        fast = 90.0 * (k % 3)
        place = [draw.uniform(-6, 6), draw.uniform(-2, 2)]
        going = [draw.uniform(-fast, fast), draw.uniform(-fast, fast)]
        x, y = turned(angle, *place)
        bodies += [
            {"id": f"p{k}", "type": "static", "shapes": [shape], "position": [SPACING * k, 0],
             "angle": math.degrees(angle)},
            {"id": f"d{k}", "shapes": [{"circle": 0.5}], "position": [SPACING * k + x, y],
             "velocity": turned(angle, *going)},
        ]  # fmt: skip
    world = World(Scene(bodies=bodies, gravity=[0, 0]))
    world.step()
    return sorted(world.contacts.body_b.tolist())


@pytest.mark.parametrize("shape", [{"box": [12, 0.4]}, {"capsule": [[-6, 0], [6, 0]], "radius": 0.2}], ids=str)
def test_a_plank_aslant_has_the_contacts_of_a_level_one(shape):
    level = touching(0.0, shape)
    assert 10 < len(level) < PLANKS
    for angle in (0.3, math.pi / 4.0, 2.5):
        assert touching(angle, shape) == level
