"""Rails: an axis with the two intervals on it, side by side in a list, or where the axis lies in the plane."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import islice

from sandbox.geometry.sat_rows import SatRow, Vec, sat_rows
from sandbox.geometry.sat_table import SatTable
from sandbox.render.number_text import short
from sandbox.render.rail_geometry import extreme_point, middle_aside, rail_point, rail_side
from sandbox.render.sat_labels import axis_name, way_out
from sandbox.render.sat_plane import Plane
from sandbox.render.svg import Pixel, Svg

ROW = 54.0
"""Height of one rail in a list, in pixels."""
_NAME, _SIDE, _RESULT = 176.0, 58.0, 132.0
"""Widths: of the name of an axis, of the numbers beside the bars, of the gap or the way out."""


@dataclass(frozen=True)
class RailList:
    """All rails of a table below each other, in one scale of metres, from pixel `at` on."""

    svg: Svg
    at: Pixel
    width: float
    table: SatTable
    names: tuple[str, str]

    def draw(self, room: int) -> None:
        """Every row, the deciding one set off; then, up to `room` lines, the axes that were not needed."""
        for k, row in enumerate(self.table.rows):
            self._row(row, self.at[1] + k * ROW)
        done, last = len(self.table.rows), self.table.axis_count
        cut = last if last <= room else room - 1
        for row in islice(sat_rows(self.table.a, self.table.b), done, max(done, cut)):
            self._untested(row, self.at[1] + (row.number - 1) * ROW)
        if done < room and cut < last:
            self.svg.text((self.at[0] + 24, self.at[1] + cut * ROW + 24), f"and {last - cut} more", "soft small faint")

    def _untested(self, row: SatRow, top: float) -> None:
        """An axis that an earlier gap made needless."""
        left, y = self.at[0], top + 24
        self.svg.text((left, y), str(row.number), "number soft faint")
        self.svg.text((left + 24, y), axis_name(row, self.names), "soft small faint")
        self.svg.line((left + _NAME, top + 27), (left + _NAME + 2 * _SIDE + self._room(), top + 27), "rail drop")
        self.svg.text((left + self.width, y), "not needed", "soft small faint", "end")

    def _row(self, row: SatRow, top: float) -> None:
        svg, left = self.svg, self.at[0]
        marked = row is self.table.mtv_row or row.stopped
        if marked:
            svg.rectangle(left - 10, top + 2, self.width + 20, ROW - 4, "lit", 8.0)
        svg.text((left, top + 24), str(row.number), "number strong" if marked else "number soft")
        color = "text" if row.owner == "corners" else row.owner
        svg.text((left + 24, top + 24), axis_name(row, self.names), f"{color} strong small")
        svg.text((left + 24, top + 41), f"({short(row.axis[0])}, {short(row.axis[1])})", "soft small number")
        self._rail(row, top)
        kind = "gap" if row.gap else "mtv" if marked else "out"
        right = left + self.width
        svg.text((right, top + 24), way_out(row), f"{kind} strong small number", "end")
        note = "the test stops here" if row.stopped else "least: the way out" if marked else ""
        svg.text((right, top + 41), note, "soft small", "end")

    def _rail(self, row: SatRow, top: float) -> None:
        """The axis as a level line, a above and b below it, with their four numbers."""
        svg, scale = self.svg, self._scale()
        start, left = min(row.amin, row.bmin), self.at[0] + _NAME
        spare = self._room() - (max(row.amax, row.bmax) - start) / row.length * scale
        zero = left + _SIDE + spare / 2

        def x(value: float) -> float:
            return zero + (value - start) / row.length * scale

        self._band(row, top, x)
        svg.line((left, top + 27), (left + 2 * _SIDE + self._room(), top + 27), "rail")
        ends = (("a", row.amin, row.amax, top + 19.5), ("b", row.bmin, row.bmax, top + 34.5))
        for kind, low, high, y in ends:
            svg.line((x(low), y), (max(x(high), x(low) + 0.5), y), f"{kind} bar")
            svg.text((x(low) - 8, y + 4.5), short(low), f"{kind} small number", "end")
            svg.text((x(high) + 8, y + 4.5), short(high), f"{kind} small number")
        if row is self.table.mtv_row:
            near, edge = (row.bmin, row.amax) if row.way > 0 else (row.bmax, row.amin)
            svg.arrow((x(near), top + 27), (x(edge), top + 27), "mtv axis", 8.0)

    def _band(self, row: SatRow, top: float, x: Callable[[float], float]) -> None:
        """What parts the intervals, or what they share."""
        low, high = sorted((max(row.amin, row.bmin), min(row.amax, row.bmax)))
        left, right = x(low), x(high)
        self.svg.rectangle(left, top + 8, right - left, 38, "gap band" if row.gap else "out band", 2.0)

    def _room(self) -> float:
        """Pixels for the bars themselves: what labels at both sides and numbers at both ends leave."""
        return self.width - _NAME - 2 * _SIDE - _RESULT

    def _scale(self) -> float:
        spans = [(max(row.amax, row.bmax) - min(row.amin, row.bmin)) / row.length for row in self.table.rows]
        return self._room() / max(spans)


def plane_rail(plane: Plane, table: SatTable, row: SatRow) -> None:
    """One axis drawn beside the shapes, with the lines that cast their extreme points on it."""
    u = row.axis[0] / row.length, row.axis[1] / row.length
    side = rail_side(table, row, 44.0 / plane.scale)
    svg = plane.svg
    low, high = min(row.amin, row.bmin) / row.length, max(row.amax, row.bmax) / row.length
    pad = 24.0 / plane.scale
    plane.arrow(rail_point(u, low - pad, side), rail_point(u, high + pad, side), "rail", 9.0)
    _plane_band(plane, row, u, side)
    below = abs(u[0]) >= abs(u[1])
    both = (("a", table.a, row.amin, row.amax, 1), ("b", table.b, row.bmin, row.bmax, 2))
    outwards = 1.0 if side > middle_aside(table, u) else -1.0
    for kind, shape, least, most, lane in both:
        off = outwards * (-7.0 if lane == 1 else 7.0) / plane.scale
        ends = rail_point(u, least / row.length, side + off), rail_point(u, most / row.length, side + off)
        svg.line(plane.pixel(ends[0]), plane.pixel(ends[1]), f"{kind} bar")
        # Numbers of a level rail need a line of text each, those of an upright one a column each.
        words = outwards * (22.0 + (lane - 1) * (16.0 * abs(u[0]) + 40.0 * abs(u[1]))) / plane.scale
        for value, end in ((least, ends[0]), (most, ends[1])):
            svg.line(plane.pixel(extreme_point(shape, u, value == most)), plane.pixel(end), f"{kind} drop")
            x, y = plane.pixel(rail_point(u, value / row.length, side + words))
            anchor = "middle" if below else "start"
            svg.text((x, y + 4.5), short(value), f"{kind} small strong number", anchor)


def _plane_band(plane: Plane, row: SatRow, u: Vec, side: float) -> None:
    low, high = sorted((max(row.amin, row.bmin) / row.length, min(row.amax, row.bmax) / row.length))
    wide = 14.0 / plane.scale
    corners = [(low, -wide), (high, -wide), (high, wide), (low, wide)]
    band = [plane.pixel(rail_point(u, along, side + aside)) for along, aside in corners]
    plane.svg.polygon(band, "gap band" if row.gap else "out band")
