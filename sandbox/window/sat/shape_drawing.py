"""The two shapes over the scene, their corners and edges, and which edge is under the pointer."""

from __future__ import annotations

import math

from sandbox.geometry.sat_rows import SatRow, Vec
from sandbox.geometry.shapes import Shape
from sandbox.window.sat.inspection import Inspection
from sandbox.window.sat.sheet import Sheet, middle_of

NUMBERS_FROM = 70.0
"""Pixels that a shape must measure for its corners to be numbered."""


class ShapeDrawing(Sheet):
    """Draws shapes and edges."""

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
            middle = middle_of(shape.vertices)
            numbered = large >= NUMBERS_FROM and 2 <= len(shape.vertices) <= 16
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


def _unit(point: Vec, middle: Vec) -> Vec:
    long = math.dist(point, middle)
    return ((point[0] - middle[0]) / long, (point[1] - middle[1]) / long) if long > 0.0 else (0.0, 1.0)


def _span(shape: Shape) -> float:
    xs, ys = [x for x, _ in shape.vertices], [y for _, y in shape.vertices]
    return max(max(xs) - min(xs), max(ys) - min(ys)) + 2 * shape.radius
