"""The clipping picture: reference face, incident edge, the sides that cut it, and the contact points."""

from __future__ import annotations

from sandbox.geometry.clip_steps import Clipping, clipping
from sandbox.geometry.sat_rows import Vec
from sandbox.geometry.sat_table import SatTable
from sandbox.render.sat_labels import headline
from sandbox.render.sat_page import SatFigure, alone
from sandbox.render.sat_plane import Plane
from sandbox.render.svg import Svg


def draw_clipping(figure: SatFigure) -> Svg:
    """How the contact points come about; of separated shapes, just the two shapes."""
    table = figure.table
    clip = clipping(table.a, table.b, table.contact) if table.contact is not None else None
    svg, plane = alone(figure, _subtitle(figure, clip))
    with plane:
        plane.shape(table.a, "a shape")
        plane.shape(table.b, "b shape")
        if clip is not None:
            _cuts(plane, clip)
        _points(plane, table)
    return svg


def _subtitle(figure: SatFigure, clip: Clipping | None) -> str:
    if clip is None:
        return headline(figure.table, figure.names)
    mine, other = figure.names if clip.owner == "a" else figure.names[::-1]
    return f"edge {clip.incident_edge} of {other}, cut at the ends of edge {clip.reference_edge} of {mine}"


def _cuts(plane: Plane, clip: Clipping) -> None:
    mine, other = ("a", "b") if clip.owner == "a" else ("b", "a")
    for end in clip.reference:
        plane.through(end, clip.normal, "mtv drop")
    plane.line(*clip.reference, f"{mine} thick")
    plane.line(*clip.incident, f"{other} edge")
    plane.line(*clip.clipped, f"{other} thick")
    for end, gap in zip(clip.clipped, clip.gaps, strict=True):
        plane.dot(end, f"{other} dot" if gap <= 0.0 else f"{other} hollow")
    middle = _between(*clip.reference)
    if not plane.shows(middle):
        middle = _between(*clip.clipped)
    long = 46.0 / plane.scale
    plane.arrow(middle, (middle[0] + clip.normal[0] * long, middle[1] + clip.normal[1] * long), f"{mine} axis", 10.0)


def _points(plane: Plane, table: SatTable) -> None:
    for point in table.contact.points if table.contact is not None else ():
        plane.dot(point, "mtv dot", 5.5)


def _between(p: Vec, q: Vec) -> Vec:
    return (p[0] + q[0]) / 2, (p[1] + q[1]) / 2
