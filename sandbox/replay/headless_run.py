"""One headless run of a scene, timed and judged: what `sandbox check` does with each file."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from sandbox.engine.world import World
from sandbox.replay.expectations import Judge, Verdict
from sandbox.scene import Scene
from sandbox.scene.duration import planned_steps

_REPORT_EVERY = 16


@dataclass(frozen=True)
class HeadlessRun:
    """The outcome of a run. `milliseconds` is the mean of a step; `frozen` are (body id, step) pairs.

    `unreached` counts the expectations that are about later steps: nothing is said of them.
    """

    steps: int
    milliseconds: float
    digest: str
    verdicts: tuple[Verdict, ...]
    frozen: tuple[tuple[str, int], ...]
    unreached: int = 0

    @property
    def holds(self) -> bool:
        """True if every expectation held and no body was frozen for bad numbers."""
        return not self.frozen and all(verdict.holds for verdict in self.verdicts)


def run_headless(
    scene: Scene, steps: int | None = None, on_steps: Callable[[int], None] | None = None, workers: int = 1
) -> HeadlessRun:
    """Run `scene` for `planned_steps` and judge it; `on_steps` hears now and then how many steps are done.

    `workers` threads share a step, where that pays.
    """
    world = World(scene, workers)
    judge = Judge(scene, world)
    seconds = 0.0
    total = planned_steps(scene, steps)
    for k in range(1, total + 1):
        start = time.perf_counter()
        world.step()
        # The first step also loads compiled code; it is left out of the mean.
        seconds += time.perf_counter() - start if k > 1 else 0.0
        judge.observe()
        if on_steps is not None and k % _REPORT_EVERY == 0:
            on_steps(k)
    mean = seconds / max(1, total - 1)
    verdicts = judge.reached()
    unreached = len(scene.expect) - len(verdicts)
    return HeadlessRun(total, 1000.0 * mean, world.digest(), verdicts, tuple(world.frozen), unreached)
