"""What slides or rolls over the seams of a concave polygon does not catch: held against energy, and one single box."""

from __future__ import annotations

import math
from random import Random

import pytest

import sandbox
from sandbox.geometry.decompose import decompose

GRAVITY = 9.81
SHAPES = {
    "box": ({"box": [1, 1]}, 0.5),
    "small box": ({"box": [0.2, 0.2]}, 0.1),
    "rounded box": ({"box": [1, 0.5], "radius": 0.1}, 0.25),
    "ball": ({"circle": 0.5}, 0.5),
    "capsule": ({"capsule": [[-0.3, 0], [0.3, 0]], "radius": 0.3}, 0.3),
    "triangle": ({"polygon": [[-0.5, -0.25], [0.5, -0.25], [0.1, 0.5]]}, 0.25),
}
"""Shapes and how high their origin lies over what they rest on."""


def terrain(seed: int, bend: float) -> list[tuple[float, float]]:
    """Ground from x = -10 to 10 with a top that goes up and down by `bend`, flat at both ends."""
    random = Random(seed)
    xs = [-6.0]
    while xs[-1] < 6.0:
        xs.append(xs[-1] + random.uniform(0.3, 2.5))
    heights = [random.uniform(-bend, bend) for _ in xs]
    return [(-10, -3), (10, -3), (10, 0), *zip(xs[::-1], heights, strict=True), (-10, 0)]


def comb(teeth: int, gap: float) -> list[tuple[float, float]]:
    """Teeth that point up, 0.5 m wide and `gap` apart; their tops are y = 0."""
    top = [(k * (0.5 + gap) + x, y) for k in range(teeth) for x, y in ((0, -1), (0, 0), (0.5, 0), (0.5, -1))]
    left, right = top[1][0], top[-1][0]
    return [(left, -2), (right, -2), *top[1:-1][::-1]]


def slide(ground: dict, shape: str, speed: float, start: float, end: float, friction: float = 0.0) -> tuple[float, ...]:
    """(share of speed, share of energy) left when a shape that starts on y = 0 at `start` is past `end`."""
    outline, height = SHAPES[shape]
    scene = sandbox.Scene(
        bodies=[
            {"id": "ground", "type": "static", "shapes": [ground | {"friction": friction}]},
            {
                "id": "sled",
                "shapes": [outline | {"friction": friction}],
                "position": (start, height),
                "velocity": (speed, 0),
            },
        ],
        settings={"sleeping": False},
    )
    world = sandbox.World(scene)
    sled = world.body("sled")
    energy = [0.0, 0.0]
    first = float(sled.center[1])
    for _ in range(3000):
        world.step()
        if sled.position[0] > end:
            break
    row = world.state.bodies[1]
    moving = row.mass * math.hypot(*sled.velocity) ** 2 + row.inertia * row.angular_velocity**2
    energy = (0.5 * moving / row.mass + GRAVITY * (row.center_y - first)) / (0.5 * speed**2)
    assert sled.position[0] > end, "it stuck"
    return float(sled.velocity[0]) / speed, float(energy)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("speed", [2.0, 20.0])
def test_nothing_catches_on_ground_that_is_almost_flat(shape, speed):
    for seed in range(3):
        outline = terrain(seed, 1e-5)
        assert len(decompose(outline).parts) >= 3
        left, _energy = slide({"polygon": outline}, shape, speed, -8.0, 8.0)
        assert left == pytest.approx(1.0, abs=1e-4)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("speed", [3.0, 15.0])
def test_bumps_take_what_they_must(shape, speed):
    """At each bend the speed into the new side is lost, some per cent of the energy in all; a seam would stop it."""
    for seed in range(3):
        _left, energy = slide({"polygon": terrain(seed, 0.01)}, shape, speed, -8.0, 8.0)
        assert 0.95 <= energy <= 1.01


@pytest.mark.parametrize("speed", [2.0, 8.0])
@pytest.mark.parametrize("gap", [0.1, 0.3])
@pytest.mark.parametrize("friction", [0.0, 0.02])
def test_over_a_comb_as_over_a_box(speed, gap, friction):
    teeth = round(9 / (0.5 + gap))
    outline = comb(teeth, gap)
    assert len(decompose(outline).parts) >= teeth
    width = outline[1][0]
    left, _ = slide({"polygon": outline}, "box", speed, 1.0, width - 1.0, friction)
    plain, _ = slide({"box": [width, 2], "at": [0.5 * width, -1]}, "box", speed, 1.0, width - 1.0, friction)
    assert left == pytest.approx(plain, abs=2e-3)


@pytest.mark.parametrize("shape", SHAPES)
def test_over_a_u_on_its_head_and_a_frame(shape):
    arch = [(-10, -4), (-8, -4), (-8, -1), (8, -1), (8, -4), (10, -4), (10, 0), (-10, 0)]
    hole = [(-8, -3), (8, -3), (8, -1), (-8, -1)]
    frame = {"polygon": [(-10, -4), (10, -4), (10, 0), (-10, 0)], "holes": [hole]}
    for ground in ({"polygon": arch}, frame):
        left, _ = slide(ground, shape, 5.0, -8.5, 8.5)
        assert left == pytest.approx(1.0, abs=1e-6)


def test_a_sled_of_many_parts_on_a_plain_floor_and_on_one_of_parts():
    """A concave body that slides upside down and on another one."""
    sled = [(-1, 0), (-0.4, -1e-5), (0.3, 1e-5), (1, 0), (1, 0.6), (0.7, 0.2), (0.2, 0.6), (-0.3, 0.2), (-1, 0.6)]
    for floor in ({"box": [20, 2], "at": [0, -1]}, {"polygon": terrain(1, 1e-5)}):
        bodies = [
            {"id": "floor", "type": "static", "shapes": [floor | {"friction": 0}]},
            {"id": "sled", "shapes": [{"polygon": sled}], "position": (-7, 0.01), "velocity": (3, 0)},
        ]
        world = sandbox.World(sandbox.Scene(bodies=bodies, settings={"sleeping": False}))
        world.step(240)
        assert world.body("sled").position[0] > 4.5
        assert world.body("sled").velocity[0] == pytest.approx(3.0, abs=1e-3)


def test_a_ball_rolls_to_the_same_height_in_a_bowl_of_parts():
    """What slides down one side comes up the other, but for sin(bend)^2 of the energy at each of some 40 bends."""
    rim = [(3 * math.cos(math.pi * (1 + k / 64)), 3 + 3 * math.sin(math.pi * (1 + k / 64))) for k in range(65)]
    bowl = {"polygon": [*rim, (4, 3), (4, -1), (-4, -1), (-4, 3)], "friction": 0}
    ball = {"id": "ball", "shapes": [{"circle": 0.2, "friction": 0}], "position": (-2.4, 1.56)}
    scene = sandbox.Scene(
        bodies=[{"id": "bowl", "type": "static", "shapes": [bowl]}, ball], settings={"sleeping": False}
    )
    world = sandbox.World(scene)
    highest = 0.0
    for _ in range(240):
        world.step()
        row = world.body("ball")
        assert math.hypot(row.position[0], row.position[1] - 3) < 2.81
        if row.position[0] > 0:
            highest = max(highest, float(row.position[1]))
    drop = 1.56 - 0.2
    least = (1 - math.sin(math.pi / 64) ** 2) ** 42
    assert least * drop < highest - 0.2 < drop
