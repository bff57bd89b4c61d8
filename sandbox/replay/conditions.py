"""A condition: values to measure, and the range in which each must lie."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sandbox.replay.measures import Measure, Values
from sandbox.world.state import State


@dataclass(frozen=True)
class Condition:
    """Each measured value must lie in the closed range [`low`, `high`]; NaN lies nowhere.

    `labels[i]` names what value i belongs to; `got` is a format with `{name}` and `{value}`; `expected`
    says in words what should hold.
    """

    labels: Sequence[str]
    measure: Measure
    expected: str
    got: str
    low: float = -np.inf
    high: float = np.inf

    def fault(self, state: State) -> str | None:
        """None if the condition holds, else what was measured where it is violated most."""
        values = self.measure(state)
        good = (values >= self.low) & (values <= self.high)
        if good.all():
            return None
        text = self._describe(values, good)
        more = int(np.count_nonzero(~good)) - 1
        return f"{text} (and {more} more)" if more else text

    def _describe(self, values: Values, good: NDArray[np.bool_]) -> str:
        excess = np.maximum(self.low - values, values - self.high)
        excess = np.where(np.isnan(values), np.inf, np.where(good, -np.inf, excess))
        worst = int(np.argmax(excess))
        return self.got.format(name=self.labels[worst], value=values[worst])
