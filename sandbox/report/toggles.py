"""What is on or off over a film, as the samples at which it changes."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray


def toggles(on: NDArray[np.bool_]) -> list[list[int]]:
    """The samples at which each row of switches (n, samples) changes; all are off before the first."""
    rows, samples = np.nonzero(np.diff(on.astype(np.int8), axis=1, prepend=0))
    ends = np.searchsorted(rows, np.arange(len(on) + 1)).tolist()
    changes = samples.tolist()
    return [changes[first:last] for first, last in pairwise(ends)]
