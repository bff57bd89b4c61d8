"""Snapshots along a run, within a budget of bytes: the longer the run, the farther apart they stand."""

from __future__ import annotations

from bisect import bisect_left
from dataclasses import dataclass

from sandbox.engine.events.event_log import Untold


@dataclass(frozen=True)
class Keyframe:
    """A snapshot after `step` steps, when `applied` commands had been applied, and what was untold then."""

    step: int
    applied: int
    snapshot: bytes
    untold: Untold | None = None


class Keyframes:
    """Keyframes in the order of their steps, `spacing` steps apart or more.

    Whenever they outgrow `budget` bytes, every second one goes and the spacing doubles. The first always stays.
    """

    def __init__(self, budget: float, spacing: int = 1) -> None:
        self.budget = budget
        self.spacing = spacing
        self.size = 0
        self._frames: list[Keyframe] = []

    def __len__(self) -> int:
        return len(self._frames)

    def wants(self, step: int) -> bool:
        """Whether a keyframe of this step should be added."""
        return step % self.spacing == 0 and not self._has(step)

    def add(self, frame: Keyframe) -> None:
        """Add a keyframe of a step that has none."""
        self._frames.insert(self._place(frame.step), frame)
        self.size += len(frame.snapshot)
        while self.size > self.budget and len(self._frames) > 1:
            self.spacing *= 2
            self._keep([one for one in self._frames if one.step % self.spacing == 0])

    def before(self, step: int) -> Keyframe:
        """The last keyframe of an earlier step than `step`, which is at least 1."""
        return self._frames[self._place(step) - 1]

    def up_to(self, step: int) -> Keyframes:
        """A copy with the keyframes of steps before `step`, and the first."""
        copy = Keyframes(self.budget, self.spacing)
        copy._keep([one for one in self._frames if one.step < step or one.step == 0])
        return copy

    def _keep(self, frames: list[Keyframe]) -> None:
        self._frames = frames
        self.size = sum(len(one.snapshot) for one in frames)

    def _has(self, step: int) -> bool:
        place = self._place(step)
        return place < len(self._frames) and self._frames[place].step == step

    def _place(self, step: int) -> int:
        return bisect_left(self._frames, step, key=lambda one: one.step)
