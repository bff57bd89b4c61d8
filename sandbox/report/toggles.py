"""What is on or off over a film, as the samples at which it changes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def toggles(on: NDArray[np.bool_]) -> list[int]:
    """The samples at which a row of switches (n,) changes; it is off before the first."""
    changes: list[int] = np.flatnonzero(np.diff(on.astype(np.int8), prepend=0)).tolist()
    return changes
