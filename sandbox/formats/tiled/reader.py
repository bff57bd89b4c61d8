"""A map of Tiled as a scene: an object is a body, and so are all the solid tiles of a layer."""

from __future__ import annotations

from typing import Any

from sandbox.formats.centred import centred
from sandbox.formats.draft import Draft
from sandbox.formats.numbers import Vec, tidy, tidy_point
from sandbox.formats.outlines import Words
from sandbox.formats.reading import MisreadError, Node
from sandbox.formats.source import Options, Source
from sandbox.formats.tiled.cells import FLIPPED_X, FLIPPED_Y, SWAPPED, cells_of
from sandbox.formats.tiled.figures import Figure, figure_of, shape_words
from sandbox.formats.tiled.merge import merged
from sandbox.formats.tiled.tilesets import Solid, Tilesets, flipped
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
        _Reader(Node(source.data), source, draft, options).read()
        return
    data = map_of(source.data)
    try:
        _Reader(Node(data), source, draft, options).read()
    except MisreadError as error:
        raise Source(source.path, source.text, data, line_in(data)).error(error) from None


class _Reader:
    def __init__(self, root: Node, source: Source, draft: Draft, options: Options) -> None:
        self._root, self._draft, self._remarks = root, draft, draft.remarks
        self._tile = (root.number("tilewidth", 32.0), root.number("tileheight", 32.0))
        if min(self._tile) < 1.0:
            raise MisreadError(("tilewidth",), "tiles must be at least a pixel wide and high")
        self._pixels = options.units_per_metre or self._tile[1]
        self._tolerance = options.tolerance
        self._bottom = 0.0 if root.flag("infinite") else root.number("height") * self._tile[1]
        self._sets = Tilesets(root, source.path.parent, self._remarks)

    def read(self) -> None:
        way = self._root.text("orientation", "orthogonal")
        if way != "orthogonal":
            self._remarks.note("", f"the map is {way[:20]}: places are read as of an orthogonal one")
        note_others(self._root, self._remarks)
        self._read_layers(self._root, (0.0, 0.0), "")
        self._draft.if_empty = _NOTHING_SOLID

    def _read_layers(self, parent: Node, offset: Vec, kind: str) -> None:
        for layer in parent.nodes("layers"):
            shift = (offset[0] + layer.number("offsetx"), offset[1] + layer.number("offsety"))
            asked = kind_of(layer) or kind
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

    def _read_object(self, node: Node, shift: Vec, asked: str) -> None:
        note_others(node, self._remarks)
        x, y = node.number("x") + shift[0], node.number("y") + shift[1]
        solids = self._tile_solids(node) if node.has("gid") else self._own_solid(node)
        shapes = [words for solid in solids for words in self._words(solid, node.place)]
        if not shapes:
            return
        kind = kind_of(node) or asked or "static"
        words: Words = {} if kind == "dynamic" else {"type": kind}
        words |= {"position": self._metres((x, y)), "shapes": shapes}
        if rotation := tidy(-node.number("rotation")):
            words["angle"] = rotation
        if kind != "static":
            words |= body_words(node)
        self._draft.add_body(node.text("name"), centred(words) if len(shapes) == 1 else words, node.place)

    def _own_solid(self, node: Node) -> list[Solid]:
        figure = figure_of(node, self._remarks)
        return [(figure, surface_words(node))] if figure else []

    def _tile_solids(self, node: Node) -> list[Solid]:
        """What is solid of a tile that stands as an object, about the point that it stands at."""
        value = node.whole("gid")
        number, flips = value & (1 << 28) - 1, value & (FLIPPED_X | FLIPPED_Y | SWAPPED)
        tiles = self._sets.of(number)
        solids = tiles.solids.get(number - tiles.first, []) if tiles else []
        if tiles is None or not solids:
            self._remarks.note(node.place, "a tile without a collision shape is left out")
            return []
        width, height = node.number("width", tiles.size[0]), node.number("height", tiles.size[1])
        share = _ALIGNED.get(tiles.alignment, _ALIGNED["bottomleft"])
        scale = width / max(tiles.size[0], 1e-9), height / max(tiles.size[1], 1e-9)

        def move(point: Vec) -> Vec:
            return point[0] * scale[0] - share[0] * width, point[1] * scale[1] - share[1] * height

        own = surface_words(node)
        return [(flipped(figure, tiles.size, flips).mapped(move), surface | own) for figure, surface in solids]

    def _read_tiles(self, layer: Node, shift: Vec, asked: str) -> None:
        boxes, shapes, empty = [], [], 0
        solid = is_solid(layer)
        for cell in cells_of(layer, self._remarks):
            tiles = self._sets.of(cell.tile)
            solids = tiles.solids.get(cell.tile - tiles.first, []) if tiles else []
            if tiles is None or not (solids or solid):
                empty += 1
                continue
            if tiles.size == self._tile and (solid or solids == [(tiles.box(), {})]):
                boxes.append((cell.column, cell.row))
                continue
            x = cell.column * self._tile[0] + tiles.offset[0]
            y = (cell.row + 1) * self._tile[1] - tiles.size[1] + tiles.offset[1]
            for figure, surface in solids or [(tiles.box(), {})]:
                placed = flipped(figure, tiles.size, cell.flips).mapped(lambda p, x=x, y=y: (p[0] + x, p[1] + y))  # type: ignore[misc]
                shapes += self._words((placed, surface), layer.place)
        shapes += [words for box in merged(boxes) for words in self._words((self._box(box), {}), layer.place)]
        if empty:
            self._remarks.note(f"{layer.place} ({empty})", "tiles without a collision shape are left out")
        if shapes:
            kind = asked if asked == "kinematic" else "static"
            surface = surface_words(layer)
            shapes = [surface | words for words in shapes]
            self._draft.add_body(
                layer.text("name"), {"type": kind, "position": self._metres(shift), "shapes": shapes}
            )  # fmt: skip

    def _box(self, box: tuple[int, int, int, int]) -> Figure:
        (left, top, columns, rows), (width, height) = box, self._tile
        xs, ys = (left * width, (left + columns) * width), (top * height, (top + rows) * height)
        return Figure("box", ((xs[0], ys[0]), (xs[1], ys[0]), (xs[1], ys[1]), (xs[0], ys[1])))

    def _words(self, solid: Solid, place: str) -> list[Words]:
        figure, surface = solid
        return [
            words | surface
            for words in shape_words(figure, self._pixels, self._tolerance, self._remarks, place)
        ]  # fmt: skip

    def _metres(self, point: Vec) -> list[float]:
        return tidy_point((point[0] / self._pixels, (self._bottom - point[1]) / self._pixels))
