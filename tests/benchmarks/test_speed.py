"""Speed beside pymunk on the same scenes, in one run. Prints figures; asserts nothing about time.

`python -m pytest -m benchmark -s`
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

import sandbox
from sandbox.reference.space import build_space
from sandbox.resources import find_scene
from sandbox.scene.flat import FlatScene

SCENES = [("pyramid-10", 400, 10), ("pyramid-100", 8, 8)]
"""(scene, steps a turn, turns): engines take turns, so that a slow moment of the machine meets both."""


def awake(name: str) -> FlatScene:
    """A shipped scene that never falls asleep, as pymunk's spaces do by default."""
    flat = sandbox.load_scene(find_scene(Path(name))).flatten()
    return replace(flat, settings=replace(flat.settings, sleeping=False))


def milliseconds(step: Callable[[], object], steps: int) -> float:
    start = time.perf_counter()
    for _ in range(steps):
        step()
    return (time.perf_counter() - start) / steps * 1e3


@pytest.mark.benchmark
@pytest.mark.parametrize(("name", "steps", "turns"), SCENES)
def test_step_beside_pymunk(name: str, steps: int, turns: int) -> None:
    scene = awake(name)
    world = sandbox.World(scene)
    space, _bodies = build_space(scene)
    dt = 1.0 / scene.settings.step_rate
    world.step(20)
    for _ in range(20):
        space.step(dt)
    pairs = [(milliseconds(world.step, steps), milliseconds(lambda: space.step(dt), steps)) for _ in range(turns)]
    ours, theirs = (statistics.median(side) for side in zip(*pairs, strict=True))
    ratio = statistics.median(a / b for a, b in pairs)
    print(f"\n{name}: {len(scene.bodies)} bodies, sandbox {ours:.3f} ms, pymunk {theirs:.3f} ms, ratio {ratio:.2f}")
    assert len(world.contacts) > len(scene.bodies)
