"""The symbolic half of a sparse LDL^T factorisation: which entries the factor has, found once a world."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sandbox.engine.joints.elimination import Elimination
from sandbox.tables import Integers


@dataclass(frozen=True)
class Pattern:
    """The lower triangle of a factor of `rows` rows: column r begins at `starts[r]` with its diagonal; `row_of` names
    the row of each entry and `keys` column and row at once, ascending. Eliminating a column with m entries below the
    diagonal subtracts from m (m + 1) / 2 others: `targets` lists them in that order."""

    rows: int
    starts: Integers
    row_of: Integers
    keys: Integers
    targets: Integers

    def entries(self, columns: Integers, rows: Integers) -> Integers:
        """Where entries lie."""
        return np.searchsorted(self.keys, columns * self.rows + rows)


def runs(first: Integers, counts: Integers) -> Integers:
    """Numbers from each `first` on, so many each, one after another."""
    ends = np.cumsum(counts)
    return np.arange(int(ends[-1]) if len(ends) else 0) + np.repeat(first - ends + counts, counts)


def symbolic(elimination: Elimination, first: Integers, counts: Integers, rows: int) -> Pattern:
    """The pattern of a factor of `rows` rows, of which joint after joint has `counts` from row `first` on, both in the
    order of elimination. Rows of no joint have no column."""
    # A joint's own rows, then those of the joints below it, are what all its columns are made of.
    links = np.diff(elimination.ends, prepend=0)
    begins = np.cumsum(links + 1) - links - 1
    joints = np.insert(elimination.below, elimination.ends - links, np.arange(len(counts)))
    lengths = np.add.reduceat(counts[joints], begins)
    numbers = runs(first[joints], counts[joints])
    column = runs(first, counts)
    own = runs(np.zeros_like(counts), counts)  # of its joint's rows which a column is
    sizes = np.repeat(lengths, counts) - own
    row_of = numbers[runs(np.repeat(np.cumsum(lengths) - lengths, counts) + own, sizes)]
    starts = np.cumsum(sizes) - sizes
    keys = np.repeat(column, sizes) * rows + row_of
    below = runs(starts + 1, sizes - 1)
    left = np.repeat(starts + sizes, sizes - 1) - below
    targets = np.repeat(row_of[below], left) * rows + row_of[runs(below, left)]
    return Pattern(rows, starts, row_of, keys, np.searchsorted(keys, targets))
