"""What is kept of each step that was seen, for as long as the timeline does not take another way."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sandbox.replay.timeline import Timeline
from sandbox.tables import Floats, Integers

MOST_STEPS = 1_000_000
"""Later steps are not kept."""
_FIRST_ROOM = 1024


class Branches:
    """Tells, once each, of the places where another future began. Ask before anything kept is used or added."""

    def __init__(self) -> None:
        self._seen = 0

    def parting(self, timeline: Timeline) -> int | None:
        """The step after which nothing holds any more that was kept before; None if all does."""
        cuts = timeline.cuts[self._seen :]
        self._seen += len(cuts)
        return min(cuts, default=None)


class History:
    """Numbers by step: a row a step from 0, a column a quantity, NaN where a step was not seen."""

    def __init__(self, columns: Sequence[str]) -> None:
        self.columns = tuple(columns)
        self._at = {name: number for number, name in enumerate(self.columns)}
        self._rows: Floats = np.full((_FIRST_ROOM, len(self.columns)), np.nan)
        self._length, self._first = 0, MOST_STEPS
        self._branches = Branches()

    def __len__(self) -> int:
        """One more than the last step that is kept."""
        return self._length

    @property
    def first(self) -> int:
        """The first step that is kept."""
        return min(self._first, self._length)

    def follow(self, timeline: Timeline) -> None:
        """Forget what is no longer so."""
        parting = self._branches.parting(timeline)
        if parting is not None and parting + 1 < self._length:
            self._rows[parting + 1 : self._length] = np.nan
            self._length = parting + 1
            if self._first > parting:
                self._first = MOST_STEPS

    def note(self, step: int, values: Sequence[float]) -> None:
        """Keep the values of a step, in the order of the columns."""
        if step > MOST_STEPS:
            return
        if step >= len(self._rows):
            more = np.full((step + 1, len(self.columns)), np.nan)  # at least as many again
            self._rows = np.concatenate([self._rows, more])
        self._rows[step] = values
        self._first = min(self._first, step)
        self._length = max(self._length, step + 1)

    def column(self, name: str) -> Floats:
        """The values of a quantity, by step. A view."""
        values: Floats = self._rows[: self._length, self._at[name]]
        return values

    def known(self) -> Integers:
        """The steps of which something is kept."""
        return np.flatnonzero(~np.isnan(self._rows[: self._length]).all(axis=1))


def thinned(values: Floats, first: int, end: int, most: int) -> Integers:
    """Places between `first` and `end` that draw the same line in `most` pixels: the extremes of each stretch."""
    count = end - first
    if count <= 2 * most:
        return np.arange(first, end)
    stretch = -(-count // most)
    rows = values[first : first + count // stretch * stretch].reshape(-1, stretch)
    filled = np.where(np.isnan(rows), np.inf, rows), np.where(np.isnan(rows), -np.inf, rows)
    starts = first + stretch * np.arange(len(rows))
    lowest, highest = starts + filled[0].argmin(axis=1), starts + filled[1].argmax(axis=1)
    left_over = np.arange(first + rows.size, end)
    return np.unique(np.concatenate([[first], lowest, highest, left_over, [end - 1]]))
