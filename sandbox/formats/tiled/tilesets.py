"""All tilesets of a map, inside and beside it."""

from __future__ import annotations

import bisect
from pathlib import Path

from sandbox.formats.reading import Node
from sandbox.formats.remarks import Remarks
from sandbox.formats.tiled.beside import Beside
from sandbox.formats.tiled.tileset import Tileset
from sandbox.formats.tiled.tileset_file import read_tileset
from sandbox.formats.tiled.tmx import tileset_of

_BORROWED = 1 << 27
"""Tiles of tilesets that templates alone use are numbered from here on."""


class Tilesets:
    """All tilesets of a map, and those of its templates."""

    def __init__(self, root: Node, folder: Path, remarks: Remarks) -> None:
        """Reads those that lie beside the map, too. Raises `MisreadError` and `SceneError`."""
        self._beside, self._remarks = Beside(folder, tileset_of), remarks
        self._sets: list[Tileset] = []
        self._firsts: list[int] = []
        self._borrowed: dict[Path, int] = {}
        for node in root.nodes("tilesets"):
            self._add(self._tileset(node))

    @property
    def has_shapes(self) -> bool:
        """Whether any tile is solid."""
        return any(tiles.solids for tiles in self._sets)

    def of(self, number: int) -> Tileset | None:
        """The tileset that holds the tile of that number, None if it is not there."""
        index = bisect.bisect_right(self._firsts, number) - 1
        return self._sets[index] if index >= 0 else None

    def borrowed(self, path: Path) -> int:
        """The number of the first tile of a tileset that a template uses. Raises `SceneError`."""
        if path not in self._borrowed:
            first = _BORROWED + (len(self._borrowed) << 16)
            self._borrowed[path] = first
            self._add(self._outside(str(path.name), Beside(path.parent, tileset_of), first, str(path.name)))
        return self._borrowed[path]

    def _add(self, tiles: Tileset) -> None:
        at = bisect.bisect_right(self._firsts, tiles.first)
        self._sets.insert(at, tiles)
        self._firsts.insert(at, tiles.first)

    def _tileset(self, node: Node) -> Tileset:
        first, name = node.whole("firstgid", 1), node.text("source")
        return (
            self._outside(name, self._beside, first, node.place) if name else read_tileset(node, first, self._remarks)
        )

    def _outside(self, name: str, beside: Beside, first: int, place: str) -> Tileset:
        """One in a file of its own; one without tiles, with a remark, if that is not there."""
        found = beside.read(name, lambda node, _: read_tileset(node, first, self._remarks))
        if found is None:
            self._remarks.note(f'{place} "{name[:60]}"', "a tileset is left out: it is not beside the map")
        return found or Tileset(first, (1.0, 1.0))
