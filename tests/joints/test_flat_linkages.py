"""Closed linkages that pass flat, where their joints say nearly the same: they gain no energy there."""

from __future__ import annotations

import math

import pytest

from sandbox import Scene
from sandbox.engine.world import World

_STARTS = ((0, 90), (5, 90), (20, 90), (60, 60), (0, 120), (10, 120), (30, 150), (90, 90))
"""How the linkage is tilted and opened at first, in degrees."""


def rhombus(length: float, rate: int, tilt: float, opening: float) -> World:
    """Four rods that hang by a corner from the world, and do not collide."""
    half, turn = math.radians(opening / 2.0), math.radians(tilt)
    x, y = length * math.sin(half), length * math.cos(half)
    corners = [
        (math.cos(turn) * px - math.sin(turn) * py, math.sin(turn) * px + math.cos(turn) * py)
        for px, py in ((0.0, 0.0), (-x, -y), (0.0, -2.0 * y), (x, -y))
    ]
    rod = {"box": [length, 0.1 * length], "density": 10, "group": -1}
    bodies, joints = [], [{"id": "pin", "type": "revolute", "bodies": [None, "r0"], "anchor": list(corners[0])}]
    for i in range(4):
        (ax, ay), (bx, by) = corners[i], corners[(i + 1) % 4]
        angle = math.degrees(math.atan2(by - ay, bx - ax))
        bodies.append({"id": f"r{i}", "position": [(ax + bx) / 2, (ay + by) / 2], "angle": angle, "shapes": [rod]})
        joints.append({"id": f"j{i}", "type": "revolute", "bodies": [f"r{i}", f"r{(i + 1) % 4}"], "anchor": [bx, by]})
    settings = {"sleeping": False, "step_rate": rate}
    return World(Scene(bodies=bodies, joints=joints, gravity=[0, -9.81], settings=settings))


def energy(world: World) -> float:
    total = 0.0
    for name in world.bodies.ids:
        rod = world.body(name)
        vx, vy = rod.velocity
        total += 0.5 * rod.mass * (vx * vx + vy * vy) + 0.5 * rod.inertia * rod.angular_velocity**2
        total += 9.81 * rod.mass * rod.center[1]
    return total


@pytest.mark.parametrize("rate", [30, 60, 120])
@pytest.mark.parametrize("length", [0.5, 2.0])
@pytest.mark.parametrize(("tilt", "opening"), _STARTS)
def test_a_rhombus_that_falls_shut_gains_no_energy(length: float, rate: int, tilt: float, opening: float):
    world = rhombus(length, rate, tilt, opening)
    start = energy(world)
    size = 9.81 * length * sum(world.body(name).mass for name in world.bodies.ids)
    for _ in range(10 * rate):
        world.step()
        assert energy(world) < start + 0.01 * size
