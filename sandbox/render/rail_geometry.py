"""Where the rail of an axis lies beside two shapes, and which of their points are cast on its ends."""

from __future__ import annotations

from sandbox.geometry.sat_rows import SatRow, Vec
from sandbox.geometry.sat_table import SatTable
from sandbox.geometry.shapes import Shape
from sandbox.render.sat_page import in_sight


def rail_side(table: SatTable, row: SatRow, away: float) -> float:
    """Where along the perpendicular of the axis the rail lies (m): below both shapes or to the right."""
    u = row.axis[0] / row.length, row.axis[1] / row.length
    aside = [(-u[1] * x + u[0] * y, shape.radius) for shape in in_sight(table) for x, y in shape.vertices]
    # (-u[1], u[0]) is the side the rail could lie on; a level rail reads best below, an upright one to the right.
    positive = u[0] < 0.0 if abs(u[0]) >= abs(u[1]) else u[1] < 0.0
    return max(s + r for s, r in aside) + away if positive else min(s - r for s, r in aside) - away


def middle_aside(table: SatTable, u: Vec) -> float:
    """Where the middle of both shapes lies along the perpendicular of an axis."""
    aside = [-u[1] * x + u[0] * y for shape in in_sight(table) for x, y in shape.vertices]
    return sum(aside) / len(aside)


def rail_ends(table: SatTable, row: SatRow, away: float, pad: float) -> list[Vec]:
    """Both ends of a rail in the plane, for the window to hold them."""
    u = row.axis[0] / row.length, row.axis[1] / row.length
    side, shapes = rail_side(table, row, away), in_sight(table)
    ends = [(row.amin, row.amax)] * (table.a in shapes) + [(row.bmin, row.bmax)] * (table.b in shapes)
    low, high = min(least for least, _ in ends) / row.length, max(most for _, most in ends) / row.length
    return [rail_point(u, low - pad, side), rail_point(u, high + pad, side)]


def rail_point(u: Vec, along: float, aside: float) -> Vec:
    """The point of the plane `along` metres along the unit vector u, and `aside` metres to its left."""
    return u[0] * along - u[1] * aside, u[1] * along + u[0] * aside


def extreme_point(shape: Shape, u: Vec, high: bool) -> Vec:
    """The point of a shape that goes farthest along u, or against it."""
    sign = 1.0 if high else -1.0
    x, y = max(shape.vertices, key=lambda v: sign * (u[0] * v[0] + u[1] * v[1]))
    return x + sign * shape.radius * u[0], y + sign * shape.radius * u[1]
