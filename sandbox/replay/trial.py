"""One headless run of a scene, timed and judged: what `sandbox check` does with each file."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from sandbox.engine.world import World
from sandbox.replay.expectations import Judge, Verdict
from sandbox.scene import Scene

_REPORT_EVERY = 16


@dataclass(frozen=True)
class Trial:
    """The outcome of a run. `milliseconds` is the mean of a step; `frozen` are (body id, step) pairs."""

    steps: int
    milliseconds: float
    digest: str
    verdicts: tuple[Verdict, ...]
    frozen: tuple[tuple[str, int], ...]

    @property
    def holds(self) -> bool:
        """True if every expectation held and no body was frozen for bad numbers."""
        return not self.frozen and all(verdict.holds for verdict in self.verdicts)


def run_trial(scene: Scene, steps: int | None = None, on_steps: Callable[[int], None] | None = None) -> Trial:
    """Run `scene` for `steps` (its own number by default), and on to the last step its expectations name.

    `on_steps` is called now and then with the number of steps taken since its last call.
    """
    world = World(scene)
    judge = Judge(scene, world)
    total = max(scene.settings.steps if steps is None else steps, judge.last_step)
    seconds = [_timed_step(world, judge, k, on_steps) for k in range(1, total + 1)]
    # The first step also loads compiled code; it is left out of the mean.
    measured = seconds[1:] or seconds
    mean = sum(measured) / len(measured) if measured else 0.0
    return Trial(total, 1000.0 * mean, world.digest(), judge.verdicts(), tuple(world.frozen))


def _timed_step(world: World, judge: Judge, k: int, on_steps: Callable[[int], None] | None) -> float:
    start = time.perf_counter()
    world.step()
    seconds = time.perf_counter() - start
    judge.observe()
    if on_steps is not None and k % _REPORT_EVERY == 0:
        on_steps(_REPORT_EVERY)
    return seconds
