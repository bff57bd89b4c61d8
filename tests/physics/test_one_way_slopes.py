"""One-way shapes that are not flat, and bodies that fly past their sides."""

from __future__ import annotations

import cmath
import math
from typing import Any

import pytest

import sandbox

SLOPES: dict[str, dict[str, Any]] = {
    "segment": {"segment": [[-3, 0], [3, 1]]},
    "steeper segment": {"segment": [[3, -2], [-3, 2]]},
    "ramp": {"polygon": [[-3, 0], [3, 0], [3, 1]]},
    "hill": {"polygon": [[-3, 0], [3, 0], [0, 0.5]]},
    "disc": {"circle": 3},
    "capsule": {"capsule": [[-3, 0.5], [3, -0.5]], "radius": 0.3},
    "valley": {"chain": [[-3, 0], [0, -0.5], [3, 0]]},
    "round valley": {"chain": [[-3, 0], [0, -0.5], [3, 0]], "radius": 0.1},
}
SLEDS: dict[str, dict[str, Any]] = {
    "box": {"box": [0.4, 0.4]},
    "ball": {"circle": 0.2},
    "pill": {"capsule": [[-0.2, 0], [0.2, 0]], "radius": 0.1},
    "roof": {"polygon": [[-0.2, 0.2], [0, -0.2], [0.2, 0.2]]},
}


def world_of(slope: dict[str, Any] | None, sled: dict[str, Any], **fields: Any) -> sandbox.World:
    """A world of one slope, if any, and a sled."""
    bodies: list[dict[str, Any]] = [{"id": "sled", "shapes": [{**sled, "friction": 0.3}], **fields}]
    if slope is not None:
        bodies.append({"id": "slope", "type": "static", "shapes": [slope]})
    return sandbox.World(sandbox.Scene(bodies=bodies))


@pytest.mark.parametrize("sled", SLEDS)
@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize(("speed", "steps"), [(0.0, 65), (5.0, 45)])
def test_from_above_a_slope_is_as_if_it_were_solid(slope, sled, speed, steps):
    """Even for what comes down beside its highest place."""
    start = {"position": (0.6, 4.0), "velocity": (0, -speed)}
    solid = world_of(SLOPES[slope], SLEDS[sled], **start)
    front = world_of({**SLOPES[slope], "one_way": [0, 1]}, SLEDS[sled], **start)
    touched = 0
    for _ in range(steps):
        solid.step()
        front.step()
        assert front.body("sled").position == solid.body("sled").position
        touched += len(front.contacts)
    assert touched > 0


@pytest.mark.parametrize("sled", SLEDS)
@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("speed", [11.0, 300.0])
def test_from_below_it_lets_pass(slope, sled, speed):
    start = {"position": (0.7, -5.0), "velocity": (0, speed), "angle": 20}
    front, free = (
        world_of(one, SLEDS[sled], **start) for one in ({**SLOPES[slope], "one_way": [0, 1]}, None)
    )  # fmt: skip
    for _ in range(66):
        front.step()
        free.step()
        assert front.body("sled").position == free.body("sled").position


@pytest.mark.parametrize("sled", ["box", "ball", "pill"])
@pytest.mark.parametrize("height", [-0.25, -0.1, 0.0, 0.05])
@pytest.mark.parametrize("speed", [5.0, 50.0, 500.0])
def test_what_comes_from_the_side_passes_without_delay(sled, height, speed):
    platform = {"box": [6, 0.2], "one_way": [0, 1]}
    bodies = [
        {"id": "sled", "shapes": [SLEDS[sled]], "position": (-6, height), "velocity": (speed, 0)},
        {"id": "platform", "type": "static", "shapes": [platform]},
    ]
    world = sandbox.World(sandbox.Scene(gravity=(0, 0), bodies=bodies))
    for step in range(1, 160):
        world.step()
        assert world.body("sled").position == pytest.approx((-6 + step * speed / 60, height), abs=1e-9)


@pytest.mark.parametrize("height", [-0.25, -0.1, 0.0, 0.3])
@pytest.mark.parametrize("sled", SLEDS)
@pytest.mark.parametrize("radius", [0.0, 0.05])
def test_at_an_angle_it_holds_and_lets_pass_what_it_does_upright(radius, sled, height):
    """Its sides are parallel to its direction but for rounding, which is not to choose."""
    platform = {"box": [6, 0.2], "radius": radius, "one_way": [0, 1]}

    def end(degrees: float) -> complex:
        turn = cmath.rect(1.0, math.radians(degrees))
        place, speed = (-6 + height * 1j) * turn, 5.0 * turn
        start = {"position": (place.real, place.imag), "velocity": (speed.real, speed.imag), "angle": degrees}
        bodies = [{"id": "sled", "shapes": [SLEDS[sled]], **start}, {"id": "platform", "type": "static"}]
        bodies[1] |= {"shapes": [platform], "angle": degrees}
        world = sandbox.World(sandbox.Scene(gravity=(0, 0), bodies=bodies))
        world.step(120)
        return complex(*world.body("sled").position) / turn

    upright = end(0)
    for degrees in (10, 20, 37, 45, 123, 180, 217, 300):
        assert end(degrees) == pytest.approx(upright, abs=1e-6), degrees
