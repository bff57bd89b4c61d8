"""Reads a tileset."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.formats.numbers import Vec
from sandbox.formats.reading import Node
from sandbox.formats.remarks import Remarks
from sandbox.formats.tiled.figures import Figure, figure_of, outline_of, turned_about_origin
from sandbox.formats.tiled.grid import Grid
from sandbox.formats.tiled.tileset import CELL, Solid, Tileset
from sandbox.formats.tiled.traits import is_solid, surface_words


def read_tileset(node: Node, first: int, remarks: Remarks) -> Tileset:
    """The tileset whose tiles are numbered from `first` on. Raises `MisreadError`."""
    offset = node.node("tileoffset")
    found = Tileset(
        first,
        (node.number("tilewidth", 1.0), node.number("tileheight", 1.0)),
        (offset.number("x"), offset.number("y")) if offset else (0.0, 0.0),
        node.text("objectalignment", "unspecified"),
    )
    if node.text("tilerendersize", "tile") != "tile":
        remarks.note(node.place, "tiles are as large as their images, not drawn to the size of cells")
    for number, tile in _tiles(node):
        solids: list[Solid] = []
        if tile.has("imagewidth") and tile.has("imageheight"):
            whole = (tile.number("imagewidth"), tile.number("imageheight"))
            found.sizes[number] = (tile.number("width", whole[0]), tile.number("height", whole[1]))
        group = tile.node("objectgroup")
        for shape in group.nodes("objects") if group else ():
            figure = figure_of(shape, remarks)
            if figure is not None:
                seen = _seen(_in_tile(figure, shape), node, found.sizes.get(number, found.size))
                solids.append((seen, surface_words(shape) or surface_words(tile)))
        if not solids and is_solid(tile):
            solids.append((CELL, surface_words(tile)))
        if solids:
            found.solids[number] = solids
    return found


def _seen(figure: Figure, tileset: Node, size: Vec) -> Figure:
    """What was drawn over a tile, where the grid below it was an isometric one."""
    grid = tileset.node("grid")
    if grid is None or grid.text("orientation", "orthogonal") != "isometric":
        return figure
    cell = Grid("isometric", (grid.number("width", 1.0) or 1.0, grid.number("height", 1.0) or 1.0), (1.0, 1.0))
    lift = size[1] - cell.tile[1]
    return outline_of(figure).mapped(cell.project).mapped(lambda point: (point[0], point[1] + lift))


def _in_tile(figure: Figure, shape: Node) -> Figure:
    x, y = shape.number("x"), shape.number("y")
    leaning = turned_about_origin(figure, shape.number("rotation"))
    return leaning.mapped(lambda point: (point[0] + x, point[1] + y))


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
            yield int(key), type(node)(entry | {"properties": beside.get(key, {})}, (*node.path, "tiles", key))
