"""An axis beside the shapes: the two intervals on it, and the lines that cast them."""

from __future__ import annotations

from sandbox.geometry.sat_rows import SatRow, Vec
from sandbox.render.number_text import metres, short
from sandbox.render.theme import Color
from sandbox.window.sat.pen import Anchor
from sandbox.window.sat.rail import Rail, drops, rail_of
from sandbox.window.sat.sheet import Sheet

BAND, LANE, BAR = 15.0, 7.0, 6.0
"""Pixels: half the width of the band on a rail, how far the bars lie from its middle, their thickness."""
SHIFTS = (0.0, 22.0, -22.0, 44.0, -44.0, 66.0, -66.0)
"""Pixels along a rail by which the outcome gives way to what stands beside it, the best first."""


class RailDrawing(Sheet):
    """Draws rails."""

    def rail(self, axis: Vec, row: SatRow | None = None) -> None:
        """An axis beside the shapes with both intervals, and what casts them; of a `row`, with its numbers."""
        rail = rail_of(self.seen.table, axis, self.camera)
        gap = row.gap if row is not None else rail.separation >= 0.0
        self._band(rail, gap)
        self._line(rail)
        for number, (shape, color) in enumerate(((self.seen.a, self.colors.a), (self.seen.b, self.colors.b))):
            off = (LANE if number else -LANE) / self.pen.scale
            ends = rail.b if number else rail.a
            extremes, corners = drops(shape, rail.unit)
            if len(corners) <= 16:
                for corner in corners:
                    self._drop(rail, corner, color, 0.28)
            for corner in extremes:
                self._drop(rail, corner, color, 0.9)
            self.pen.line(rail.at(ends[0], off), rail.at(ends[1], off), color, BAR)
        self._words(rail, gap, row)

    def _line(self, rail: Rail) -> None:
        pad = 26.0 / self.pen.scale
        low, high = min(rail.a[0], rail.b[0]) - pad, max(rail.a[1], rail.b[1]) + pad
        self.pen.arrow(rail.at(low), rail.at(high), self.pen.palette.faint, 1.2, 9.0)

    def _band(self, rail: Rail, gap: bool) -> None:
        """What parts the intervals, or what they share; never so thin that it cannot be seen."""
        low, high = rail.shared
        least = 1.5 / self.pen.scale
        if high - low < 2 * least:
            low, high = (low + high) / 2 - least, (low + high) / 2 + least
        wide = BAND / self.pen.scale
        corners = [rail.at(low, -wide), rail.at(high, -wide), rail.at(high, wide), rail.at(low, wide)]
        color = self.colors.gap if gap else self.colors.out
        self.pen.fill(corners, color, 0.35)
        for at in (low, high):
            self.pen.line(rail.at(at, -wide), rail.at(at, wide), color, 1.5)

    def _drop(self, rail: Rail, corner: Vec, color: Color, opacity: float) -> None:
        along = corner[0] * rail.unit[0] + corner[1] * rail.unit[1]
        self.pen.line(corner, rail.at(along), color, 1.0, opacity, dash=(3.0, 4.0))

    def _words(self, rail: Rail, gap: bool, row: SatRow | None) -> None:
        """The ends of both intervals, and what comes of it: beyond the rail, or before it where there is no room.

        Numbers are projections as in the table, or metres for an axis that is in no table.
        """
        anchor, offs = _beside(rail)
        values = (*rail.a, *rail.b) if row is None else (row.amin, row.amax, row.bmin, row.bmax)
        ends = [
            (along, short(value), k // 2)
            for k, (along, value) in enumerate(zip((*rail.a, *rail.b), values, strict=True))
        ]
        inside = [end for end in ends if self.pen.sees(self.pen.pixel(rail.at(end[0])))]
        near = any(not self._fits(rail, along, offs[lane], words, anchor) for along, words, lane in inside)
        back: Anchor = "right" if anchor == "left" else "left" if anchor == "right" else anchor
        for along, words, lane in ends:
            off = -offs[lane] if near else offs[lane]
            at = self.pen.pixel(rail.at(along, off / self.pen.scale))
            self.pen.label(at, words, (self.colors.a, self.colors.b)[lane], back if near else anchor, size=13.0)
        words = f"gap {metres(rail.separation)}" if gap else f"overlap {metres(-rail.separation)}"
        sign, scale = -1.0 if near else 1.0, self.pen.scale
        places = [
            (self.pen.pixel(rail.at(sum(rail.shared) / 2 + shift / scale, off / scale)), anchor if off > 0.0 else back)
            for shift in SHIFTS
            for off in (sign * offs[2], -sign * offs[2], -sign * offs[0], sign * offs[0])
        ]
        fitting = [place for place in places if self.pen.fits(place[0], words, place[1])] or places
        at, side = next((place for place in fitting if self.pen.is_free(place[0], words, place[1])), fitting[0])
        self.pen.label(at, words, self.colors.gap if gap else self.colors.out, side, bold=True)

    def _fits(self, rail: Rail, along: float, off: float, words: str, anchor: Anchor) -> bool:
        return self.pen.fits(self.pen.pixel(rail.at(along, off / self.pen.scale)), words, anchor)


def _beside(rail: Rail) -> tuple[Anchor, tuple[float, float, float]]:
    """How words beside a rail are anchored, and how many pixels from it: numbers of a, of b, and the outcome."""
    across = -rail.unit[1] * rail.outwards
    if abs(across) < 0.5:
        return "middle", (24.0, 41.0, 60.0)
    return "left" if across > 0.0 else "right", (20.0, 70.0, 124.0)
