"""How long each part of our step takes, measured from outside: who does not ask for it pays nothing."""

from __future__ import annotations

import time
from collections import Counter, defaultdict
from collections.abc import Callable
from typing import Any, Self

from sandbox._calls import handle
from sandbox._jit import Call, interpreted
from sandbox.engine.run_step import run_step
from sandbox.engine.stepper import PARTS_OF_STEP, Stepper
from sandbox.engine.world import World
from sandbox.world.state import State

_run_in_python = interpreted(run_step)


class TimedStepper(Stepper):
    """A stepper whose calls of entry points (`apply_fields` and `compile_step.PARTS`) are timed.

    `seconds` are those of the process's CPU time that each took until now, with several workers those of a clock, and
    `calls` how often it was called.
    """

    def __init__(self, state: State, workers: int = 1) -> None:
        self.seconds: defaultdict[str, float] = defaultdict(float)
        self.calls: Counter[str] = Counter()
        self._timed: dict[tuple[int, int], Callable[[], Any]] = {}
        self._clock = time.process_time if workers == 1 else time.perf_counter
        super().__init__(state, workers)

    @classmethod
    def in_place(cls, world: World) -> Self:
        """A timed stepper in the place of the one that a world has; its events are kept, and it goes on to the bit."""
        _ = world.events
        stepper = cls(world.state, world.workers)
        world._stepper = stepper
        return stepper

    @classmethod
    def of(cls, world: World, clock: Callable[[], float]) -> Self:
        """The timed stepper of a world, which it gets if it has none: one that goes by `clock`, in seconds."""
        stepper = world._stepper
        if not isinstance(stepper, cls):
            stepper = cls.in_place(world)
            stepper._clock = clock
        return stepper

    def forget_times(self) -> None:
        """Begin to count anew."""
        self.seconds.clear()
        self.calls.clear()

    def _run(self, first: int) -> int:
        return _run_in_python(self._parts[self._turn], first)

    def _machine(self, row: int, turn: int) -> tuple[int, int]:
        machine = super()._machine(row, turn)
        if machine == (0, 0):
            return machine
        run = self._timed[row, turn] = self._watched(PARTS_OF_STEP[row], self._calls[PARTS_OF_STEP[row], turn])
        return handle(run), 0

    def _watched(self, part: Any, call: Call) -> Callable[[], Any]:
        name = str(part.__name__)

        def run() -> Any:
            start = self._clock()
            result = call()
            self.seconds[name] += self._clock() - start
            self.calls[name] += 1
            return result

        return run
