"""Elements of SVG as shapes, in metres with y up."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from sandbox.formats.numbers import Vec, tidy, tidy_point, tidy_points
from sandbox.formats.outlines import Words, chain_words, polygon_words, without_repeats
from sandbox.formats.primitives import capsule_words, ellipse_points
from sandbox.formats.remarks import Remarks
from sandbox.formats.svg.lengths import length, numbers
from sandbox.formats.svg.matrix import Matrix
from sandbox.formats.svg.rings import outlines
from sandbox.formats.svg.strokes import Stroke, strokes_of
from sandbox.formats.uncrossed import MOST_SIDES, crossing, uncrossed
from sandbox.formats.xml_tree import Element
from sandbox.scene.limits import MAX_OUTLINE

KINDS = ("path", "rect", "circle", "ellipse", "line", "polyline", "polygon")
"""Elements that are shapes."""
_MOST_RINGS = 5000
_HOPELESS = 50 * MAX_OUTLINE
"""Points that no coarser drawing makes few enough."""
_LONGEST = 1_000_000
"""Characters of a path."""


@dataclass(frozen=True)
class Brush:
    """An element to be drawn: its map to metres, and how far (m) straight sides may lie from a curve."""

    element: Element
    matrix: Matrix
    tolerance: float
    size: Vec
    """What 100 % are, across and down, in pixels."""
    remarks: Remarks
    place: str

    def length(self, name: str, axis: int | None = None) -> float:
        """An attribute in units of the element."""
        whole = math.hypot(*self.size) / math.sqrt(2.0) if axis is None else self.size[axis]
        return length(self.element.get(name), whole)


def filled_words(brush: Brush, even_odd: bool) -> list[Words]:
    """The shapes of what is filled."""
    if brush.element.tag == "rect":
        return _rect(brush)
    if brush.element.tag in ("circle", "ellipse"):
        return _ellipse(brush)
    rings = [ring for ring in (without_repeats(each.points) for each in subpaths(brush)) if len(ring) > 2]
    if len(rings) > _MOST_RINGS:
        brush.remarks.note(brush.place, f"a path of more than {_MOST_RINGS} rings is left out")
        return []
    parts = _parts(rings, even_odd) if rings else []
    if rings and not parts:
        brush.remarks.note(brush.place, "a path is left out: it encloses nothing, or crosses itself too often")
    found = [polygon_words(ring, brush.remarks, brush.place, holes) for ring, holes in parts]
    return [words for words in found if words]


def _parts(rings: list[list[Vec]], even_odd: bool) -> Sequence[tuple[Sequence[Vec], Sequence[Sequence[Vec]]]]:
    """Outlines and their holes; rings that cross are cut apart as the fill rule says."""
    few = sum(map(len, rings)) <= MOST_SIDES
    return uncrossed(rings, even_odd) if few and crossing(rings) else outlines(rings, even_odd)


def line_words(brush: Brush, width: float) -> list[Words]:
    """The shapes of what is drawn along its edge, half the width (units of the element) to each side."""
    found = [chain_words(each.points, each.closed, brush.remarks, brush.place) for each in subpaths(brush)]
    radius = tidy(width * brush.matrix.scale / 2.0)
    thick = {"radius": radius} if radius >= 1e-6 else {}
    return [words | thick for part in found for words in part]


def subpaths(brush: Brush) -> list[Stroke]:
    """What a pen would draw, in metres; coarser than asked for where it would have too many corners for a scene."""
    found, before = [], 0
    for coarser in range(8):
        found = _drawn(brush, brush.tolerance * 2.0**coarser / max(brush.matrix.scale, 1e-12))
        count = sum(len(each.points) for each in found)
        if count in (before, 0) or count > _HOPELESS or all(len(each.points) <= MAX_OUTLINE for each in found):
            break
        before = count
    return [Stroke([brush.matrix.of(point) for point in each.points], each.closed) for each in found]


def _drawn(brush: Brush, tolerance: float) -> list[Stroke]:
    element = brush.element
    if element.tag == "path" and len(element.get("d")) > _LONGEST:
        brush.remarks.note(brush.place, f"a path of more than {_LONGEST} characters is left out")
        return []
    if element.tag == "path":
        found, mistake = strokes_of(element.get("d"), tolerance)
        if mistake:
            brush.remarks.note(f"{brush.place} ({mistake})", "a path is drawn up to a mistake in its data")
        return found
    if element.tag == "line":
        ends = [(brush.length("x1", 0), brush.length("y1", 1)), (brush.length("x2", 0), brush.length("y2", 1))]
        return [Stroke(ends)]
    if element.tag in ("polyline", "polygon"):
        values = numbers(element.get("points"))
        points = list(zip(values[::2], values[1::2], strict=False))
        return [Stroke(points, element.tag == "polygon")] if len(points) > 1 else []
    return [Stroke(_outline(brush, tolerance), True)]


def _outline(brush: Brush, tolerance: float) -> list[Vec]:
    """A rect, circle or ellipse as a polygon, in units of the element."""
    if brush.element.tag == "rect":
        x, y, width, height = _area(brush)
        rx, ry = _rounding(brush, width, height)
        if min(rx, ry) <= 0.0:
            return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
        across, down = width - 2 * rx, height - 2 * ry
        text = (
            f"M{x + rx} {y}h{across}a{rx} {ry} 0 0 1 {rx} {ry}v{down}a{rx} {ry} 0 0 1 {-rx} {ry}"
            f"h{-across}a{rx} {ry} 0 0 1 {-rx} {-ry}v{-down}a{rx} {ry} 0 0 1 {rx} {-ry}z"
        )
        return strokes_of(text, tolerance)[0][0].points
    cx, cy = brush.length("cx", 0), brush.length("cy", 1)
    rx, ry = _radii(brush)
    return [(cx + x, cy + y) for x, y in ellipse_points(2 * rx, 2 * ry, tolerance)]


def _rect(brush: Brush) -> list[Words]:
    x, y, width, height = _area(brush)
    rx, ry = _rounding(brush, width, height)
    scale, at = brush.matrix.scale, tidy_point(brush.matrix.of((x + width / 2.0, y + height / 2.0)))
    wide, high, radius = width * scale, height * scale, rx * scale
    if min(wide, high) < 1e-6:
        brush.remarks.note(brush.place, "a shape without an extent is left out")
        return []
    if not brush.matrix.is_similar or not math.isclose(rx, ry, rel_tol=1e-3, abs_tol=1e-9):
        words = polygon_words(subpaths(brush)[0].points, brush.remarks, brush.place)
        return [words] if words else []
    turn = {"angle": _angle(brush.matrix)} if _angle(brush.matrix) else {}
    if 2.0 * radius >= min(wide, high) - 2e-6:
        words = capsule_words(wide, high)
        return [words | {"at": at} | ({} if "circle" in words else turn)]
    rounded = {"radius": tidy(radius)} if radius >= 1e-6 else {}
    return [{"box": [tidy(wide), tidy(high)], "at": at, **rounded, **turn}]


def _ellipse(brush: Brush) -> list[Words]:
    rx, ry = _radii(brush)
    if min(rx, ry) * brush.matrix.scale < 1e-6:
        brush.remarks.note(brush.place, "a shape without an extent is left out")
        return []
    if brush.matrix.is_similar and math.isclose(rx, ry, rel_tol=1e-6):
        center = brush.matrix.of((brush.length("cx", 0), brush.length("cy", 1)))
        return [{"circle": tidy(rx * brush.matrix.scale), "at": tidy_point(center)}]
    (path,) = subpaths(brush)
    brush.remarks.note(f"{brush.place} ({len(path.points)} sides)", "an ellipse is a polygon")
    return [{"polygon": tidy_points(path.points)}]


def _area(brush: Brush) -> tuple[float, float, float, float]:
    return brush.length("x", 0), brush.length("y", 1), brush.length("width", 0), brush.length("height", 1)


def _rounding(brush: Brush, width: float, height: float) -> Vec:
    given = brush.element.attributes.keys() & {"rx", "ry"}
    rx, ry = brush.length("rx", 0), brush.length("ry", 1)
    rx, ry = (rx if "rx" in given else ry), (ry if "ry" in given else rx)
    return max(0.0, min(rx, width / 2.0)), max(0.0, min(ry, height / 2.0))


def _radii(brush: Brush) -> Vec:
    if brush.element.tag == "circle":
        return (brush.length("r"),) * 2
    return brush.length("rx", 0), brush.length("ry", 1)


def _angle(matrix: Matrix) -> float:
    """By how much a similar map turns a box, degrees: a half turn makes no difference to it."""
    angle = math.degrees(math.atan2(matrix.b, matrix.a)) % 180.0
    return 0.0 if tidy(angle) == 180.0 else tidy(angle)
