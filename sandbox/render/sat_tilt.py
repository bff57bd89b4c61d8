"""Why edges are enough: the strip between the nearest points, turned until it lies along an edge."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from sandbox.geometry.collide import distance
from sandbox.geometry.sat_rows import Vec, author_edges
from sandbox.geometry.shapes import Shape
from sandbox.render.number_text import metres
from sandbox.render.sat_labels import headline
from sandbox.render.sat_page import SatFigure, alone, draw_outcome, draw_shapes
from sandbox.render.sat_plane import Plane
from sandbox.render.svg import Svg, number

_ALONG = 1e-9
"""Angle (rad) below which the strip lies along the edge as it is; also how near, as a share, a point is on an edge."""
_ARC = 96.0
"""Pixels from a nearest point to the arrow that shows the turn."""


class Strip(NamedTuple):
    """The nearest points `p` and `q` of two cores with the unit `normal` from p to q, and the radii about the cores.

    `turn` (rad, counter-clockwise) is the least that lays the strip along an edge, `edge` is its name, or empty.
    """

    p: Vec
    q: Vec
    normal: Vec
    radii: tuple[float, float]
    turn: float
    edge: str

    @property
    def before(self) -> float:
        """Distance of the two shapes (m)."""
        return math.dist(self.p, self.q) - sum(self.radii)

    @property
    def after(self) -> float:
        """Width of the strip once it is turned (m)."""
        return math.dist(self.p, self.q) * math.cos(self.turn) - sum(self.radii)

    def borders(self, normal: Vec) -> tuple[Vec, Vec]:
        """A point on either border, across `normal`."""
        (px, py), (qx, qy), (nx, ny), (r, s) = self.p, self.q, normal, self.radii
        return (px + nx * r, py + ny * r), (qx - nx * s, qy - ny * s)


def draw_tilt(figure: SatFigure) -> Svg:
    """The strip between the nearest points and what is left of it along an edge; of shapes that touch, the outcome."""
    strip = strip_of(figure)
    svg, plane = alone(figure, headline(figure.table, figure.names) if strip is None else _words(strip))
    with plane:
        if strip is not None and strip.edge:
            _band(plane, strip)
        draw_shapes(plane, figure.table)
        if strip is None:
            draw_outcome(plane, figure.table)
        else:
            _lines(plane, strip)
    return svg


def _words(strip: Strip) -> str:
    apart = f"nearest points {metres(strip.before)} apart"
    if not strip.edge:
        return f"{apart}, and no edge to turn to"
    if abs(strip.turn) < _ALONG:
        return f"{apart}, straight across {strip.edge}"
    return (
        f"{apart}; turned to {strip.edge}, {f'{metres(strip.after)} are' if strip.after > 0.0 else 'nothing is'} left"
    )


def _lines(plane: Plane, strip: Strip) -> None:
    """The nearest points, the strip across the line between them, and which way it is turned."""
    ends = strip.borders(strip.normal)
    for end in ends:
        plane.through(end, (-strip.normal[1], strip.normal[0]), "other drop")
    plane.line(*ends, "mtv line")
    if abs(strip.turn) > _ALONG and not any(strip.radii):
        _arc(plane, ends[0], strip.turn, (-strip.normal[1], strip.normal[0]))
        _arc(plane, ends[1], strip.turn, (strip.normal[1], -strip.normal[0]))


def _arc(plane: Plane, center: Vec, turn: float, start: Vec) -> None:
    """An arrow about a point, from the direction `start` on."""
    x, y = plane.pixel(center)
    ways = [_turned(start, turn * k / 24) for k in range(25)]
    points = [(x + _ARC * ux, y - _ARC * uy) for ux, uy in ways]
    head = max(0, 24 - math.ceil(18.0 / (_ARC * abs(turn) / 24)))
    shaft = " L".join(f"{number(u)} {number(v)}" for u, v in points[: head + 1])
    plane.svg.path(f"M{shaft}", "mtv axis")
    plane.svg.arrow(points[head], points[-1], "mtv axis", 11.0)


def _band(plane: Plane, strip: Strip) -> None:
    """The strip after its turn."""
    kind = "gap" if strip.after > 0.0 else "out"
    (nx, ny), long = _turned(strip.normal, strip.turn), math.hypot(*plane.size) / plane.scale
    (px, py), (qx, qy) = strip.borders((nx, ny))
    ends = [(x + ny * k, y - nx * k) for x, y, k in ((px, py, long), (px, py, -long), (qx, qy, -long), (qx, qy, long))]
    plane.svg.polygon([plane.pixel(end) for end in ends], f"{kind} band")
    plane.through((px, py), (-ny, nx), f"{kind} line")
    plane.through((qx, qy), (-ny, nx), f"{kind} line")


def strip_of(figure: SatFigure) -> Strip | None:
    """The strip between two shapes; None where they touch or overlap."""
    a, b = figure.table.a, figure.table.b
    nearest = distance(a, b)
    if nearest.points is None or nearest.value <= 0.0:
        return None
    (px, py), (qx, qy) = nearest.points
    nx, ny = (qx - px) / nearest.value, (qy - py) / nearest.value
    p, q = (px - nx * a.radius, py - ny * a.radius), (qx + nx * b.radius, qy + ny * b.radius)
    turns = [*_turns(a, figure.names[0], p, (nx, ny)), *_turns(b, figure.names[1], q, (-nx, -ny))]
    turn, edge = min(turns, key=lambda each: abs(each[0]), default=(0.0, ""))
    return Strip(p, q, (nx, ny), (a.radius, b.radius), turn, edge)


def _turns(shape: Shape, name: str, at: Vec, towards: Vec) -> Iterator[tuple[float, str]]:
    """(angle, edge) for every edge on which a nearest point lies; `towards` is the way to the other shape."""
    for number_, start, end in author_edges(shape):
        if math.dist(start, at) + math.dist(at, end) > (1.0 + _ALONG) * math.dist(start, end):
            continue
        nx, ny = _outwards(shape, start, end, towards)
        turn = math.atan2(towards[0] * ny - towards[1] * nx, towards[0] * nx + towards[1] * ny)
        yield turn, f"edge {number_} of {name}"


def _outwards(shape: Shape, start: Vec, end: Vec, towards: Vec) -> Vec:
    """The perpendicular (m) of an edge that points away from its polygon; of a line, the one on the other's side."""
    nx, ny = start[1] - end[1], end[0] - start[0]
    if len(shape.vertices) < 3:
        inwards = -nx * towards[0] - ny * towards[1]
    else:
        inwards = sum(nx * (x - start[0]) + ny * (y - start[1]) for x, y in shape.vertices)
    return (-nx, -ny) if inwards > 0.0 else (nx, ny)


def _turned(vector: Vec, angle: float) -> Vec:
    (x, y), c, s = vector, math.cos(angle), math.sin(angle)
    return c * x - s * y, s * x + c * y
