"""Tilesets: which tiles are solid, and where."""

from __future__ import annotations

import bisect
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from sandbox.formats.numbers import Vec
from sandbox.formats.open_file import open_source
from sandbox.formats.outlines import Words
from sandbox.formats.reading import MisreadError, Node
from sandbox.formats.remarks import Remarks
from sandbox.formats.source import Source
from sandbox.formats.tiled.cells import FLIPPED_X, FLIPPED_Y, SWAPPED
from sandbox.formats.tiled.figures import Figure, figure_of, turned_about_origin
from sandbox.formats.tiled.tmx import tileset_of
from sandbox.formats.tiled.traits import is_solid, surface_words
from sandbox.formats.xml_tree import Element

Solid = tuple[Figure, Words]
"""A figure in the frame of its tile (pixels from the upper left corner, y down), and its surface."""


@dataclass
class Tileset:
    """Tiles from the number `first` on, each `size` (width, height) pixels; `solids` by the tile's own number."""

    first: int
    size: Vec
    offset: Vec
    alignment: str
    solids: dict[int, list[Solid]] = field(default_factory=dict)

    def box(self) -> Figure:
        """A whole tile."""
        (width, height) = self.size
        return Figure("box", ((0.0, 0.0), (width, 0.0), (width, height), (0.0, height)))


class Tilesets:
    """All tilesets of a map."""

    def __init__(self, root: Node, folder: Path, remarks: Remarks) -> None:
        """Reads those that lie beside the map, too. Raises `MisreadError` and `SceneError`."""
        found = [_tileset(node, folder, remarks) for node in root.nodes("tilesets")]
        self._sets = sorted((each for each in found if each), key=lambda each: each.first)
        self._firsts = [each.first for each in self._sets]

    def of(self, number: int) -> Tileset | None:
        """The tileset that holds the tile of that number, None if it is not there."""
        index = bisect.bisect_right(self._firsts, number) - 1
        return self._sets[index] if index >= 0 else None


def flipped(figure: Figure, size: Vec, flips: int) -> Figure:
    """A figure of a tile that is mirrored in its cell."""

    def move(point: Vec) -> Vec:
        x, y = point
        if flips & SWAPPED:
            x, y = y, x
        return (size[0] - x if flips & FLIPPED_X else x), (size[1] - y if flips & FLIPPED_Y else y)

    return figure.mapped(move) if flips else figure


def _tileset(node: Node, folder: Path, remarks: Remarks) -> Tileset | None:
    first = node.whole("firstgid", 1)
    name = node.text("source")
    if not name:
        return _read(node, first, remarks)
    path = folder / name
    if Path(name).is_absolute() or not path.is_file():
        remarks.note(f'{node.place} "{name[:60]}"', "a tileset is left out: it is not beside the map")
        return None
    source = open_source(path)
    try:
        return _read(Node(_data(source)), first, remarks)
    except MisreadError as error:
        raise source.error(error) from None


def _data(source: Source) -> dict[str, Any]:
    data = tileset_of(source.data) if isinstance(source.data, Element) else source.data
    if not isinstance(data, dict):
        raise MisreadError((), "this is no tileset")
    return data


def _read(node: Node, first: int, remarks: Remarks) -> Tileset:
    offset = node.node("tileoffset")
    found = Tileset(
        first,
        (node.number("tilewidth", 1.0), node.number("tileheight", 1.0)),
        (offset.number("x"), offset.number("y")) if offset else (0.0, 0.0),
        node.text("objectalignment", "unspecified"),
    )
    for number, tile in _tiles(node):
        solids: list[Solid] = []
        group = tile.node("objectgroup")
        for shape in group.nodes("objects") if group else ():
            figure = figure_of(shape, remarks)
            if figure is not None:
                solids.append((_in_tile(figure, shape), surface_words(shape) or surface_words(tile)))
        if not solids and is_solid(tile):
            solids.append((found.box(), surface_words(tile)))
        if solids:
            found.solids[number] = solids
    return found


def _in_tile(figure: Figure, shape: Node) -> Figure:
    x, y = shape.number("x"), shape.number("y")
    turned = turned_about_origin(figure, shape.number("rotation"))
    return turned.mapped(lambda point: (point[0] + x, point[1] + y))


def _tiles(node: Node) -> Iterator[tuple[int, Node]]:
    """Tiles with their numbers: a list in new files, an object with the properties beside it in old ones."""
    given = node.data.get("tiles")
    if not isinstance(given, dict):
        for tile in node.nodes("tiles"):
            yield tile.whole("id"), tile
        return
    beside = node.data.get("tileproperties")
    beside = beside if isinstance(beside, dict) else {}
    for key in [*given, *(key for key in beside if key not in given)]:
        entry = dict(given[key]) if isinstance(given.get(key), dict) else {}
        if key.isdecimal():
            yield int(key), Node(entry | {"properties": beside.get(key, {})}, (*node.path, "tiles", key))
