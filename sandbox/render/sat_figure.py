"""Pictures of one separating-axis test: the whole of it, or one thought of it at a time."""

from __future__ import annotations

from collections.abc import Callable

from sandbox.render.number_text import point
from sandbox.render.rail_geometry import rail_ends
from sandbox.render.sat_clipping import draw_clipping
from sandbox.render.sat_dot import draw_dot
from sandbox.render.sat_labels import axis_name, deciding_row, headline, shortened
from sandbox.render.sat_page import (
    ALONE,
    EDGE,
    HEAD,
    SatFigure,
    alone,
    draw_outcome,
    draw_shapes,
    extent,
    page,
)
from sandbox.render.sat_parts import draw_parts
from sandbox.render.sat_plane import Plane
from sandbox.render.sat_rails import ROW, RailList, plane_rail
from sandbox.render.sat_scene import draw_scene
from sandbox.render.sat_tilt import draw_tilt
from sandbox.render.svg import Svg

_PLANE = (440, 440)
_RAILS = 620.0
_NAME = 11
"""Letters of a body's name that fit beside a rail."""


def draw_whole(figure: SatFigure) -> Svg:
    """The two shapes, every row of the table as a rail, and the way out or the line between."""
    table = figure.table
    height = max(_PLANE[1], ROW * len(table.rows))
    svg = page(EDGE * 3 + _PLANE[0] + _RAILS, HEAD + height + EDGE, figure)
    with Plane(svg, (EDGE, HEAD), _PLANE, extent(table)) as plane:
        draw_shapes(plane, table)
        draw_outcome(plane, table)
    names = shortened(figure.names[0], _NAME), shortened(figure.names[1], _NAME)
    left = EDGE * 2 + _PLANE[0] + 6
    RailList(svg, (left, HEAD), _RAILS - 12, table, names).draw(int(height // ROW))
    return svg


def draw_edges(figure: SatFigure) -> Svg:
    """The edges as vectors from corner to corner."""
    svg, plane = alone(figure, f"the edges of {figure.names[0]} and {figure.names[1]}")
    with plane:
        for shape, kind in ((figure.table.a, "a"), (figure.table.b, "b")):
            plane.shape(shape, f"{kind} shape")
            plane.edges(shape, kind)
            plane.corners(shape, kind)
    return svg


def draw_perpendiculars(figure: SatFigure) -> Svg:
    """The axis that every edge gives."""
    svg, plane = alone(figure, "the perpendicular of every edge is an axis to test", margin=76.0)
    with plane:
        for shape, kind in ((figure.table.a, "a"), (figure.table.b, "b")):
            plane.shape(shape, f"{kind} shape")
            plane.perpendiculars(shape, kind)
    return svg


def draw_axis(figure: SatFigure) -> Svg:
    """One axis where it lies in the plane, with the shadows of both shapes."""
    table, row = figure.table, figure.row or deciding_row(figure.table)
    title = f"axis {row.number}: {point(row.axis)} from {axis_name(row, figure.names)}"
    draft = Plane(Svg(1, 1, "", ""), (0, 0), ALONE, extent(table))
    room = 60.0 / draft.scale
    svg, plane = alone(figure, title, rail_ends(table, row, room, 0.5 * room))
    with plane:
        draw_shapes(plane, table)
        plane_rail(plane, table, row)
    return svg


def draw_mtv(figure: SatFigure) -> Svg:
    """Both shapes, the shortest way out, and the second one where that way leads."""
    svg, plane = alone(figure, headline(figure.table, figure.names))
    with plane:
        draw_shapes(plane, figure.table)
        draw_outcome(plane, figure.table)
    return svg


FIGURES: dict[str, Callable[[SatFigure], Svg]] = {
    "whole": draw_whole,
    "edges": draw_edges,
    "perpendiculars": draw_perpendiculars,
    "dot": draw_dot,
    "parts": draw_parts,
    "tilt": draw_tilt,
    "axis": draw_axis,
    "mtv": draw_mtv,
    "clipping": draw_clipping,
    "scene": draw_scene,
}
"""Every figure by its name on the command line."""
