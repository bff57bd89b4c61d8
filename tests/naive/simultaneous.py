"""Impacts that fall together, by trying who pushes: the complementarity problem of a few contacts."""

from __future__ import annotations

from itertools import combinations

import numpy as np


def impulses_of(coupling: np.ndarray, closing: np.ndarray, restitution: np.ndarray) -> np.ndarray:
    """Normal impulses (N s) of contacts that close at these speeds (m/s), all of them at once.

    `coupling` (n, n) says by how much a unit impulse at one opens another. Each opens with its restitution times the
    speed at which it closed, or faster, and then without an impulse.
    """
    count = len(closing)
    wanted = (1.0 + restitution) * closing
    for size in range(count, -1, -1):
        for pushing in map(list, combinations(range(count), size)):
            found = np.zeros(count)
            if pushing:
                found[pushing] = np.linalg.lstsq(coupling[np.ix_(pushing, pushing)], wanted[pushing], rcond=None)[0]
            gained = coupling @ found
            if np.all(found >= -1e-9) and np.all(gained >= wanted - 1e-9):
                return found
    raise ValueError("no contacts solve this problem")
