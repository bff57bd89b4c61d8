"""A map of Tiled as a scene: an object is a body, and so are all the solid tiles of a layer."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

from sandbox.formats.centred import centred
from sandbox.formats.draft import Draft
from sandbox.formats.numbers import Vec, tidy, tidy_point
from sandbox.formats.outlines import Words
from sandbox.formats.reading import MisreadError, Node
from sandbox.formats.source import Options, Source
from sandbox.formats.tiled.cells import NUMBER
from sandbox.formats.tiled.figures import figure_of, outline_of, shape_words
from sandbox.formats.tiled.grid import WAYS, grid_of
from sandbox.formats.tiled.templates import Templates
from sandbox.formats.tiled.tile_layers import TileLayers
from sandbox.formats.tiled.tiled_node import TiledNode
from sandbox.formats.tiled.tileset import CELL, Solid, box, flipped
from sandbox.formats.tiled.tilesets import Tilesets
from sandbox.formats.tiled.tmx import line_in, map_of
from sandbox.formats.tiled.traits import body_words, is_solid, kind_of, note_others, surface_words
from sandbox.formats.xml_tree import Element

_ALIGNED = {
    "topleft": (0.0, 0.0), "top": (0.5, 0.0), "topright": (1.0, 0.0), "left": (0.0, 0.5), "center": (0.5, 0.5),
    "right": (1.0, 0.5), "bottomleft": (0.0, 1.0), "bottom": (0.5, 1.0), "bottomright": (1.0, 1.0),
}  # fmt: skip
"""Where in a tile the point lies that a tile object stands at, as shares of its width and height."""


_NOTHING_SOLID = 'nothing is solid: give tiles a collision shape, or a tile or layer the property "solid" in Tiled'


def is_tiled(data: Any) -> bool:
    """Whether parsed JSON or XML is a map of Tiled."""
    if isinstance(data, Element):
        return data.tag == "map"
    return isinstance(data, dict) and isinstance(data.get("layers"), list) and "tilewidth" in data


def read_tiled(source: Source, draft: Draft, options: Options) -> None:
    """Bring all of the map into the draft. Raises `MisreadError` and `SceneError`."""
    if not isinstance(source.data, Element):
        _Reader(TiledNode(source.data), source, draft, options).read()
        return
    data = map_of(source.data)
    try:
        _Reader(TiledNode(data), source, draft, options).read()
    except MisreadError as error:
        raise Source(source.path, source.text, data, line_in(data)).error(error) from None


class _Reader:
    def __init__(self, root: Node, source: Source, draft: Draft, options: Options) -> None:
        self._root, self._draft, self._remarks = root, draft, draft.remarks
        self._grid, folder = grid_of(root), source.path.parent
        self._pixels = options.units_per_metre or self._grid.tile[1]
        self._tolerance, self._asked = options.tolerance, options.solid
        self._bottom = 0.0 if root.flag("infinite") else self._grid.height
        self._sets = Tilesets(root, folder, self._remarks)
        self._templates = Templates(folder, self._sets, self._remarks)

    def read(self) -> None:
        if self._grid.way not in WAYS:
            self._remarks.note("", f"the map is {self._grid.way[:20]}: places are read as of an orthogonal one")
            self._grid = replace(self._grid, way="orthogonal")
        note_others(self._root, self._remarks)
        names = [layer.text("name") for layer in _tile_layers(self._root)]
        shown = ", ".join(f'"{name[:40]}"' for name in names[:6]) + (", ..." if len(names) > 6 else "")
        if missing := [name for name in self._asked if name not in names]:
            raise MisreadError(("layers",), f'no tile layer is named "{missing[0][:40]}"; there are {shown or "none"}')
        by_name = not (self._asked or self._sets.has_shapes or _is_any(self._root, _says_solid))
        self._tiles = TileLayers(self._grid, self._sets, self._asked, by_name, self._remarks)
        self._read_layers(self._root, (0.0, 0.0), "")
        self._draft.if_empty = _NOTHING_SOLID + (f"; or import it with --solid LAYER ({shown})" if names else "")

    def _read_layers(self, parent: Node, offset: Vec, kind: str) -> None:
        for layer in parent.nodes("layers"):
            shift = (offset[0] + layer.number("offsetx"), offset[1] + layer.number("offsety"))
            asked = kind_of(layer) or kind
            if (layer.number("parallaxx", 1.0), layer.number("parallaxy", 1.0)) != (1.0, 1.0):
                self._remarks.note(layer.place, "parallax is left out: a layer stands where it is on the map")
            match layer.text("type"):
                case "group":
                    self._read_layers(layer, shift, asked)
                case "objectgroup":
                    for node in layer.nodes("objects"):
                        self._read_object(node, shift, asked)
                case "tilelayer":
                    self._read_tiles(layer, shift, asked)
                case other:
                    self._remarks.note(layer.place, f"a layer of the type {other[:20]} is left out")
            note_others(layer, self._remarks)

    def _read_object(self, instance: Node, shift: Vec, asked: str) -> None:
        node = self._templates.filled(instance)
        if node is None:
            return
        note_others(node, self._remarks)
        x, y = self._grid.project((node.number("x"), node.number("y")))
        asked = kind_of(node) or asked
        solids = self._tile_solids(node, asked) if node.has("gid") else self._own_solid(node)
        shapes = [words for solid in solids for words in self._words(solid, node.place)]
        if not shapes:
            return
        kind = asked or "static"
        words: Words = {} if kind == "dynamic" else {"type": kind}
        words |= {"position": self._metres((x + shift[0], y + shift[1])), "shapes": shapes}
        if rotation := tidy(-node.number("rotation")):
            words["angle"] = rotation
        if kind != "static":
            words |= body_words(node)
        self._draft.add_body(node.text("name"), centred(words) if len(shapes) == 1 else words, node.place)

    def _own_solid(self, node: Node) -> list[Solid]:
        figure = figure_of(node, self._remarks)
        if figure is None:
            return []
        if self._grid.way == "isometric":
            figure = outline_of(figure).mapped(self._grid.turned)
        return [(figure, surface_words(node))]

    def _tile_solids(self, node: Node, asked: str) -> list[Solid]:
        """The shapes of the tile that stands as an object: all of it, where a type of body says that it is one."""
        gid = node.whole("gid")
        number, flips = gid & NUMBER, gid & ~NUMBER
        tiles = self._sets.of(number)
        solids = tiles.solids_of(number) if tiles else []
        if not solids and (asked or is_solid(node)):
            solids = [(CELL, {})]
        if tiles is None or not solids:
            self._remarks.note(node.place, "a tile without a collision shape is left out")
            return []
        size = tiles.size_of(number)
        width, height = node.number("width", size[0]), node.number("height", size[1])
        usual = "bottom" if self._grid.way == "isometric" else "bottomleft"
        share = _ALIGNED.get(tiles.alignment, _ALIGNED[usual])
        scale = width / max(size[0], 1e-9), height / max(size[1], 1e-9)
        shift = tiles.offset[0] * scale[0] - share[0] * width, tiles.offset[1] * scale[1] - share[1] * height

        def move(point: Vec) -> Vec:
            return point[0] * scale[0] + shift[0], point[1] * scale[1] + shift[1]

        own = surface_words(node)
        figures = [(box(size) if figure == CELL else figure, surface) for figure, surface in solids]
        return [(flipped(figure, size, flips).mapped(move), surface | own) for figure, surface in figures]

    def _read_tiles(self, layer: Node, shift: Vec, asked: str) -> None:
        shapes = [words for solid in self._tiles.solids(layer) for words in self._words(solid, layer.place)]
        if not shapes:
            return
        kind = asked if asked == "kinematic" else "static"
        surface = surface_words(layer)
        shapes = [surface | words for words in shapes]
        self._draft.add_body(layer.text("name"), {"type": kind, "position": self._metres(shift), "shapes": shapes})

    def _words(self, solid: Solid, place: str) -> list[Words]:
        figure, surface = solid
        found = shape_words(figure, self._pixels, self._tolerance, self._remarks, place)
        return [words | surface for words in found]

    def _metres(self, point: Vec) -> list[float]:
        return tidy_point((point[0] / self._pixels, (self._bottom - point[1]) / self._pixels))


def _is_any(parent: Node, says: Callable[[Node], bool]) -> bool:
    """Whether something holds for any layer, in groups too."""
    return any(says(layer) or _is_any(layer, says) for layer in parent.nodes("layers"))


def _tile_layers(parent: Node) -> Iterator[Node]:
    for layer in parent.nodes("layers"):
        if layer.text("type") == "tilelayer":
            yield layer
        yield from _tile_layers(layer)


def _says_solid(layer: Node) -> bool:
    no_shapes = ("gid", "point", "text", "template")
    return is_solid(layer) or any(not any(map(each.has, no_shapes)) for each in layer.nodes("objects"))
