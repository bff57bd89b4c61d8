"""What sleepers cost, beside pymunk, in one run. Prints figures; asserts nothing about time.

`python -m pytest -m benchmark -s`
"""

from __future__ import annotations

import statistics

import pytest

from sandbox.engine.world import World
from sandbox.reference.space import build_space
from sandbox.scene.flat import FlatScene, FlatSettings
from tests.benchmarks.test_speed import milliseconds
from tests.flat import body, box, circle, ground, scene

STACKS = 1000


def stacks(one_awake: bool) -> FlatScene:
    """10,000 boxes in stacks of ten; perhaps a ball that hangs spinning in the air."""
    boxes = [
        body(f"{i}.{k}", box(1.0, 1.0, friction=0.6), position=(1.5 * (i - STACKS / 2), 0.5 + k))
        for i in range(STACKS)
        for k in range(10)
    ]
    ball = body("ball", circle(0.5), position=(0.0, 500.0), gravity_scale=0.0, angular_velocity=1.0)
    rest = FlatSettings(sleeping=True)
    return scene(ground(4000.0, friction=0.6), *boxes, *([ball] if one_awake else []), settings=rest)


@pytest.mark.benchmark
@pytest.mark.parametrize("awake", [0, 1])
def test_step_among_sleepers(awake: int) -> None:
    flat = stacks(bool(awake))
    world = World(flat)
    space, bodies = build_space(flat)
    space.sleep_time_threshold = 0.5
    world.step(200)
    for _ in range(400):
        space.step(1.0 / 60.0)
    assert world.awake_count == awake
    pairs = [(milliseconds(world.step, 500), milliseconds(lambda: space.step(1.0 / 60.0), 500)) for _ in range(10)]
    ours, theirs = (statistics.median(side) for side in zip(*pairs, strict=True))
    asleep = sum(each.is_sleeping for each in bodies)
    print(f"\n10,000 asleep, {awake} awake: sandbox {ours:.4f} ms, pymunk {theirs:.4f} ms ({asleep} of its asleep)")
