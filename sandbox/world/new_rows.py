"""Where the rows of a table go when some are taken out."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sandbox.tables import Integers


@dataclass(frozen=True)
class NewRows:
    """The new rows of old ones: `rows[old]` for an array of those, -1 for what is gone, and for -1, which is nothing.

    Rows before `first` stay where they are; which later ones are `left` is told from there on. So it costs by what lies
    behind the first one that goes.
    """

    first: int
    left: NDArray[np.bool_]
    _later: Integers

    @classmethod
    def of(cls, first: int, left: NDArray[np.bool_]) -> NewRows:
        """Those from `first` on that are not `left` go, and the others close up."""
        later = np.full(len(left) + 1, -1)  # one more, for who asks where none are
        later[:-1][left] = np.arange(first, first + int(left.sum()))
        return cls(first, left, later)

    def __len__(self) -> int:
        """How many rows there were."""
        return self.first + len(self.left)

    def __getitem__(self, rows: Integers) -> Integers:
        """The new rows of old ones."""
        later: Integers = self._later[np.maximum(rows - self.first, 0)]
        return np.where(rows < self.first, rows, later)
