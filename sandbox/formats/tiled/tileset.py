"""A tileset: which of its tiles are solid, and where."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from sandbox.formats.numbers import Vec, turned
from sandbox.formats.outlines import Words
from sandbox.formats.tiled.cells import FLIPPED_X, FLIPPED_Y, SWAPPED, TURNED
from sandbox.formats.tiled.figures import Figure

Solid = tuple[Figure, Words]
"""A figure in the frame of its tile (pixels from the upper left corner, y down), and its surface."""

CELL = Figure("cell", ())
"""All of the cell, whatever form cells have."""


@dataclass
class Tileset:
    """Tiles from the number `first` on, each `size` (width, height) pixels, those of `sizes` others; `solids` by the
    tile's own number.
    """

    first: int
    size: Vec
    offset: Vec = (0.0, 0.0)
    alignment: str = "unspecified"
    solids: dict[int, list[Solid]] = field(default_factory=dict)
    sizes: dict[int, Vec] = field(default_factory=dict)

    def size_of(self, number: int) -> Vec:
        """Width and height of a tile, by its number over all tilesets."""
        return self.sizes.get(number - self.first, self.size)

    def solids_of(self, number: int) -> list[Solid]:
        """What of a tile is solid, by its number over all tilesets."""
        return self.solids.get(number - self.first, [])


def box(size: Vec) -> Figure:
    """A whole tile."""
    width, height = size
    return Figure("box", ((0.0, 0.0), (width, 0.0), (width, height), (0.0, height)))


def flipped(figure: Figure, size: Vec, flips: int, hexagonal: bool = False) -> Figure:
    """A figure of a tile that is mirrored, or turned, in its cell; its lower left corner stays where it is."""
    width, height = (size[1], size[0]) if flips & SWAPPED and not hexagonal else size

    def move(point: Vec) -> Vec:
        x, y = point
        if flips & SWAPPED and not hexagonal:
            x, y = y, x
        x, y = (width - x if flips & FLIPPED_X else x), (height - y if flips & FLIPPED_Y else y)
        return x, y + size[1] - height

    def turn(point: Vec) -> Vec:
        degrees = 60.0 * bool(flips & SWAPPED) + 120.0 * bool(flips & TURNED)
        x, y = turned((point[0] - width / 2.0, point[1] - height / 2.0), math.radians(degrees))
        return x + width / 2.0, y + height / 2.0

    moved = figure.mapped(move) if flips else figure
    return moved.mapped(turn) if hexagonal and flips & (SWAPPED | TURNED) else moved
