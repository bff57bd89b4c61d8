"""Chains and abutting tiles are as smooth as one long line or box; one-way shapes let through and hold."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import pytest

import sandbox

SLEDS = {
    "box": ({"box": [1, 1]}, 0.5),
    "ball": ({"circle": 0.5}, 0.5),
    "triangle": ({"polygon": [[-0.5, -0.5], [0.5, -0.5], [0, 0.5]]}, 0.5),
    "rounded": ({"box": [1, 1], "radius": 0.1}, 0.5),
}
"""Shapes and how high their origin lies over what they rest on."""
JOINTS = [-10 + 0.7 * k for k in range(45)]
GROUNDS: dict[str, list[dict[str, Any]]] = {
    "chain": [{"chain": [(x, 0) for x in JOINTS]}],
    "one-sided": [{"chain": [(x, 0) for x in JOINTS], "one_sided": True, "ghosts": [(-11, 0), (22, 0)]}],
    "tiles": [{"box": [1, 1], "at": [-9.5 + k, -0.5]} for k in range(31)],
    "tiles of many heights": [
        {"box": [1, 1 + 0.3 * (k % 3)], "at": [-9.5 + k, -0.5 - 0.15 * (k % 3)]} for k in range(31)
    ],
    "tiles that overlap": [{"box": [1.3, 1], "at": [-9.5 + k, -0.5]} for k in range(31)],
}
LIKE_OTHERS = {"one-sided", "tiles of many heights"}
PLAIN = [{"box": [31, 1], "at": [5.5, -0.5]}]


def world_of(ground: list[dict[str, Any]], *bodies: dict[str, Any], **scene: Any) -> sandbox.World:
    """Static ground and some bodies that never sleep."""
    fixed = {"id": "ground", "type": "static", "shapes": ground}
    return sandbox.World(sandbox.Scene(bodies=[fixed, *bodies], settings={"sleeping": False}, **scene))


def slide(ground: list[dict[str, Any]], sled: str, speed: float, friction: float) -> tuple[float, float, float, float]:
    """(speed, spin, spread of heights, highest vertical speed) of a sled after at most 240 steps from x = -8."""
    shape, height = SLEDS[sled]
    surface = {"friction": friction}
    start = {"id": "sled", "shapes": [shape | surface], "position": (-8, height), "velocity": (speed, 0)}
    world = world_of([each | surface for each in ground], start)
    row = world.state.bodies[1]
    heights, rises = [], []
    for step in range(240):
        world.step()
        if row.center_x > 19.0:
            break
        if step >= 20 or speed > 20:
            heights.append(float(row.center_y))
            rises.append(abs(float(row.velocity_y)))
    spread = max(heights, default=0.0) - min(heights, default=0.0)
    return float(row.velocity_x), float(row.angular_velocity), spread, max(rises, default=0.0)


@cache
def slide_on_plain_ground(sled: str, speed: float, friction: float) -> tuple[float, float, float, float]:
    """What all grounds are held against."""
    return slide(PLAIN, sled, speed, friction)


@pytest.mark.parametrize(
    "ground", [pytest.param(name, marks=pytest.mark.slow if name in LIKE_OTHERS else ()) for name in GROUNDS]
)
@pytest.mark.parametrize("sled", SLEDS)
def test_as_over_one_long_box(ground, sled):
    for speed in (1.0, 5.0, 30.0, 300.0):
        for friction in (0.0, 0.3):
            found, plain = slide(GROUNDS[ground], sled, speed, friction), slide_on_plain_ground(sled, speed, friction)
            assert found[0] == pytest.approx(plain[0], abs=1e-3)
            assert found[1] == pytest.approx(plain[1], abs=1e-2)
            assert found[2] < plain[2] + 3e-4
            assert found[3] < plain[3] + 5e-3


@pytest.mark.parametrize("ground", GROUNDS)
def test_a_ball_bounces_straight_up_wherever_it_comes_down(ground):
    """Fast enough to be looked at ahead of its touch, next to and between the joints."""
    for k in range(12):
        ball = {"id": "ball", "shapes": [{"circle": 0.3, "restitution": 1}], "position": (0.09 * k, 0.5)}
        world = world_of(GROUNDS[ground], ball | {"velocity": (0, -8)})
        world.step(4)
        assert world.body("ball").velocity[0] == pytest.approx(0.0, abs=1e-9)
        assert world.body("ball").velocity[1] > 7.0


def test_a_tile_that_is_taken_away_leaves_an_edge():
    """What abuts is found anew when a static body is moved."""
    tiles = [
        {"id": f"tile-{k}", "type": "static", "position": (k, -0.5), "shapes": [{"box": [1, 1]}]} for k in range(4)
    ]
    sled = {"id": "sled", "shapes": [{"box": [0.5, 0.5], "friction": 0}], "position": (0, 0.25), "velocity": (2, 0)}
    for away, passes in ((9.0, False), (0.2, False), (0.0, True)):
        world = sandbox.World(sandbox.Scene(bodies=[*tiles, sled], settings={"sleeping": False}))
        world.body("tile-2").position = (2.0, -0.5 + away)
        world.step(90)
        assert (world.body("sled").position[0] > 2.9 and world.body("sled").position[1] > 0.24) == passes


def test_a_real_step_still_stops():
    tiles = [{"box": [1, 1], "at": [k, -0.5]} for k in range(-3, 4)] + [{"box": [1, 1], "at": [3, 0.5]}]
    sled = {"id": "sled", "shapes": [{"box": [0.5, 0.5], "friction": 0}], "position": (0, 0.25), "velocity": (3, 0)}
    world = world_of(tiles, sled)
    world.step(120)
    assert world.body("sled").position[0] == pytest.approx(2.25, abs=1e-2)


def test_a_closed_chain_holds_what_is_inside():
    ring = [(2 * math.cos(k * math.pi / 12), 2 * math.sin(k * math.pi / 12)) for k in range(24)]
    for one_sided in (False, True):
        balls = [
            {"id": f"ball-{k}", "shapes": [{"circle": 0.2}], "position": (0.5 * k - 0.5, 0), "velocity": (9, 300 * k)}
            for k in range(3)
        ]
        world = world_of([{"chain": ring, "closed": True, "one_sided": one_sided}], *balls)
        for _ in range(200):
            world.step()
            assert (world.bodies.center[1:] ** 2).sum(axis=1).max() < 4.0


PLATFORMS = {
    "box": {"box": [4, 0.2], "at": [0, -0.1], "one_way": [0, 3]},
    "turned box": {"box": [0.2, 4], "at": [0, -0.1], "angle": 90, "one_way": [1, 0]},
    "segment": {"segment": [[-2, 0], [2, 0]], "one_way": [0, 1]},
    "chain": {"chain": [[-2, 0], [-1, 0], [0, 0], [1, 0], [2, 0]], "one_sided": True},
}


@pytest.mark.parametrize("platform", PLATFORMS)
@pytest.mark.parametrize("sled", ["box", "ball"])
@pytest.mark.parametrize("speed", [7.0, 12.0, 60.0, 900.0])
def test_from_below_through_and_from_above_held(platform, sled, speed):
    """The way up is that of a free throw, to rounding; the way down ends on top."""
    shape, height = SLEDS[sled]
    thrown = {"id": "sled", "shapes": [shape], "position": (0.05, -1), "velocity": (0, speed)}
    world, free = world_of([PLATFORMS[platform]], thrown), world_of([{"circle": 1, "at": [99, 0]}], thrown)
    for _ in range(math.ceil(60 * speed / 9.81)):
        world.step()
        free.step()
        assert world.body("sled").position == free.body("sled").position
    world.body("sled").velocity = (0.0, -min(speed, 12.0))
    world.body("sled").position = (0.05, 3.0)
    world.step(120)
    assert world.body("sled").position[1] == pytest.approx(height, abs=0.01)


def test_one_that_turns_back_half_way_falls_through_and_loads_press_nobody_through():
    world = world_of(
        [PLATFORMS["box"]],
        {"id": "slow", "shapes": [{"box": [0.6, 0.6]}], "position": (-1, -1), "velocity": (0, 4.5)},
        {"id": "low", "shapes": [{"box": [0.6, 0.6]}], "position": (1, 0.3)},
        {"id": "load", "shapes": [{"box": [0.6, 0.6], "density": 300}], "position": (1, 0.9)},
    )
    before = world.snapshot()
    world.step(150)
    digest = world.digest()
    assert world.body("slow").position[1] < -5.0
    assert world.body("low").position[1] > 0.2
    assert world.body("load").position[1] > 0.8
    world.restore(before)
    world.step(70)
    middle = world.snapshot()
    world.step(3)
    world.restore(middle)
    world.step(80)
    assert world.digest() == digest


def test_rays_hit_chains():
    hit = world_of(GROUNDS["chain"]).query.ray((0.3, 5), (0, -10))
    assert hit is not None
    assert hit.point == pytest.approx((0.3, 0.0), abs=1e-12)
    assert hit.body == "ground"
