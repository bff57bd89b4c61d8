"""The separating-axis test of one pair: the axis that decides, the interval of each shape on it, and the way out."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from sandbox.geometry.nearest_pair import nearest_pair
from sandbox.geometry.sat_table import SatTable, sat_table
from sandbox.geometry.shapes import Shape
from sandbox.render.camera import Floats
from sandbox.render.contour import contour
from sandbox.render.label import LETTER
from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen
from sandbox.render.overlays.scale import length_text
from sandbox.render.sat_labels import axis_name, deciding_row
from sandbox.render.theme import Color

SAT = "sat"
"""Its name stands before the two bodies: `sat:crate:ramp`."""
RAIL_PIXELS = 34.0
"""Distance of the rail from the smaller shape."""
LEAST_PIXELS, SHOWN_PIXELS = 3.0, 30.0
"""A way out shorter than the one is drawn as long as the other, as an arrow only."""
EDGE_PIXELS, TEXT = 14.0, 12.0
_BAR, _APART = 6.0, 11.0
_OVERHANG = 90.0
"""Pixels by which the axis goes on beyond the part of it that matters."""


def sat_overlay(names: tuple[str, str]) -> Overlay:
    """The overlay that shows the test of two bodies, by their ids; nothing while one of them is not there."""
    a, b = names
    help_text = f"The separating-axis test of {a} and {b}: the axis that decides, and both intervals."
    return Overlay(f"{SAT}:{a}:{b}", f"Separating axis: {a}, {b}", help_text, partial(_draw, names))


def _draw(names: tuple[str, str], look: Look) -> Marks:
    if any(name not in look.frame.roster.names for name in names):
        return Marks()
    shapes = tuple(look.world.body(name).shapes for name in names)
    i, j = nearest_pair(*shapes)
    table = sat_table(shapes[0][i], shapes[1][j])
    pen, color = Pen(look), look.palette
    _highlight(look, pen, table.a, color.blue)
    _highlight(look, pen, table.b, color.orange)
    _rail(look, pen, table)
    row = deciding_row(table)
    pen.legend(color.blue, names[0])
    pen.legend(color.orange, names[1])
    if table.mtv is None:
        pen.legend(color.green, f"gap {length_text(row.separation)} along axis {row.number}, {axis_name(row, names)}")
    else:
        pen.legend(
            color.red, f"way out {length_text(-row.separation)} along axis {row.number}, {axis_name(row, names)}"
        )
        _way_out(look, pen, table)
    return pen.marks()


def _highlight(look: Look, pen: Pen, shape: Shape, color: Color) -> None:
    ring = _ring(look, shape)
    pen.lines(ring, np.roll(ring, -1, axis=0), 2.2, color, halo=True)


def _ring(look: Look, shape: Shape, moved: tuple[float, float] = (0.0, 0.0)) -> Floats:
    """The outline of a shape in pixels."""
    ring = contour(np.array(shape.vertices), shape.radius, 0.25 / look.camera.scale)
    return look.camera.to_screen(ring + np.array(moved))


def _rail(look: Look, pen: Pen, table: SatTable) -> None:
    """The deciding axis as a rail beside the shapes, with both intervals and their drops."""
    row, color = deciding_row(table), look.palette
    unit = np.array(row.axis) / row.length
    along = unit * (1.0, -1.0)
    rings = _ring(look, table.a), _ring(look, table.b)
    side, base = _beside(look, along, rings)
    spans = []
    for k, (ring, ink) in enumerate(zip(rings, (color.blue, color.orange), strict=True)):
        place = ring @ along
        ends = ring[[int(place.argmin()), int(place.argmax())]]
        feet = np.array([_foot(end, along, side, base + _APART * k) for end in ends])
        pen.dashes(ends, feet, 1.2, ink, 0.8)
        pen.lines(feet[:1], feet[1:], _BAR, ink, halo=True)
        spans.append((float(place.min()), float(place.max())))
    (a0, a1), (b0, b1) = spans
    low, high = _way(table, spans)
    _between(pen, table, np.array([along * low, along * high]) + side * (base + 2.0 * _APART), side)
    near = np.sort([a0, a1, b0, b1])
    middle = along * np.clip(near[1:3], near[1] - 600.0, near[2] + 600.0)[:, None] + side * (base + 0.5 * _APART)
    pen.lines(middle[:1] - _OVERHANG * along, middle[1:] + _OVERHANG * along, 1.0, color.quiet)


def _way(table: SatTable, spans: Sequence[tuple[float, float]]) -> tuple[float, float]:
    """The gap between both intervals, or the way that b goes until they are apart."""
    (a0, a1), (b0, b1) = spans
    row = deciding_row(table)
    if row.gap:
        return min(a1, b1), max(a0, b0)
    return (b0, a1) if row.way > 0 else (a0, b1)


def _beside(look: Look, along: Floats, rings: tuple[Floats, Floats]) -> tuple[Floats, float]:
    """The direction (2,) to the rail, across the axis, and how far it lies from the origin of pixels along that.

    It lies beside both shapes if it is in sight there, else beside the smaller one, towards the middle of the picture.
    """
    across, size = np.array([-along[1], along[0]]), np.asarray(look.camera.size)
    low, high = EDGE_PIXELS, size - EDGE_PIXELS
    for side in (across, -across):
        base = max(float((ring @ side).max()) for ring in rings) + RAIL_PIXELS
        ends = np.array([_foot(point, along, side, base + 3.0 * _APART) for ring in rings for point in ring])
        if (ends >= low).all() and (ends <= high).all():
            return side, base
    small = min(rings, key=lambda ring: float(np.ptp(ring, axis=0).max()))
    inwards = across if (size / 2.0 - small.mean(axis=0)) @ across > 0.0 else -across
    return inwards, float((small @ inwards).max()) + RAIL_PIXELS


def _foot(point: Floats, along: Floats, side: Floats, base: float) -> Floats:
    foot: Floats = along * float(point @ along) + side * base
    return foot


def _between(pen: Pen, table: SatTable, ends: Floats, side: Floats) -> None:
    """The gap between the intervals, or the way out of each other, with its length."""
    row, color = deciding_row(table), pen.palette
    ink = color.green if table.mtv is None else color.red
    pen.lines(ends[:1], ends[1:], 3.0, ink, halo=True)
    text = length_text(abs(row.separation))
    away = 12.0 + 0.5 * LETTER * TEXT * len(text) * abs(float(side[0]))
    pen.words(text, ends.mean(axis=0) + away * side, ink, rank=10.0)


def _way_out(look: Look, pen: Pen, table: SatTable) -> None:
    """Where b just leaves a, and the arrow that leads there."""
    assert table.mtv is not None
    assert table.contact is not None
    way = np.array(table.mtv) * (look.camera.scale, -look.camera.scale)
    size = float(np.hypot(*way))
    if size >= LEAST_PIXELS:
        ghost = _ring(look, table.b, table.mtv)
        pen.dashes(ghost, np.roll(ghost, -1, axis=0), 1.4, look.palette.purple, 0.9)
        pen.legend(look.palette.purple, "minimum translation vector of the second, and where it leads")
    else:
        way = way * (SHOWN_PIXELS / max(size, 1e-300))
        pen.legend(look.palette.purple, "direction of the minimum translation vector, which is too short to see")
    middle = look.camera.to_screen(np.mean(table.b.vertices, axis=0))
    if not look.visible(middle[None])[0]:
        middle = look.camera.to_screen(np.mean(table.contact.points, axis=0))
    pen.arrows(middle[None], way[None], 2.6, look.palette.purple)
