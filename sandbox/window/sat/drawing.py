"""What the inspector draws over the scene: shapes, one rail, the outcome, and the steps of the clipping."""

from __future__ import annotations

import math
from dataclasses import dataclass

from sandbox.geometry.sat_rows import SatRow, Vec
from sandbox.geometry.shapes import Shape
from sandbox.render.camera import Camera
from sandbox.render.number_text import metres, short
from sandbox.window.sat.colors import SatColors
from sandbox.window.sat.inspection import Inspection
from sandbox.window.sat.pen import Anchor, Pen
from sandbox.window.sat.rail import Rail, drops, rail_of

BAND, LANE, BAR = 15.0, 7.0, 6.0
"""Pixels: half the width of the band on a rail, how far the bars lie from its middle, their thickness."""
SHORTEST_ARROW, TOO_SHORT = 30.0, 9.0
"""A way out is drawn as long as the first, and says so, where it has fewer pixels than the second."""
NUMBERS_FROM = 70.0
"""Pixels that a shape must measure for its corners to be numbered."""


@dataclass(frozen=True)
class Drawing:
    """A pen, what it draws in which colours, and the camera that sees it."""

    pen: Pen
    seen: Inspection
    colors: SatColors
    camera: Camera

    def shapes(self) -> None:
        """Both shapes with their corners."""
        both = ((self.seen.a, self.colors.a), (self.seen.b, self.colors.b))
        for shape, _ in both:  # the colours of the scene are to be seen no more: a and b have their own
            self.pen.shape(shape, self.pen.theme.background, 0.72)
        for shape, color in both:
            self.pen.shape(shape, color, 0.32)
        for shape, color in both:
            self.pen.rim(shape, color)
            large = _span(shape) * self.pen.scale
            if large < 24.0:
                continue
            middle = _middle(shape.vertices)
            numbered = large >= NUMBERS_FROM and 3 <= len(shape.vertices) <= 16
            for vertex in shape.vertices:
                self.pen.dot(vertex, 2.6, color)
                if numbered:
                    at = self.pen.away(vertex, _unit(vertex, middle), 13.0 + shape.radius * self.pen.scale)
                    self.pen.label(at, str(shape.given.index(vertex) + 1), color, bold=True, size=12.0)

    def edge(self, row: SatRow) -> None:
        """Light up the edge that gave an axis, or the two vertices, and the axis itself as an arrow from there."""
        color = self.colors.of(row.owner)
        if row.owner == "corners":
            p, q = self.seen.a.given[row.edge - 1], self.seen.b.given[row.other - 1]
            self.pen.line(p, q, color, 2.5)
            self.pen.dot(p, 4.0, color)
            self.pen.dot(q, 4.0, color)
            return
        start, end, out = self.seen.edges[row.owner, row.edge]
        self.pen.line(start, end, color, 5.5)
        u = row.axis[0] / row.length, row.axis[1] / row.length
        middle = (start[0] + end[0]) / 2, (start[1] + end[1]) / 2
        long = 38.0 / self.pen.scale
        self.pen.arrow(middle, (middle[0] + u[0] * long, middle[1] + u[1] * long), color, 2.5)
        inwards = u[0] * out[0] + u[1] * out[1] < 0.0
        side = (out[0], out[1]) if inwards else (-out[0], -out[1])
        self.pen.label(self.pen.away(middle, side, 18.0), f"E{row.edge}", color, bold=True)

    def perpendiculars(self) -> None:
        """The axis of every edge as an arrow from its middle, with its number."""
        for row in self.seen.table.rows:
            if row.owner == "corners":
                self.edge(row)
                continue
            start, end, _ = self.seen.edges[row.owner, row.edge]
            u = row.axis[0] / row.length, row.axis[1] / row.length
            middle, long = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2), 42.0 / self.pen.scale
            color = self.colors.of(row.owner)
            self.pen.arrow(middle, (middle[0] + u[0] * long, middle[1] + u[1] * long), color, 2.0)
            self.pen.label(self.pen.away(middle, u, 54.0), str(row.number), color, bold=True)

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
        for lane, ends in enumerate((rail.a, rail.b)):
            self._numbers(rail, ends, lane, row)
        self._outcome_label(rail, gap)

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

    def _drop(self, rail: Rail, corner: Vec, color: tuple[float, float, float], opacity: float) -> None:
        along = corner[0] * rail.unit[0] + corner[1] * rail.unit[1]
        self.pen.line(corner, rail.at(along), color, 1.0, opacity, dash=(3.0, 4.0))

    def _numbers(self, rail: Rail, ends: tuple[float, float], lane: int, row: SatRow | None) -> None:
        """The ends of an interval: projections as in the table, or metres for an axis that is in no table."""
        values = ends if row is None else ((row.amin, row.amax), (row.bmin, row.bmax))[lane]
        color = self.colors.b if lane else self.colors.a
        anchor, offs = _beside(rail)
        for value, end in zip(values, ends, strict=True):
            at = self.pen.pixel(rail.at(end, offs[lane] / self.pen.scale))
            self.pen.label(at, short(value), color, anchor, size=13.0)

    def _outcome_label(self, rail: Rail, gap: bool) -> None:
        low, high = rail.shared
        anchor, offs = _beside(rail)
        middle = (low + high) / 2
        at = self.pen.pixel(rail.at(middle, offs[2] / self.pen.scale))
        words = f"gap {metres(rail.separation)}" if gap else f"overlap {metres(-rail.separation)}"
        if not self.pen.fits(at, words, anchor):  # then between rail and shapes
            anchor = "right" if anchor == "left" else "left" if anchor == "right" else anchor
            at = self.pen.pixel(rail.at(middle, -offs[0] / self.pen.scale))
        self.pen.label(at, words, self.colors.gap if gap else self.colors.out, anchor, bold=True)

    def outcome(self) -> None:
        """The way out with the ghost of b where it leads; of shapes that are apart, the strip between them."""
        table = self.seen.table
        if table.mtv is None:
            self._strip(self.seen.deciding)
            return
        self.way_out()
        self.points()

    def way_out(self) -> None:
        """The translation vector of b, and its ghost where that leads."""
        mtv = self.seen.table.mtv
        if mtv is None:
            return
        self.pen.ghost(self.seen.b, mtv, self.colors.mtv)
        depth = math.hypot(*mtv)
        pixels = depth * self.pen.scale
        stretch = SHORTEST_ARROW / pixels if 0.0 < pixels < TOO_SHORT else 1.0
        start = self._arrow_start()
        end = start[0] + mtv[0] * stretch, start[1] + mtv[1] * stretch
        self.pen.arrow(start, end, self.colors.mtv, 3.5, 14.0)
        unit = (mtv[0] / depth, mtv[1] / depth) if depth else (0.0, 1.0)
        words = metres(depth) if stretch <= 1.0 else f"{metres(depth)}, drawn {stretch:.3g} times as long"
        self.pen.label(self.pen.away(end, unit, 16.0), words, self.colors.mtv, bold=True)

    def _arrow_start(self) -> Vec:
        """The middle of b, or, where that is out of sight, of the contact."""
        contact = self.seen.table.contact
        assert contact is not None
        middle = _middle(self.seen.b.vertices)
        left, bottom, right, top = self.camera.bounds
        if left < middle[0] < right and bottom < middle[1] < top:
            return middle
        return _middle(contact.points)

    def _strip(self, row: SatRow) -> None:
        """The strip between the two shapes across the axis that parts them."""
        u = row.axis[0] / row.length, row.axis[1] / row.length
        low, high = sorted((max(row.amin, row.bmin) / row.length, min(row.amax, row.bmax) / row.length))
        reach = math.hypot(*self.camera.size) / self.pen.scale
        x, y = self.camera.center
        aside = -u[1] * x + u[0] * y

        def at(along: float, off: float) -> Vec:
            return u[0] * along - u[1] * (aside + off), u[1] * along + u[0] * (aside + off)

        self.pen.fill([at(low, -reach), at(high, -reach), at(high, reach), at(low, reach)], self.colors.gap, 0.1)
        for along in (low, high):
            self.pen.line(at(along, -reach), at(along, reach), self.colors.gap, 1.3, 0.8, dash=(8.0, 6.0))

    def points(self) -> None:
        """The contact points."""
        contact = self.seen.table.contact
        for point in contact.points if contact is not None else ():
            self.pen.dot(point, 5.0, self.colors.mtv)

    def clipping(self, cut: bool) -> None:
        """Reference face and incident edge; with `cut`, the sides that cut it and what is left."""
        clip = self.seen.clip
        if clip is None:
            return
        mine, other = (self.colors.a, self.colors.b) if clip.owner == "a" else (self.colors.b, self.colors.a)
        nx, ny = clip.normal
        long = math.hypot(*self.camera.size) / self.pen.scale
        self.pen.line(*clip.reference, mine, 5.5)
        self.pen.line(*clip.incident, other, 3.0 if cut else 5.5, 0.55 if cut else 1.0)
        if cut:
            for x, y in clip.reference:
                ends = (x - nx * long, y - ny * long), (x + nx * long, y + ny * long)
                self.pen.line(*ends, self.colors.mtv, 1.3, 0.8, dash=(7.0, 6.0))
            self.pen.line(*clip.clipped, other, 5.5)
            for end, gap in zip(clip.clipped, clip.gaps, strict=True):
                self.pen.dot(end, 5.0, other, hollow=gap > 0.0)
        middle = _between(*clip.reference)
        short_way = 44.0 / self.pen.scale
        self.pen.arrow(middle, (middle[0] + nx * short_way, middle[1] + ny * short_way), mine, 2.5)
        if not cut:
            self.pen.label(self.pen.away(middle, (-nx, -ny), 20.0), "reference face", mine, bold=True)
            self.pen.label(self.pen.away(_between(*clip.incident), (nx, ny), 24.0), "incident edge", other, bold=True)


def _beside(rail: Rail) -> tuple[Anchor, tuple[float, float, float]]:
    """How words beside a rail are anchored, and how many pixels from it: numbers of a, of b, and the outcome."""
    across = -rail.unit[1] * rail.outwards
    if abs(across) < 0.5:
        return "middle", (24.0, 41.0, 60.0)
    return "left" if across > 0.0 else "right", (20.0, 70.0, 124.0)


def edge_near(seen: Inspection, point: Vec, slack: float) -> SatRow | None:
    """The row of the edge that is nearest to a point, if it is at most `slack` metres away."""
    best: tuple[float, SatRow] | None = None
    for row in seen.table.rows:
        if row.owner == "corners":
            continue
        start, end, _ = seen.edges[row.owner, row.edge]
        off = _distance(point, start, end)
        if off <= slack and (best is None or off < best[0]):
            best = off, row
    return None if best is None else best[1]


def _distance(point: Vec, start: Vec, end: Vec) -> float:
    dx, dy = end[0] - start[0], end[1] - start[1]
    along = ((point[0] - start[0]) * dx + (point[1] - start[1]) * dy) / (dx * dx + dy * dy)
    along = min(max(along, 0.0), 1.0)
    return math.hypot(point[0] - start[0] - along * dx, point[1] - start[1] - along * dy)


def _middle(points: tuple[Vec, ...]) -> Vec:
    return sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points)


def _between(p: Vec, q: Vec) -> Vec:
    return (p[0] + q[0]) / 2, (p[1] + q[1]) / 2


def _unit(point: Vec, middle: Vec) -> Vec:
    long = math.dist(point, middle)
    return ((point[0] - middle[0]) / long, (point[1] - middle[1]) / long) if long > 0.0 else (0.0, 1.0)


def _span(shape: Shape) -> float:
    xs, ys = [x for x, _ in shape.vertices], [y for _, y in shape.vertices]
    return max(max(xs) - min(xs), max(ys) - min(ys)) + 2 * shape.radius
