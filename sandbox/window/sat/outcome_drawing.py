"""What comes of the test: the strip of a gap, or the way out, the clipping and the contact points."""

from __future__ import annotations

import math

from sandbox.geometry.sat_rows import SatRow, Vec
from sandbox.render.number_text import metres
from sandbox.window.sat.pen import Anchor
from sandbox.window.sat.sheet import Sheet, middle_of

SHORTEST_ARROW, TOO_SHORT = 30.0, 9.0
"""A way out is drawn as long as the first, and says so, where it has fewer pixels than the second."""
MUCH = 1000.0
"""From so many times as long on, how many says nothing."""


class OutcomeDrawing(Sheet):
    """Draws the outcome."""

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
        much = "not drawn to scale" if stretch > MUCH else f"drawn {stretch:.3g} times as long"
        words = metres(depth) if stretch <= 1.0 else f"{metres(depth)}, {much}"
        at, anchor = self._beside(end, unit, words)
        self.pen.label(at, words, self.colors.mtv, anchor, bold=True)

    def _beside(self, end: Vec, unit: Vec, words: str) -> tuple[Vec, Anchor]:
        """A place for words at the head of an arrow, on which they are not to lie."""
        sides: tuple[Anchor, Anchor] = ("left", "right") if unit[0] > 0.0 else ("right", "left")
        places: list[tuple[Vec, Anchor]] = [
            (self.pen.away(end, unit, 16.0), "middle"),
            (self.pen.away(end, unit, 12.0), sides[0]),
            (self.pen.away(end, (0.0, 1.0), 20.0), sides[1]),
        ]
        fitting = [place for place in places if self.pen.fits(place[0], words, place[1])] or places
        return next((place for place in fitting if self.pen.is_free(place[0], words, place[1])), fitting[0])

    def _arrow_start(self) -> Vec:
        """The middle of b, or, where that is out of sight, of the contact."""
        contact = self.seen.table.contact
        assert contact is not None
        middle = middle_of(self.seen.b.vertices)
        left, bottom, right, top = self.camera.bounds
        if left < middle[0] < right and bottom < middle[1] < top:
            return middle
        return middle_of(contact.points)

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


def _between(p: Vec, q: Vec) -> Vec:
    return (p[0] + q[0]) / 2, (p[1] + q[1]) / 2
