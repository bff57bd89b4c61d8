"""The dot product as a picture: vectors from the start of an edge, and how far each goes along the edge's axis."""

from __future__ import annotations

from sandbox.geometry.sat_rows import SatRow, Vec, author_edges, corners_in_order
from sandbox.geometry.shapes import Shape
from sandbox.render.number_text import metres, plain, point
from sandbox.render.sat_labels import axis_name, deciding_row
from sandbox.render.sat_page import SatFigure, alone
from sandbox.render.sat_plane import Plane
from sandbox.render.svg import Svg

_ROOM = 62.0
"""Pixels for the words beside an axis and beyond its tip."""


def draw_dot(figure: SatFigure) -> Svg:
    """One axis as an arrow of its own length, and the other shape's vertices seen from where it starts."""
    table, row = figure.table, figure.row or deciding_row(figure.table)
    kind, other, shape = ("b", "a", table.a) if row.owner == "b" else ("a", "b", table.b)
    start = _start(row, table.b if row.owner == "b" else table.a)
    tip = start[0] + row.axis[0], start[1] + row.axis[1]
    place = f"axis {row.number}, {point(row.axis)} from {axis_name(row, figure.names)}"
    svg, plane = alone(figure, f"dot products with {place}, and how far along it that is", [start, tip], margin=_ROOM)
    with plane:
        plane.shape(table.a, "a shape")
        plane.shape(table.b, "b shape")
        plane.through(start, (-row.axis[1], row.axis[0]), "other drop")
        plane.through(start, row.axis, "rail")
        plane.arrow(start, tip, f"{kind} thick", 16.0)
        _vertices(plane, row, start, shape, other)
        plane.dot(start, f"{kind} dot")
    return svg


def _start(row: SatRow, owner: Shape) -> Vec:
    """Where the edge of an axis begins; of an axis from vertex to vertex, the first one."""
    if row.owner == "corners":
        return corners_in_order(owner)[row.edge - 1]
    return next(begin for number, begin, _end in author_edges(owner) if number == row.edge)


def _vertices(plane: Plane, row: SatRow, start: Vec, shape: Shape, kind: str) -> None:
    """An arrow to every vertex, the line that casts it on the axis, and its dot product there."""
    u = row.axis[0] / row.length, row.axis[1] / row.length
    seen = [(x - start[0], y - start[1]) for x, y in corners_in_order(shape)]
    # Words go to that side of the axis where there is nothing to cast.
    side = -1.0 if sum(-u[1] * x + u[0] * y for x, y in seen) > 0.0 else 1.0
    for x, y in seen:
        along = u[0] * x + u[1] * y
        foot = start[0] + u[0] * along, start[1] + u[1] * along
        vertex = start[0] + x, start[1] + y
        sign = "gap" if along > 0.0 else "out"
        plane.line(vertex, foot, f"{kind} drop")
        plane.arrow(start, vertex, f"{kind} edge", 12.0)
        plane.dot(foot, f"{sign} dot")
        _product(plane, foot, (-u[1] * side, u[0] * side), f"{plain(along * row.length)}", f"{metres(along)}", sign)
    plane.corners(shape, kind)


def _product(plane: Plane, foot: Vec, aside: Vec, product: str, along: str, kind: str) -> None:
    """The dot product beside its foot, and beneath it how many metres that is."""
    x, y = plane.pixel(foot)
    x, y = x + 12.0 * aside[0], y - 16.0 * aside[1]
    anchor = "middle" if abs(aside[0]) < 0.5 else "start" if aside[0] > 0.0 else "end"
    plane.svg.text((x, y + 1.0), product, f"{kind} strong number", anchor)
    plane.svg.text((x, y + 16.0), along, "soft small number", anchor)
