"""TMX and TSX, the XML of Tiled, as the JSON of Tiled would have them.

Source: https://doc.mapeditor.org, "TMX Map Format" and "JSON Map Format".
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from sandbox.formats.reading import MisreadError
from sandbox.formats.xml_tree import Element
from sandbox.scene.finding import Path

_TEXTS = {"name", "class", "type", "orientation", "source", "encoding", "compression", "objectalignment", "template",
          "staggeraxis", "staggerindex", "tilerendersize", "fillmode"}  # fmt: skip
_LAYERS = {"layer": "tilelayer", "objectgroup": "objectgroup", "imagelayer": "imagelayer", "group": "group"}
_MARKS = ("point", "ellipse", "capsule")


class Placed(dict[str, Any]):
    """An object, and the line of the file that it comes from."""

    line = 0


def line_in(data: Any) -> Callable[[Path], int]:
    """A function that tells on which line a path of `data` leads to something."""

    def find(path: Path) -> int:
        node, line = data, 1
        for part in path:
            line = node.line if isinstance(node, Placed) else line
            try:
                node = node[part]
            except (LookupError, TypeError):
                break
        return node.line if isinstance(node, Placed) else line

    return find


def map_of(root: Element) -> dict[str, Any]:
    """A map."""
    found = _object(root)
    found["infinite"] = root.get("infinite") == "1"
    found["layers"] = _layers(root)
    found["tilesets"] = [tileset_of(each) for each in root.named("tileset")]
    return found


def tileset_of(root: Element) -> dict[str, Any]:
    """A tileset, or a reference to one."""
    found = _object(root)
    for key in ("tileoffset", "grid"):
        if child := root.first(key):
            found[key] = _object(child)
    tiles = []
    for tile in root.named("tile"):
        made = _object(tile)
        if image := tile.first("image"):
            made |= {f"image{key}": _number(image.get(key)) for key in ("width", "height") if image.get(key)}
        if group := tile.first("objectgroup"):
            made["objectgroup"] = _group(group)
        tiles.append(made)
    found["tiles"] = tiles
    return found


def template_of(root: Element) -> dict[str, Any]:
    """A template: an object, and the tileset that its tile is of."""
    found = _object(root)
    if element := root.first("object"):
        found["object"] = _shape(element)
    if tiles := root.first("tileset"):
        found["tileset"] = tileset_of(tiles)
    return found


def _object(element: Element) -> Placed:
    """Attributes, as numbers where they are numbers, and properties."""
    found = Placed((key, value if key in _TEXTS else _number(value)) for key, value in element.attributes.items())
    found.line = element.line
    if properties := element.first("properties"):
        found["properties"] = [_property(each) for each in properties.named("property")]
    return found


def _property(element: Element) -> dict[str, Any]:
    kind, text = element.get("type", "string"), element.get("value") or element.text
    value: Any = text == "true" if kind == "bool" else _number(text) if kind in ("int", "float") else text
    return {"name": element.get("name"), "type": kind, "value": value}


def _number(text: str) -> Any:
    try:
        return float(text)
    except ValueError:
        return text


def _layers(parent: Element) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = []
    for element in parent.children:
        if element.tag not in _LAYERS:
            continue
        layer = _group(element) if element.tag == "objectgroup" else _object(element)
        layer["type"] = _LAYERS[element.tag]
        if element.tag == "group":
            layer["layers"] = _layers(element)
        if element.tag == "layer":
            _add_cells(layer, element)
        found.append(layer)
    return found


def _group(element: Element) -> Placed:
    group = _object(element)
    group["objects"] = [_shape(each) for each in element.named("object")]
    return group


def _shape(element: Element) -> Placed:
    found = _object(element)
    for child in element.children:
        if child.tag in _MARKS:
            found[child.tag] = True
        elif child.tag in ("polygon", "polyline"):
            found[child.tag] = _points(child)
        elif child.tag == "text":
            found["text"] = Placed()
    return found


def _points(element: Element) -> list[dict[str, Any]]:
    pairs = [pair.partition(",") for pair in element.get("points").split()]
    return [{"x": _number(x), "y": _number(y)} for x, _, y in pairs]


def _add_cells(layer: Placed, element: Element) -> None:
    data = element.first("data")
    if data is None:
        return
    layer["encoding"], layer["compression"] = data.get("encoding"), data.get("compression")
    chunks = [_object(chunk) | {"data": _cells(chunk, data)} for chunk in data.named("chunk")]
    layer |= {"chunks": chunks} if chunks else {"data": _cells(data, data)}


def _cells(holder: Element, data: Element) -> list[int] | str:
    """Numbers of tiles: written as elements, with commas, or packed."""
    try:
        if not data.get("encoding"):
            return [int(tile.get("gid", "0")) for tile in holder.named("tile")]
        if data.get("encoding") == "csv":
            return [int(number) for number in holder.text.replace("\n", ",").split(",") if number.strip()]
    except ValueError:
        raise MisreadError((holder.line,), "the tiles are no numbers") from None
    return holder.text.strip()
