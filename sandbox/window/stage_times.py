"""How long the stages of the last step took, for panels that show it."""

from __future__ import annotations

import time

from sandbox.bench.stages import TimedCalls
from sandbox.engine.world import World

STAGES = {
    "apply_fields": ("fields", "Water, wind, gravity zones and thrusters."),
    "collide": ("collide", "Active set, boxes, grid, pairs, separating-axis tests, contacts."),
    "begin": ("begin", "Waking, substep levels, what bodies, contacts and joints begin the substeps with."),
    "solve": ("solve", "Colours, blocks, and all substeps: impacts, warm start, joints, contacts, positions."),
    "finish": ("finish", "New motions, what joints bore, sleep."),
    "solve_continuous": ("continuous", "Sweeps and times of impact of what is fast."),
}
"""The entry points of a step: what they are called, and what is in them."""


class StageTimes:
    """Milliseconds of each stage since the last time that they were asked for.

    The stages are timed from outside, at the calls of the compiled parts of the step: nothing is compiled for it, and
    nothing changes in what happens. From the first question on, each such call takes two looks at the clock longer.
    """

    def __init__(self) -> None:
        self._before: dict[str, float] = {}
        self._of: TimedCalls | None = None

    def take(self, world: World) -> dict[str, float]:
        """By the names in `STAGES`; empty at the first time, for then nothing has been timed."""
        calls = TimedCalls.of(world, time.perf_counter)
        if calls is not self._of:
            self._of, self._before = calls, dict(calls.seconds)
            return {}
        took = {name: 1000.0 * (calls.seconds[name] - self._before.get(name, 0.0)) for name in STAGES}
        self._before = dict(calls.seconds)
        return took
