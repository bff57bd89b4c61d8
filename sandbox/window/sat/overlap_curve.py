"""Overlap as a function of the axis' angle: what the test would find on every line, not only across edges."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sandbox.geometry.sat_rows import SatRow, Vec
from sandbox.geometry.sat_table import SatTable
from sandbox.geometry.shapes import Shape
from sandbox.render.camera import Floats

SAMPLES = 361
"""Angles from 0 to 180 degrees, every half degree."""


@dataclass(frozen=True)
class OverlapCurve:
    """`angles` (n,) in degrees, 0 to 180, rising, those of all axes among them; `overlap` (n,) in metres.

    Below 0, the overlap is a gap.
    """

    angles: Floats
    overlap: Floats

    @property
    def limits(self) -> tuple[float, float]:
        """Least and greatest overlap (m)."""
        return float(self.overlap.min()), float(self.overlap.max())


def overlap_curve(table: SatTable) -> OverlapCurve:
    """The curve of a pair: its kinks downwards, the minima of an overlap, are at the axes of the table."""
    own = [axis_angle(row.axis) for row in table.rows]
    angles = np.union1d(np.linspace(0.0, 180.0, SAMPLES), own)
    return OverlapCurve(angles, overlap_at(table.a, table.b, angles))


def overlap_at(a: Shape, b: Shape, angles: Floats) -> Floats:
    """The overlap (m) of two shapes along axes at `angles` (n,) in degrees; negative, the gap."""
    turn = np.radians(angles)
    units = np.stack([np.cos(turn), np.sin(turn)])
    (alow, ahigh), (blow, bhigh) = _ends(a, units), _ends(b, units)
    overlap: Floats = np.minimum(ahigh - blow, bhigh - alow)
    return overlap


def axis_angle(axis: Vec) -> float:
    """The angle of an axis in degrees, from 0 to below 180: an axis is a line."""
    angle = math.degrees(math.atan2(axis[1], axis[0])) % 180.0
    return 0.0 if angle >= 180.0 else angle


def axis_at(angle: float) -> Vec:
    """The unit axis at an angle in degrees."""
    turn = math.radians(angle)
    return math.cos(turn), math.sin(turn)


def nearest_row(table: SatTable, angle: float, within: float) -> SatRow | None:
    """The row whose axis is nearest to an angle (degrees), if it is at most `within` degrees away."""

    def off(row: SatRow) -> float:
        difference = abs(axis_angle(row.axis) - angle) % 180.0
        return min(difference, 180.0 - difference)

    row = min(table.rows, key=off, default=None)
    return row if row is not None and off(row) <= within else None


def _ends(shape: Shape, units: Floats) -> tuple[Floats, Floats]:
    along = np.asarray(shape.vertices) @ units
    return along.min(axis=0) - shape.radius, along.max(axis=0) + shape.radius
