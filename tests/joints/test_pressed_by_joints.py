"""Bodies that joints keep in walls and in each other, of masses from 0.01 to 100 times the usual: none is thrown."""

from __future__ import annotations

import random
from typing import Any

import pytest

from sandbox import Scene
from sandbox.engine.world import World
from tests.joints.jointed import G, energy, gap


def crowd(seed: int) -> World:
    """Chains of ten planks put down over each other, over loose boxes, and in walls."""
    choose = random.Random(seed)
    bodies: list[dict[str, Any]] = [
        {"id": "floor", "type": "static", "position": [0, -1], "shapes": [{"box": [30, 2]}]},
        *({"id": f"wall{x}", "type": "static", "position": [x, 8], "shapes": [{"box": [1, 20]}]} for x in (-9, 9)),
    ]
    for k in range(6):
        size = [choose.uniform(0.4, 1.6), choose.uniform(0.3, 1.0)]
        box = {"box": size, "density": 10 ** choose.uniform(-2, 2)}
        place = [choose.uniform(-7, 7), choose.uniform(1, 8)]
        bodies.append({"id": f"box{k}", "position": place, "angle": choose.uniform(0, 180), "shapes": [box]})
    joints: list[dict[str, Any]] = []
    for c in range(3):
        x, y = choose.uniform(-8, 4), choose.uniform(1, 5)
        for k in range(10):
            plank = {"box": [0.8, 0.25], "density": 10 ** choose.uniform(-2, 2)}
            bodies.append({"id": f"{c}-{k}", "position": [x + 0.9 * k, y], "shapes": [plank]})
        ends = [[f"{c}-0"], *([f"{c}-{k - 1}", f"{c}-{k}"] for k in range(1, 10)), [f"{c}-9"]]
        for k, pair in enumerate(ends[: choose.choice([10, 11])]):
            kind = choose.choice(["revolute", "revolute", "weld"])
            joints.append({"id": f"{c}:{k}", "type": kind, "bodies": pair, "anchor": [x + 0.9 * k - 0.45, y]})
    return World(Scene(bodies=bodies, joints=joints, settings={"sleeping": False}))


@pytest.mark.parametrize("seed", [6, 12, 15, 16, 21, 39])
def test_what_joints_keep_in_walls_throws_nobody(seed):
    world = crowd(seed)
    fall = 5.0 * G * float(world.state.bodies.mass.sum())
    before = energy(world)
    for _ in range(60):
        world.step(4)
        after = energy(world)
        assert after < before + 0.2 * fall
        assert gap(world) < 1.0
        before = after
