"""Marks on the scrubber: steps worth going to, as panels know them, and the range that is chosen there."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Literal

SNAP_PIXELS = 6.0


@dataclass(frozen=True)
class TimeMark:
    """A step with a word about it; `color` says in which of a palette's colours it is drawn."""

    step: int
    tip: str
    color: Literal["accent", "second"] = "second"


@dataclass
class TimeMarks:
    """The marks of all who have some, and `chosen`, the range of steps (first, last) marked with Shift, or None."""

    chosen: tuple[int, int] | None = None
    _by_owner: dict[str, tuple[TimeMark, ...]] = field(default_factory=dict)

    def put(self, owner: str, marks: Iterable[TimeMark]) -> None:
        """Show these marks instead of those that `owner` had."""
        self._by_owner[owner] = tuple(marks)

    def all(self) -> list[TimeMark]:
        """All marks, in the order of their steps."""
        return sorted((mark for marks in self._by_owner.values() for mark in marks), key=lambda mark: mark.step)


@dataclass(frozen=True)
class Track:
    """Steps 0 to `length` along `width` pixels from `left` on."""

    left: float
    width: float
    length: int

    def x(self, step: int) -> float:
        """The pixel of a step."""
        return self.left + self.width * step / max(self.length, 1)

    def step(self, x: float) -> int:
        """The step nearest to a pixel."""
        share = min(max((x - self.left) / self.width, 0.0), 1.0)
        return round(share * self.length)

    def near(self, x: float, marks: Iterable[TimeMark]) -> list[TimeMark]:
        """The marks at the step nearest to a pixel, of those a few pixels away at most; they draw the hand."""
        close = [mark for mark in marks if mark.step <= self.length and abs(self.x(mark.step) - x) <= SNAP_PIXELS]
        nearest = min(close, key=lambda mark: abs(self.x(mark.step) - x), default=None)
        return [mark for mark in close if nearest is not None and mark.step == nearest.step]
