"""Where cells and objects of a map are in its picture, whatever way the map lies.

Source: `orthogonalrenderer.cpp`, `isometricrenderer.cpp` and `hexagonalrenderer.cpp` of Tiled (staggered maps are
hexagonal ones whose sides have no length). Pixels, y down.
"""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.formats.numbers import Vec
from sandbox.formats.reading import MisreadError, Node
from sandbox.formats.tiled.figures import Figure

WAYS = ("orthogonal", "isometric", "staggered", "hexagonal")
"""The orientations of maps."""


@dataclass(frozen=True)
class Grid:
    """`way` is the orientation, `tile` the size of a cell, `size` columns and rows of the map.

    Of hexagons: the length of a `side`, and whether columns (`by_column`) or rows are shifted, the `even` ones or the
    odd ones.
    """

    way: str
    tile: Vec
    size: Vec
    side: float = 0.0
    by_column: bool = False
    even: bool = False

    @property
    def is_affine(self) -> bool:
        """Whether cells side by side make one larger cell."""
        return self.way in WAYS[:2]

    @property
    def height(self) -> float:
        """Of the picture."""
        height, (columns, rows) = self.tile[1], self.size
        if self.way == "isometric":
            return (columns + rows) * height / 2.0
        if self.way == "orthogonal":
            return rows * height
        slant, straight = self._slant
        if self.by_column:
            return rows * height + (slant if columns > 1 else 0.0)
        return rows * (slant + straight) + slant

    def project(self, point: Vec) -> Vec:
        """A point of an object in the picture."""
        if self.way != "isometric":
            return point
        width, height = self.tile
        x, y = point[0] / height, point[1] / height
        return (x - y + self.size[1]) * width / 2.0, (x + y) * height / 2.0

    def turned(self, step: Vec) -> Vec:
        """A way from one point of an object to another in the picture."""
        (x, y), (left, top) = self.project(step), self.project((0.0, 0.0))
        return x - left, y - top

    def lower_left(self, column: int, row: int) -> Vec:
        """The corner of the box around a cell at which tiles stand."""
        width, height = self.tile
        if self.way == "orthogonal":
            return column * width, (row + 1) * height
        if self.way == "isometric":
            return (column - row + self.size[1] - 1) * width / 2.0, (column + row + 2) * height / 2.0
        slant, straight = self._slant
        across, down = (self.side, 0.0) if self.by_column else (0.0, self.side)
        if self.by_column:
            shift = (height + down) / 2.0 if self._shifted(column) else 0.0
            return column * ((width - across) / 2.0 + across), row * height + shift + height
        shift = (width - across) / 2.0 if self._shifted(row) else 0.0
        return column * width + shift, row * (slant + straight) + height

    def area(self, column: int, row: int, columns: int = 1, rows: int = 1) -> Figure:
        """Cells that make one of an affine grid, or one cell of another, in the picture."""
        (width, height), (x, y) = self.tile, self.lower_left(column, row)
        if self.is_affine:
            unit = (height, height) if self.way == "isometric" else self.tile
            xs, ys = ([value * unit[0] for value in (column, column + columns)],
                      [value * unit[1] for value in (row, row + rows)])  # fmt: skip
            corners = ((xs[0], ys[0]), (xs[1], ys[0]), (xs[1], ys[1]), (xs[0], ys[1]))
            return Figure("box" if self.way == "orthogonal" else "polygon", tuple(map(self.project, corners)))
        if self.by_column:
            slant = (width - self.side) / 2.0
            ring = [(0.0, height / 2.0), (slant, 0.0), (width - slant, 0.0), (width, height / 2.0),
                    (width - slant, height), (slant, height)]  # fmt: skip
        else:
            slant = (height - self.side) / 2.0
            ring = [(width / 2.0, 0.0), (width, slant), (width, height - slant), (width / 2.0, height),
                    (0.0, height - slant), (0.0, slant)]  # fmt: skip
        return Figure("polygon", tuple((x + px, y - height + py) for px, py in ring))

    @property
    def _slant(self) -> Vec:
        """Of a hexagon's height the part at a slant, above or below, and the straight one."""
        straight = 0.0 if self.by_column else self.side
        return (self.tile[1] - straight) / 2.0, straight

    def _shifted(self, number: int) -> bool:
        return (number % 2 == 1) != self.even


def grid_of(root: Node) -> Grid:
    """The grid of a map. Raises `MisreadError`."""
    tile = (root.number("tilewidth", 32.0), root.number("tileheight", 32.0))
    if min(tile) < 1.0:
        raise MisreadError(("tilewidth",), "tiles must be at least a pixel wide and high")
    way = root.text("orientation", "orthogonal")
    by_column = root.text("staggeraxis", "y") == "x"
    side = root.number("hexsidelength") if way == "hexagonal" else 0.0
    if not 0.0 <= side <= tile[0 if by_column else 1]:
        raise MisreadError(("hexsidelength",), "the side of a hexagon must be 0 to the size of a tile")
    size = (root.number("width"), root.number("height"))
    return Grid(way, tile, size, side, by_column, root.text("staggerindex", "odd") == "even")
