"""What all separating-axis pictures share: the card with its headline, the window onto the plane, the two shapes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from sandbox.geometry.sat_rows import SatRow, Vec
from sandbox.geometry.sat_table import SatTable
from sandbox.geometry.shape_box import box_of
from sandbox.geometry.shapes import Shape
from sandbox.render.sat_labels import deciding_row, headline
from sandbox.render.sat_plane import Plane
from sandbox.render.sat_style import style_sheet
from sandbox.render.svg import Svg

ALONE = (680, 420)
HEAD, EDGE = 76.0, 24.0
"""Pixels above and beside what a card shows."""
_DWARFED = 12.0
"""If one shape is so many times larger than the other, only the surroundings of the smaller one are shown."""


class Member(NamedTuple):
    """A shape of the scene, the index of its body, and whether that body can be pushed."""

    shape: Shape
    body: int
    moves: bool


class Whole(NamedTuple):
    """A body as a whole: its convex `parts`, and the `rings` that are the outlines of its concave polygons (m)."""

    parts: tuple[Shape, ...]
    rings: tuple[tuple[Vec, ...], ...] = ()


@dataclass(frozen=True)
class SatFigure:
    """What a picture shows: a table, the names of its two bodies, one of the rows, all shapes of the scene.

    `row` is for the figures of one axis, `scene_shapes` for that of the scene, `wholes` (both bodies) for the parts.
    """

    table: SatTable
    names: tuple[str, str]
    row: SatRow | None = None
    scene_shapes: tuple[Member, ...] = ()
    wholes: tuple[Whole, ...] = ()


def page(width: float, height: float, figure: SatFigure, subtitle: str = "") -> Svg:
    """The card, with a headline on it."""
    a, b = figure.names
    svg = Svg(width, height, f"{a} and {b}: {subtitle or headline(figure.table, figure.names)}", style_sheet())
    svg.rectangle(0.5, 0.5, width - 1, height - 1, "card", 14.0)
    verdict = "colliding" if figure.table.colliding else "not colliding"
    svg.spans((EDGE, 38), [(a, "a"), (" and ", ""), (b, "b"), (f": {verdict}", "")], "title")
    svg.text((EDGE, 60), subtitle or headline(figure.table, figure.names), "soft")
    return svg


def alone(
    figure: SatFigure, subtitle: str, more: Sequence[Vec] = (), whole_scene: bool = False, margin: float = 52.0
) -> tuple[Svg, Plane]:
    """A page with one window on it: both shapes and the points `more`, or all that can move, and `margin` pixels."""
    svg = page(ALONE[0] + 2 * EDGE, HEAD + ALONE[1] + EDGE, figure, subtitle)
    seen = [*more, *(_scene_extent(figure) if whole_scene else extent(figure.table))]
    plane = Plane(svg, (EDGE, HEAD), ALONE, seen, margin)
    return svg, plane


def draw_shapes(plane: Plane, table: SatTable) -> None:
    """Both shapes with their numbered corners."""
    for shape, kind in ((table.a, "a"), (table.b, "b")):
        plane.shape(shape, f"{kind} shape")
        plane.corners(shape, kind)


def draw_outcome(plane: Plane, table: SatTable) -> None:
    """The translation vector and where it leads; or a line through the gap."""
    if table.mtv is not None:
        x, y = _arrow_start(plane, table)
        plane.shape(table.b, "b ghost", table.mtv)
        plane.arrow((x, y), (x + table.mtv[0], y + table.mtv[1]), "mtv")
        return
    row = deciding_row(table)
    middle = 0.5 * (max(row.amin, row.bmin) + min(row.amax, row.bmax)) / row.length
    u = row.axis[0] / row.length, row.axis[1] / row.length
    plane.through((u[0] * middle, u[1] * middle), (-u[1], u[0]), "gap line")


def extent(table: SatTable) -> list[Vec]:
    """Corners of the boxes that the picture has to hold: of both shapes, and of b where the way out leads."""
    dx, dy = table.mtv or (0.0, 0.0)
    a, b = box_of(table.a), box_of(table.b)
    shapes = in_sight(table)
    if len(shapes) == 1:
        x0, y0, x1, y1 = small = box_of(shapes[0])
        room = _size(small)
        return [(x0 - room, y0 - room), (x1 + room, y1 + room)]
    return [a[:2], a[2:], b[:2], b[2:], (b[0] + dx, b[1] + dy), (b[2] + dx, b[3] + dy)]


def _scene_extent(figure: SatFigure) -> list[Vec]:
    boxes = [box_of(member.shape) for member in figure.scene_shapes if member.moves]
    return [corner for box in boxes for corner in (box[:2], box[2:])] or extent(figure.table)


def in_sight(table: SatTable) -> tuple[Shape, ...]:
    """Both shapes, or the smaller one if it is so much smaller that a picture of both would not show it."""
    small, large = sorted((table.a, table.b), key=lambda shape: _size(box_of(shape)))
    return (small,) if _size(box_of(large)) > _DWARFED * _size(box_of(small)) else (table.a, table.b)


def _size(box: tuple[float, float, float, float]) -> float:
    return max(box[2] - box[0], box[3] - box[1])


def _arrow_start(plane: Plane, table: SatTable) -> Vec:
    """The middle of b, or, where that is out of sight, of the contact."""
    assert table.contact is not None
    return next(p for p in (_center(table.b.vertices), _center(table.contact.points)) if plane.shows(p))


def _center(points: tuple[Vec, ...]) -> Vec:
    return sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points)
