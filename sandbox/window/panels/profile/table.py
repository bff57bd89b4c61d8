"""The last steps by stage: what each took, on average, and its share."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from sandbox.tables import Floats
from sandbox.window.stage_times import STAGES

KEPT = 240
"""Steps that the strip shows, and that means are taken over."""
REST = "rest"
PARTS = (*STAGES, REST)


class StageTable:
    """A ring of the last `KEPT` steps."""

    def __init__(self) -> None:
        self._rows: Floats = np.zeros((KEPT, len(PARTS)))
        self._count = 0

    def __len__(self) -> int:
        return min(self._count, KEPT)

    def note(self, whole: float, stages: Mapping[str, float]) -> None:
        """Keep a step that took `whole` ms, and its stages."""
        known = [stages.get(name, 0.0) for name in STAGES]
        self._rows[self._count % KEPT] = [*known, max(whole - sum(known), 0.0)]
        self._count += 1

    @property
    def rows(self) -> Floats:
        """ms of the last steps, oldest first; a column for each of `PARTS`."""
        if self._count <= KEPT:
            return self._rows[: self._count]
        return np.roll(self._rows, -(self._count % KEPT), axis=0)

    def summary(self) -> list[tuple[str, float, float, float]]:
        """(part, ms in the last step, mean ms, share of the whole) for each part that ever took time."""
        rows = self.rows
        if not len(rows):
            return []
        means = rows.mean(axis=0)
        whole = means.sum() or 1.0
        return [
            (name, float(rows[-1, k]), float(means[k]), float(means[k] / whole))
            for k, name in enumerate(PARTS)
            if means[k] > 0.0
        ]
