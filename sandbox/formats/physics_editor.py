"""PhysicsEditor (CodeAndWeb): the JSON of its exporters for Matter.js (Phaser 3) and for P2, Lime and Corona.

Pixels, y down. Matter: `{"NAME": {"type": "fromPhysicsEditor", "fixtures": [{"vertices": [[{x, y}..]..]}, {"circle":
{x, y, radius}}]}}`; source: `PhysicsEditorParser.js` of Phaser 3. The others: `{"NAME": [{"shape": [x, y, x, y..]},
{"circle": {..}}]}`; source: `Phaser.Physics.P2.Body.addPhaserPolygon` of Phaser 2.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from sandbox.formats.box2d.bodies import filter_words
from sandbox.formats.draft import Draft
from sandbox.formats.numbers import Vec, tidy, tidy_point
from sandbox.formats.outlines import Words, polygon_parts
from sandbox.formats.reading import MisreadError, Node
from sandbox.formats.remarks import Remarks
from sandbox.formats.shelf import Item, put_on_shelf
from sandbox.formats.source import Options, Source

PIXELS_PER_METRE = 32.0
_STEP_RATE = 60.0
"""Steps a second for which Matter.js counts its air friction."""


def is_physics_editor(data: Any) -> bool:
    """Whether parsed JSON is an export of PhysicsEditor."""
    if not isinstance(data, dict):
        return False
    bodies = [value for value in data.values() if isinstance(value, (dict, list))]
    return bool(bodies) and all(_is_matter(value) or _is_list(value) for value in bodies)


def _is_matter(value: Any) -> bool:
    return isinstance(value, dict) and (value.get("type") == "fromPhysicsEditor")


def _is_list(value: Any) -> bool:
    first = value[0] if isinstance(value, list) and value else None
    return isinstance(first, dict) and bool({"shape", "circle"} & first.keys()) and "density" in first


def read_physics_editor(source: Source, draft: Draft, options: Options) -> None:
    """Bring all of the file into the draft. Raises `MisreadError`."""
    reader = _Reader(options.units_per_metre or PIXELS_PER_METRE, draft.remarks)
    items = []
    for name, value in source.data.items():
        if isinstance(value, dict):
            items.append(reader.matter(name, Node(value, (name,))))
        elif isinstance(value, list):
            items.append(reader.listed(name, Node(source.data)))
    put_on_shelf(items, draft)


class _Reader:
    def __init__(self, pixels: float, remarks: Remarks) -> None:
        self._pixels, self._remarks = pixels, remarks

    def matter(self, name: str, body: Node) -> Item:
        """A body for Matter.js, whose densities are masses of a square pixel."""
        item = Item(name, body.place or name)
        if body.flag("isStatic"):
            item.words["type"] = "static"
        elif air := body.number("frictionAir"):
            item.words |= {"linear_damping": tidy(air * _STEP_RATE), "angular_damping": tidy(air * _STEP_RATE)}
        if body.has("frictionStatic"):
            self._remarks.note(item.place, "static friction is left out: friction is the same at rest and in motion")
        allowed = body.node("collisionFilter") or Node({})
        surface = _surface(body, "restitution", self._pixels**2)
        surface |= filter_words(*(allowed.whole(key, usual) for key, usual in _MATTER_FILTER))
        for fixture in body.nodes("fixtures"):
            sensor = {"sensor": True} if fixture.flag("isSensor") else {}
            for words, reach in self._fixture(fixture):
                item.shapes.append(words | surface | sensor)
                item.reach += reach
        return _centred(item)

    def listed(self, name: str, root: Node) -> Item:
        """A body of the other exporters: a list of fixtures, each with its own surface."""
        item = Item(name, name)
        for fixture in root.nodes(name):
            allowed = fixture.node("filter") or Node({})
            surface = _surface(fixture, "bounce" if fixture.has("bounce") else "restitution", 1.0)
            surface |= filter_words(*(allowed.whole(key, usual) for key, usual in _BOX2D_FILTER))
            if fixture.flag("isSensor"):
                surface["sensor"] = True
            for words, reach in self._fixture(fixture):
                item.shapes.append(words | surface)
                item.reach += reach
        return _centred(item)

    def _fixture(self, node: Node) -> Iterator[tuple[Words, list[Vec]]]:
        """Words and reach of each shape, in metres with y up."""
        if circle := node.node("circle"):
            center = circle.vector("position") if circle.has("position") else (circle.number("x"), circle.number("y"))
            radius = circle.number("radius") / self._pixels
            x, y = self._metres(center)
            if radius < 1e-6:
                self._remarks.note(node.place, "a circle without a radius is left out")
            else:
                yield {"circle": tidy(radius), "at": [x, y]}, [(x - radius, y - radius), (x + radius, y + radius)]
        outlines = [_pairs(node)] if node.has("shape") else _point_lists(node, "vertices")
        for outline in outlines:
            points = [self._metres(point) for point in outline]
            for words in polygon_parts(points, self._remarks, node.place):
                yield words, points

    def _metres(self, point: Vec) -> Vec:
        return point[0] / self._pixels, -point[1] / self._pixels


_MATTER_FILTER = (("category", 1), ("mask", 0xFFFFFFFF), ("group", 0))
_BOX2D_FILTER = (("categoryBits", 1), ("maskBits", 0xFFFF), ("groupIndex", 0))


def _centred(item: Item) -> Item:
    """The item with its origin amid its shapes: where the image began has no meaning here."""
    if item.reach:
        spans = [(min(p[axis] for p in item.reach), max(p[axis] for p in item.reach)) for axis in (0, 1)]
        x, y = ((low + high) / 2.0 for low, high in spans)
        item.reach = [(px - x, py - y) for px, py in item.reach]
        for words in item.shapes:
            _move(words, x, y)
    return item


def _move(words: Words, x: float, y: float) -> None:
    if "polygon" in words:
        words["polygon"] = [tidy_point((px - x, py - y)) for px, py in words["polygon"]]
    else:
        words["at"] = tidy_point((words["at"][0] - x, words["at"][1] - y))


def _surface(node: Node, bounce: str, density: float) -> Words:
    words = {
        "density": tidy(node.number("density", 1.0 / density) * density),
        "friction": tidy(max(node.number("friction", 0.1), 0.0)),
        "restitution": tidy(min(max(node.number(bounce), 0.0), 1.0)),
    }
    usual = {"density": 1.0, "friction": 0.5, "restitution": 0.0}
    return {key: value for key, value in words.items() if value != usual[key]}


def _pairs(node: Node) -> list[Vec]:
    """Points of a flat list [x, y, x, y, ...]."""
    path = (*node.path, "shape")
    numbers = [node.number_of(value, (*path, k)) for k, value in enumerate(node.listed("shape"))]
    if len(numbers) % 2:
        raise MisreadError(path, "must have two numbers for each corner")
    return list(zip(numbers[::2], numbers[1::2], strict=True))


def _point_lists(node: Node, key: str) -> Iterator[list[Vec]]:
    for index, each in enumerate(node.listed(key)):
        path = (*node.path, key, index)
        if not isinstance(each, list):
            raise MisreadError(path, "must be a list of points")
        yield [node.vector_of(point, (*path, k)) for k, point in enumerate(each)]
