"""Fixed steps from uneven frames: an accumulator of time not yet simulated."""

from __future__ import annotations

SPEEDS = (1 / 64, 1 / 32, 1 / 16, 1 / 8, 1 / 4, 1 / 2, 1.0, 2.0, 4.0)
"""Speeds that the keys step through; physics always advances in the same fixed steps."""


class StepClock:
    """Says how many steps are due, and how far the picture is between the last two.

    Slow motion changes how often a step happens, never the step itself, so that it cannot change the physics.
    """

    def __init__(self, step_seconds: float) -> None:
        self.step_seconds = step_seconds
        self.speed = 1.0
        self.paused = False
        self._accumulated = 0.0

    @property
    def alpha(self) -> float:
        """Where the picture stands between the previous step (0) and the last one (1)."""
        return min(self._accumulated / self.step_seconds, 1.0)

    def advance(self, elapsed: float, most: int) -> int:
        """`elapsed` seconds have passed: the steps due now, at most `most`; time beyond is dropped."""
        if self.paused:
            return 0
        self._accumulated += elapsed * self.speed
        steps = int(self._accumulated / self.step_seconds)
        if steps > most:
            self._accumulated = 0.0
            return most
        self._accumulated = max(self._accumulated - steps * self.step_seconds, 0.0)
        return steps

    def snap_to_step(self) -> None:
        """Show the last step exactly; the next one is due at once when time runs again."""
        self._accumulated = self.step_seconds

    def change_speed(self, places: int) -> None:
        """Move `places` along `SPEEDS`; stops at either end."""
        at = SPEEDS.index(self.speed) + places
        self.speed = SPEEDS[min(max(at, 0), len(SPEEDS) - 1)]
