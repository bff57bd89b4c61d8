"""Scenes that nobody tuned the engine for, beside the other engines, and how their cost grows. Asserts no times.

`python -m pytest -m benchmark -s tests/benchmarks/test_other_scenes.py`
"""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from sandbox.bench.course import Course
from sandbox.bench.race import run_race
from tests.benchmarks.other_scenes import SCENES, SETTLING, Parts, scene_of

pytestmark = pytest.mark.benchmark
ENGINES = ("sandbox", "pymunk", "box2d")
STEPS, SETTLED = 240, 900


@pytest.mark.parametrize("build", SCENES)
def test_beside_other_engines(build: Callable[[int], Parts]) -> None:
    pytest.importorskip("pyb2d3")
    times = []
    for size in (1, 2):
        steps = SETTLED if build in SETTLING else STEPS
        race = run_race(Course(scene_of(build, size), build.__name__), ENGINES, steps, profile=False)
        told = []
        for result in race.results:
            assert result.step is not None
            assert result.ratio is not None
            assert result.quality.lost == 0 or result.name != "sandbox"
            told.append(
                f"{result.name} {result.step:.3f} ms, {result.quality.deepest * 1e3:.0f} mm, {result.ratio:.2f}"
            )
        times.append(race.results[0].step or math.nan)
        print(f"\n{build.__name__} {size}: {race.bodies:,} bodies, {race.joints:,} joints; {'; '.join(told)}", end="")
    print(f"; twice the size takes {times[1] / times[0]:.2f} times as long")
    assert all(time > 0.0 for time in times)
