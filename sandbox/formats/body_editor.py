"""Physics Body Editor (Aurelien Ribon, MovingBlocks): shapes over images whose width is 1, y up.

Source: `BodyEditorLoader` of MovingBlocks/box2d-editor. `shapes` is what was drawn, `polygons` and `circles` are the
convex parts that loaders take; these are taken where what was drawn cannot be.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from sandbox.formats.draft import Draft
from sandbox.formats.numbers import Vec, tidy, tidy_point
from sandbox.formats.outlines import Words, polygon_words
from sandbox.formats.reading import MisreadError, Node
from sandbox.formats.remarks import Remarks
from sandbox.formats.shelf import Item, put_on_shelf
from sandbox.formats.source import Options, Source


def is_body_editor(data: Any) -> bool:
    """Whether parsed JSON is a project of the Physics Body Editor."""
    return isinstance(data, dict) and isinstance(data.get("rigidBodies"), list)


def read_body_editor(source: Source, draft: Draft, options: Options) -> None:
    """Bring all of the file into the draft. Raises `MisreadError`."""
    root = Node(source.data)
    reader = _Reader(1.0 / (options.units_per_metre or 1.0), draft.remarks)
    put_on_shelf([reader.item(node) for node in root.nodes("rigidBodies")], draft)
    for node in root.nodes("dynamicObjects"):
        draft.remarks.note(node.place, "dynamic objects are left out")


class _Reader:
    def __init__(self, scale: float, remarks: Remarks) -> None:
        self._scale, self._remarks = scale, remarks

    def item(self, node: Node) -> Item:
        if node.text("imagePath"):
            self._remarks.note(node.place, "images are left out")
        origin = node.vector("origin")
        drawn, trials = list(self._drawn(node, origin)), Remarks()
        item = self._built(node, drawn, trials)
        if not drawn or len(item.shapes) < len(drawn):
            parts = list(self._parts(node, origin))
            item = self._built(node, parts, self._remarks)
        return item

    def _built(self, node: Node, outlines: list[_Outline], remarks: Remarks) -> Item:
        item = Item(node.text("name"), node.place)
        for outline in outlines:
            if words := _words(outline, remarks, node.place):
                item.shapes.append(words)
                item.reach += outline.reach()
        return item

    def _drawn(self, node: Node, origin: Vec) -> Iterator[_Outline]:
        for shape in node.nodes("shapes"):
            points = [self._moved(point, origin) for point in shape.points("vertices")]
            if shape.text("type") == "CIRCLE":
                if len(points) != 2:
                    raise MisreadError((*shape.path, "vertices"), "a circle has its centre and a point on it")
                yield _Outline([points[0]], math.dist(*points))
            else:
                yield _Outline(points)

    def _parts(self, node: Node, origin: Vec) -> Iterator[_Outline]:
        for index, each in enumerate(node.listed("polygons")):
            path = (*node.path, "polygons", index)
            if not isinstance(each, list):
                raise MisreadError(path, "must be a list of points")
            points = [node.vector_of(point, (*path, k)) for k, point in enumerate(each)]
            yield _Outline([self._moved(point, origin) for point in points])
        for circle in node.nodes("circles"):
            center = self._moved((circle.number("cx"), circle.number("cy")), origin)
            yield _Outline([center], circle.number("r") * self._scale)

    def _moved(self, point: Vec, origin: Vec) -> Vec:
        return (point[0] - origin[0]) * self._scale, (point[1] - origin[1]) * self._scale


class _Outline:
    """A polygon, or a circle about its only point, in metres."""

    def __init__(self, points: list[Vec], radius: float = 0.0) -> None:
        self.points, self.radius = points, radius

    def reach(self) -> list[Vec]:
        r = self.radius
        return [corner for x, y in self.points for corner in ((x - r, y - r), (x + r, y + r))]


def _words(outline: _Outline, remarks: Remarks, place: str) -> Words | None:
    if len(outline.points) > 1 or outline.radius == 0.0:
        return polygon_words(outline.points, remarks, place)
    if outline.radius < 1e-6:
        remarks.note(place, "a circle without a radius is left out")
        return None
    return {"circle": tidy(outline.radius), "at": tidy_point(outline.points[0])}
