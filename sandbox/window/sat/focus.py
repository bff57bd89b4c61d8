"""What the user points at and has chosen in the inspector."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.geometry.sat_rows import SatRow
from sandbox.window.sat.inspection import Inspection
from sandbox.window.sat.overlap_curve import axis_angle, nearest_row

SNAP_DEGREES = 2.5
"""How near a free axis must come to that of an edge to be taken for it."""


@dataclass
class Focus:
    """Numbers of rows, from 1: `pointed` in the panel and `lit` in the scene are under the pointer, `chosen` was
    clicked. `free` is the angle of the free axis in degrees, 0 to 360, None while there is none; `step` that of the
    tour, None while nothing is told.
    """

    pointed: int | None = None
    lit: int | None = None
    chosen: int | None = None
    free: float | None = None
    step: int | None = None

    @property
    def hovered(self) -> int | None:
        """The row that is pointed at, wherever."""
        return self.pointed if self.pointed is not None else self.lit

    def row(self, seen: Inspection) -> SatRow | None:
        """The row to show: pointed at, else chosen, else the deciding one unless a free axis is turned."""
        row = seen.row(self.hovered)
        if row is not None or self.free is not None:
            return row
        return seen.row(self.chosen) or seen.deciding

    def turn(self, seen: Inspection, angle: float, snap: bool = True) -> None:
        """Turn the free axis to an angle in degrees; with `snap`, exactly to that of an edge that is near."""
        angle %= 360.0
        row = nearest_row(seen.table, angle % 180.0, SNAP_DEGREES) if snap else None
        if row is not None:
            exact = axis_angle(row.axis)
            angle = min((exact, exact + 180.0, exact + 360.0), key=lambda one: abs(one - angle)) % 360.0
        self.free, self.step = angle, None

    def forget(self) -> None:
        """Another pair."""
        self.pointed = self.lit = self.chosen = self.step = None
