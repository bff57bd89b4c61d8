"""The solid tiles of a layer as the shapes of one body."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from sandbox.formats.reading import Node
from sandbox.formats.remarks import Remarks
from sandbox.formats.tiled.cells import Cell, cells_of
from sandbox.formats.tiled.figures import Figure
from sandbox.formats.tiled.grid import Grid
from sandbox.formats.tiled.merge import merged
from sandbox.formats.tiled.tileset import CELL, Solid, Tileset, box, flipped
from sandbox.formats.tiled.tilesets import Tilesets
from sandbox.formats.tiled.traits import is_solid

_NAMES = {"collision", "collisions", "collider", "colliders", "solid", "solids", "wall", "walls", "ground", "floor",
          "platform", "platforms", "terrain", "block", "blocks", "obstacle", "obstacles"}  # fmt: skip


@dataclass(frozen=True)
class TileLayers:
    """Reads tile layers. Those `asked` for are solid all over; where nothing else is solid, others `by_name`."""

    grid: Grid
    sets: Tilesets
    asked: tuple[str, ...]
    by_name: bool
    remarks: Remarks

    def solids(self, layer: Node) -> list[Solid]:
        """The solid figures of a layer, in pixels of the picture, and their surfaces. Raises `MisreadError`."""
        cells = list(cells_of(layer))
        solid = is_solid(layer) or layer.text("name") in self.asked or (self.by_name and self._named(layer, cells))
        whole: list[tuple[int, int]] = []
        found: list[Solid] = []
        empty = 0
        for cell in cells:
            tiles = self.sets.of(cell.tile)
            solids = tiles.solids_of(cell.tile) if tiles else []
            if not (solids or solid):
                empty += 1
            elif self._fills(solids, tiles, cell, solid):
                whole.append((cell.column, cell.row))
            else:
                found += self._placed(solids or [(CELL, {})], tiles, cell)
        if empty:
            self.remarks.note(f"{layer.place} ({empty})", "tiles without a collision shape are left out")
        return found + [(figure, {}) for figure in self._areas(whole)]

    def _named(self, layer: Node, cells: list[Cell]) -> bool:
        words = re.findall(r"[a-z]+", re.sub(r"([a-z])([A-Z])", r"\1 \2", layer.text("name")).lower())
        columns, rows = self.grid.size
        if not cells or len(cells) >= columns * rows or not _NAMES.intersection(words):
            return False
        self.remarks.note(layer.place, "no tile has a collision shape: a layer is solid all over, as its name says")
        return True

    def _fills(self, solids: list[Solid], tiles: Tileset | None, cell: Cell, solid: bool) -> bool:
        """Whether the tile is solid in all of its cell, and nothing else is to be said of it."""
        if tiles is None or solid or solids == [(CELL, {})]:
            return tiles is None or not self._is_square or tiles.size_of(cell.tile) == self.grid.tile
        return self._is_square and tiles.size_of(cell.tile) == self.grid.tile and solids == [(box(self.grid.tile), {})]

    def _placed(self, solids: list[Solid], tiles: Tileset | None, cell: Cell) -> list[Solid]:
        left, low = self.grid.lower_left(cell.column, cell.row)
        size, offset = (tiles.size_of(cell.tile), tiles.offset) if tiles else (self.grid.tile, (0.0, 0.0))
        x, y = left + offset[0], low - size[1] + offset[1]
        hexagonal = self.grid.way == "hexagonal"
        found: list[Solid] = []
        for figure, surface in solids:
            if figure == CELL and not self._is_square:
                found.append((self.grid.area(cell.column, cell.row), surface))
                continue
            seen = flipped(box(size) if figure == CELL else figure, size, cell.flips, hexagonal)
            found.append((seen.mapped(lambda point: (point[0] + x, point[1] + y)), surface))
        return found

    def _areas(self, whole: Iterable[tuple[int, int]]) -> list[Figure]:
        if not self.grid.is_affine:
            return [self.grid.area(column, row) for column, row in whole]
        return [self.grid.area(*each) for each in merged(whole)]

    @property
    def _is_square(self) -> bool:
        return self.grid.way == "orthogonal"
