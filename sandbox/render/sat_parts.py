"""Convex and concave: what a rubber band would add to a shape and what that hides, and the gaps of its convex parts."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from sandbox.geometry.sat_rows import Vec
from sandbox.geometry.sat_table import SatTable, sat_table
from sandbox.geometry.shape_box import box_of
from sandbox.geometry.shapes import Polygon
from sandbox.render.sat_page import EDGE, HEAD, SatFigure, Whole, draw_outcome, page
from sandbox.render.sat_plane import Plane
from sandbox.render.svg import Pixel, Svg, number

_SIZE, _WORDS = (440, 380), 30.0
"""Pixels: each of the two windows, and the line of words above it."""
_MOST_VERTICES = 64


def draw_parts(figure: SatFigure) -> Svg:
    """Both bodies as wholes with their rubber bands, and beside that as convex parts with a line through every gap."""
    a, b = figure.wholes or (Whole((figure.table.a,)), Whole((figure.table.b,)))
    tables = [sat_table(p, q) for p in a.parts for q in b.parts]
    svg = page(EDGE * 3 + 2 * _SIZE[0], HEAD + _WORDS + _SIZE[1] + EDGE, figure, _words(a, b, tables))
    seen = [corner for shape in (*a.parts, *b.parts) for corner in (box_of(shape)[:2], box_of(shape)[2:])]
    with _window(svg, EDGE, "with a rubber band round each", seen) as left:
        for whole, kind in ((a, "a"), (b, "b")):
            _draw_whole(left, whole, kind)
    pieces = " and ".join(str(len(whole.parts)) for whole in (a, b))
    with _window(svg, 2 * EDGE + _SIZE[0], f"cut into convex parts: {pieces}", seen) as right:
        for whole, kind in ((a, "a"), (b, "b")):
            for part in whole.parts:
                right.shape(part, f"{kind} shape")
        for table in tables:
            if not table.colliding:
                draw_outcome(right, table)
    return svg


def _window(svg: Svg, left: float, words: str, seen: Sequence[Vec]) -> Plane:
    svg.text((left + 2, HEAD + 16), words, "strong")
    return Plane(svg, (left, HEAD + _WORDS), _SIZE, seen)


def _words(a: Whole, b: Whole, tables: Sequence[SatTable]) -> str:
    overlapping = sum(table.colliding for table in tables)
    if overlapping:
        return f"pairs of convex parts that overlap: {overlapping} of {len(tables)}"
    pairs = f"each of the {len(tables)} pairs of convex parts has a gap" if len(tables) > 1 else "one gap is enough"
    return f"no straight line goes between the two, but {pairs}" if _hidden(a, b) else pairs


def _hidden(a: Whole, b: Whole) -> bool:
    """Whether the rubber bands overlap; those of discs, and of very many vertices, are not asked."""
    if any(shape.radius for shape in (*a.parts, *b.parts)):
        return False
    bands = _band(a), _band(b)
    if not all(3 <= len(band) <= _MOST_VERTICES for band in bands):
        return False
    return sat_table(Polygon(tuple(bands[0])), Polygon(tuple(bands[1]))).colliding


def _draw_whole(plane: Plane, whole: Whole, kind: str) -> None:
    """Outlines, and in pink what the band adds; a body without concave polygons as it is."""
    if not whole.rings:
        for part in whole.parts:
            plane.shape(part, f"{kind} shape")
        return
    band, backwards = _band(whole), [ring[::-1] for ring in whole.rings]
    plane.svg.path(_path(plane, [band, *backwards]), "out band")
    sides = {frozenset(side) for ring in whole.rings for side in pairwise([*ring, ring[0]])}
    for side in pairwise([*band, band[0]]):
        if frozenset(side) not in sides:
            plane.line(*side, "out line")
    plane.svg.path(_path(plane, whole.rings), f"{kind} shape")


def _path(plane: Plane, rings: Sequence[Sequence[Vec]]) -> str:
    return " ".join("M" + " L".join(_pair(plane.pixel(point)) for point in ring) + " Z" for ring in rings)


def _pair(pixel: Pixel) -> str:
    return f"{number(pixel[0])} {number(pixel[1])}"


def _band(whole: Whole) -> list[Vec]:
    """The convex hull of all vertices, counter-clockwise (A. M. Andrew, 1979)."""
    points = sorted({vertex for part in whole.parts for vertex in part.vertices})
    halves = []
    for way in (points, points[::-1]):
        half: list[Vec] = []
        for point in way:
            while len(half) > 1 and _turn(half[-2], half[-1], point) <= 0.0:
                half.pop()
            half.append(point)
        halves.append(half[:-1])
    return halves[0] + halves[1]


def _turn(p: Vec, q: Vec, r: Vec) -> float:
    return (q[0] - p[0]) * (r[1] - q[1]) - (q[1] - p[1]) * (r[0] - q[0])
