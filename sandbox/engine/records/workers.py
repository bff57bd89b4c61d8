"""What the threads of a step share to divide a task."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sandbox.tables import Floats, Integers, aligned_zeros

WORDS = 64
"""Whole numbers that threads share, see `workers.parallel_for`: a cache line for each that is written often."""
SIZE = 0
"""Word: how many workers take part in a step."""
NUMBERS = 32
"""Numbers that a worker tells the others, or itself when it is alone: whole cache lines."""
FROZEN, AWAKE, DRIVEN, RESTED, FAST, BROKEN = 4, 5, 6, 7, 8, 9
"""Words: how many bodies were frozen, are awake, driven and moving, slow long enough to sleep, and to be swept; and how
many joints broke."""


class Workers(NamedTuple):
    """`words` and `numbers` tell of the task under way. `number` says which worker this is meant for: 0 is the one that
    takes the step. `alone` are words of one who shares nothing.
    """

    words: Integers
    numbers: Floats
    number: int
    alone: Integers


def workers_memory(count: int) -> Workers:
    """Memory for so many workers, of which only the first takes part until `words` says otherwise."""
    words, alone = aligned_zeros(WORDS, np.int64), aligned_zeros(WORDS, np.int64)
    words[SIZE] = alone[SIZE] = 1
    return Workers(words, aligned_zeros(count * NUMBERS, np.float64), 0, alone)
