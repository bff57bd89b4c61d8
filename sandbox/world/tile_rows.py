"""Which shapes are tiles, where they lie, and where their rows in the seam table are."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TypeAlias

import numpy as np

from sandbox.tables import Floats, Integers, aligned_zeros, close_up, longer
from sandbox.world.new_rows import NewRows
from sandbox.world.tile_outlines import Outlines

NO_TILES: Integers = np.zeros(0, np.int64)

Bounds: TypeAlias = tuple[float, float, float, float]
"""Left, low, right and high sides of a box, m."""


def _nowhere() -> Floats:
    return aligned_zeros(0, np.float64)


@dataclass
class TileBoxes:
    """The boxes of the first tiles (m), as many as were asked for."""

    left: Floats = field(default_factory=_nowhere)
    low: Floats = field(default_factory=_nowhere)
    right: Floats = field(default_factory=_nowhere)
    high: Floats = field(default_factory=_nowhere)

    def __len__(self) -> int:
        return len(self.left)

    def add(self, outlines: Outlines) -> None:
        """Those of further tiles."""
        for name, sides in _sides(outlines):
            setattr(self, name, longer(getattr(self, name), sides))

    def put(self, places: Integers, outlines: Outlines) -> None:
        """Those of tiles that lie elsewhere now."""
        for name, sides in _sides(outlines):
            getattr(self, name)[places] = sides

    def bounds(self, places: Integers) -> Bounds:
        """The box around some of them."""
        return (
            float(self.left[places].min()), float(self.low[places].min()),
            float(self.right[places].max()), float(self.high[places].max()),
        )  # fmt: skip

    def near(self, bounds: Bounds, slack: float) -> Integers:
        """The places of those that reach into a box, but for so many metres."""
        left, low, right, high = bounds
        near = (self.right >= left - slack) & (self.left <= right + slack)
        near &= (self.high >= low - slack) & (self.low <= high + slack)
        return np.flatnonzero(near)


def bounds_of(outlines: Outlines) -> Bounds:
    """The box around some outlines."""
    return float(outlines.x.min()), float(outlines.y.min()), float(outlines.x.max()), float(outlines.y.max())


def _sides(outlines: Outlines) -> Iterator[tuple[str, Floats]]:
    for name, farthest, corners in (
        ("left", np.minimum, outlines.x), ("low", np.minimum, outlines.y),
        ("right", np.maximum, outlines.x), ("high", np.maximum, outlines.y),
    ):  # fmt: skip
        yield name, farthest.reduceat(corners, outlines.starts)


@dataclass
class Tiling:
    """The tiles of a state, `rows` of the shape table, ascending; `joined` are those that got rows in the seam table as
    tiles: all but parts of concave polygons and chains. They come after the `own` rows that shapes came with."""

    rows: Integers
    joined: Integers
    own: int
    boxes: TileBoxes = field(default_factory=TileBoxes)

    def add(self, rows: Integers, joined: Integers) -> None:
        """Further tiles, after all others."""
        self.rows, self.joined = longer(self.rows, rows), longer(self.joined, joined)

    def going(self, rows: NewRows) -> Integers:
        """The tiles that go when shapes get new rows."""
        behind = self.rows[np.searchsorted(self.rows, rows.first) :]
        return behind[rows[behind] < 0]

    def remove(self, rows: NewRows) -> None:
        """Shapes get new rows: some tiles go."""
        first = int(np.searchsorted(self.rows, rows.first))
        if first == len(self.rows):  # as where a level came first and what plays in it comes and goes
            return
        left = rows[self.rows[first:]] >= 0
        for name, column in vars(self.boxes).items():
            known = max(len(column) - first, 0)
            setattr(self.boxes, name, column[: len(column) - known + close_up(column[first:], left[:known])])
        self.rows, self.joined = (_renumbered(column, rows) for column in (self.rows, self.joined))


def _renumbered(column: Integers, rows: NewRows) -> Integers:
    """Ascending rows without those that go."""
    first = int(np.searchsorted(column, rows.first))
    later = rows[column[first:]]
    later = later[later >= 0]
    column[first : first + len(later)] = later
    return column[: first + len(later)]
