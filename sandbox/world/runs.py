"""Runs of rows: things that have several rows each, which lie one after the other in a table."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np

from sandbox.tables import Integers

Counts: TypeAlias = Integers
"""How many rows each thing has."""


def run_starts(counts: Counts) -> Integers:
    """Where the rows of each begin when all lie one after the other."""
    starts: Integers = np.cumsum(counts) - counts
    return starts


def runs(starts: Integers, counts: Counts) -> Integers:
    """The numbers from each start on, as many as its count, one run after the other."""
    numbers: Integers = np.repeat(starts - run_starts(counts), counts) + np.arange(int(counts.sum()))
    return numbers


def owners(counts: Counts) -> Integers:
    """Whose each row is."""
    return np.repeat(np.arange(len(counts)), counts)


def neighbours_in_rings(counts: Counts) -> tuple[Integers, Integers]:
    """The rows before and after each row, where the rows of each thing are a ring."""
    rows = np.arange(int(counts.sum()))
    first = run_starts(counts)[counts > 0]
    last = first + counts[counts > 0] - 1
    before, after = rows - 1, rows + 1
    before[first], after[last] = last, first
    return before, after
