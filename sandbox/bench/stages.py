"""How long each part of our step takes, measured from outside: who does not ask for it pays nothing."""

from __future__ import annotations

import time
from collections import Counter, defaultdict
from collections.abc import Callable
from typing import Any, Self

from sandbox._calls import handle
from sandbox._jit import Call, interpreted
from sandbox.engine.run_steps import run_steps
from sandbox.engine.step_calls import COUNTER_WORDS, PARTS_OF_STEP, StepCalls
from sandbox.engine.stepper import Stepper
from sandbox.engine.world import World
from sandbox.tables import Integers

_run_in_python = interpreted(run_steps)


class TimedCalls(StepCalls):
    """Calls of the parts of a step (`PARTS_OF_STEP`) that are timed.

    `seconds` are those of the process's CPU time that each took until now, with several workers those of a clock, and
    `counts` how often it was called.
    """

    def __init__(self, workers: int) -> None:
        super().__init__(workers)
        self.seconds: defaultdict[str, float] = defaultdict(float)
        self.counts: Counter[str] = Counter()
        self._timed: dict[tuple[int, int], Callable[[], Any]] = {}
        self._clock = time.process_time if workers == 1 else time.perf_counter

    @classmethod
    def in_place(cls, world: World) -> Self:
        """Timed calls in the place of those that a world has; its events are kept, and it goes on to the bit."""
        _ = world.events
        calls = cls(world.workers)
        world._stepper = Stepper(world.state, world.workers, calls)
        return calls

    @classmethod
    def of(cls, world: World, clock: Callable[[], float]) -> Self:
        """The timed calls of a world, which it gets if it has none: some that go by `clock`, in seconds."""
        calls = world._stepper.calls
        if not isinstance(calls, cls):
            calls = cls.in_place(world)
            calls._clock = clock
        return calls

    def forget_times(self) -> None:
        """Begin to count anew."""
        self.seconds.clear()
        self.counts.clear()

    def _bound_run(self, words: Integers) -> Callable[[], int]:
        """Run the parts of a step from Python, where the time between them can be told."""
        return lambda: int(_run_in_python(self.parts, words, COUNTER_WORDS, self.order))

    def _machine(self, row: int, turn: int) -> tuple[int, int]:
        super()._machine(row, turn)
        run = self._timed[row, turn] = self._watched(PARTS_OF_STEP[row], self._calls[PARTS_OF_STEP[row], 0, turn])
        return handle(run), 0

    def _watched(self, part: Any, call: Call) -> Callable[[], Any]:
        name = str(part.__name__)

        def run() -> Any:
            start = self._clock()
            result = call()
            self.seconds[name] += self._clock() - start
            self.counts[name] += 1
            return result

        return run
