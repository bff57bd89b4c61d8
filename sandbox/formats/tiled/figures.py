"""Objects of Tiled as figures: points in pixels with y down, which can be moved, scaled and mirrored."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from sandbox.formats.numbers import Vec, tidy, tidy_point, tidy_points, turned
from sandbox.formats.outlines import Words, chain_words, polygon_parts
from sandbox.formats.primitives import capsule_words, ellipse_points
from sandbox.formats.reading import Node
from sandbox.formats.remarks import Remarks

_SIDES = 32
"""Of a round figure that is seen at a slant."""


@dataclass(frozen=True)
class Figure:
    """A box (its four corners, turned by nothing but right angles), ellipse (corners of its box), polygon or line; or
    all of a cell, without points.
    """

    kind: Literal["box", "ellipse", "capsule", "polygon", "line", "cell"]
    points: tuple[Vec, ...]

    def mapped(self, move: Callable[[Vec], Vec]) -> Figure:
        """The figure with every point moved by an affine map."""
        return Figure(self.kind, tuple(map(move, self.points)))


def figure_of(node: Node, remarks: Remarks) -> Figure | None:
    """What an object is, about the point that it stands at and turns about; None, with a remark, if it is no shape."""
    width, height = node.number("width"), node.number("height")
    corners = ((0.0, 0.0), (width, 0.0), (width, height), (0.0, height))
    if node.has("polygon"):
        return _polygon(tuple(node.points("polygon")))
    if node.has("polyline"):
        return Figure("line", tuple(node.points("polyline")))
    if node.flag("point") or (width == 0.0 and height == 0.0):
        remarks.note(node.place, "a point is left out")
        return None
    if node.has("text"):
        remarks.note(node.place, "text is left out")
        return None
    if width == 0.0 or height == 0.0:
        return Figure("line", (corners[0], corners[2]))
    kind: Literal["box", "ellipse", "capsule"] = "box"
    if node.flag("ellipse"):
        kind = "ellipse"
    elif node.flag("capsule"):
        kind = "capsule"
    return Figure(kind, corners)


def _polygon(points: tuple[Vec, ...]) -> Figure:
    """A polygon, or the box that it is: many draw whole tiles so."""
    (left, right), (top, bottom) = ((min(values), max(values)) for values in zip(*points, strict=True)) if points else (
        (0.0, 0.0), (0.0, 0.0),
    )  # fmt: skip
    corners = ((left, top), (right, top), (right, bottom), (left, bottom))
    start = points.index(corners[0]) if corners[0] in points else 0
    ring = points[start:] + points[:start]
    if ring in (corners, (corners[0], *corners[:0:-1])) and left < right and top < bottom:
        return Figure("box", corners)
    return Figure("polygon", points)


def outline_of(figure: Figure) -> Figure:
    """The figure as a polygon, or line, that any affine map may lead elsewhere."""
    if figure.kind in ("line", "polygon", "cell"):
        return figure
    if figure.kind == "box":
        return Figure("polygon", figure.points)
    (ax, ay), (bx, by), (cx, cy), _ = figure.points
    u, v = ((bx - ax) / 2.0, (by - ay) / 2.0), ((cx - bx) / 2.0, (cy - by) / 2.0)
    wide, high = math.hypot(*u), math.hypot(*v)
    radius = min(wide, high)
    ring = []
    for k in range(_SIDES):
        cosine, sine = math.cos(math.tau * (k + 0.5) / _SIDES), math.sin(math.tau * (k + 0.5) / _SIDES)
        if figure.kind == "capsule" and radius > 0.0:  # a circle, its halves drawn apart
            cosine = (radius * cosine + math.copysign(wide - radius, cosine)) / wide
            sine = (radius * sine + math.copysign(high - radius, sine)) / high
        ring.append(((ax + cx) / 2.0 + cosine * u[0] + sine * v[0], (ay + cy) / 2.0 + cosine * u[1] + sine * v[1]))
    return Figure("polygon", tuple(ring))


def turned_about_origin(figure: Figure, degrees: float) -> Figure:
    """Turned clockwise, as Tiled counts it."""
    if degrees % 360.0 == 0.0:
        return figure
    return figure.mapped(lambda point: turned(point, math.radians(degrees)))


def shape_words(figure: Figure, pixels: float, tolerance: float, remarks: Remarks, place: str) -> list[Words]:
    """The shapes of a figure, in metres with y up, about the figure's own origin."""
    points = [(x / pixels, -y / pixels) for x, y in figure.points]
    if figure.kind == "line":
        return chain_words(points, False, remarks, place)
    if figure.kind == "polygon":
        return polygon_parts(points, remarks, place)
    (ax, ay), (bx, by), (cx, cy), _ = points
    width, height = math.dist(points[0], points[1]), math.dist(points[1], points[2])
    if min(width, height) < 2e-6:
        remarks.note(place, "a shape without an extent is left out")
        return []
    at = {"at": tidy_point(((ax + cx) / 2.0, (ay + cy) / 2.0))}
    if at["at"] == [0.0, 0.0]:
        at = {}
    lean = math.degrees(math.atan2(by - ay, bx - ax)) % 180.0
    angle = {"angle": tidy(lean)} if tidy(lean) not in (0.0, 180.0) else {}
    if figure.kind == "capsule":
        return [capsule_words(width, height) | at | angle]
    if figure.kind == "ellipse":
        return [_ellipse(width, height, tolerance, remarks, place) | at | angle]
    return [{"box": [tidy(width), tidy(height)], **at, **angle}]


def _ellipse(width: float, height: float, tolerance: float, remarks: Remarks, place: str) -> Words:
    if math.isclose(width, height, rel_tol=1e-6):
        return {"circle": tidy(width / 2.0)}
    points = ellipse_points(width, height, tolerance)
    remarks.note(f"{place} ({len(points)} sides)", "an ellipse is a polygon")
    return {"polygon": tidy_points(points)}
