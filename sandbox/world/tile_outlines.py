"""The outlines of tiles, one after the other, and how far points lie outside of them.

A line, which has two vertices, has the outline of its straight sides: a box, of no height if it has no radius. What its
round ends fill beyond that does not count.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from sandbox.tables import Floats, Integers, Records, plain
from sandbox.world.runs import neighbours_in_rings, run_starts, runs

Corners: TypeAlias = Integers
"""Numbers of corners: rows of `Outlines`. The edge of that number runs from there to the next corner."""
Tiles: TypeAlias = Integers
"""Numbers of tiles, in the order of their shapes."""


@dataclass(frozen=True)
class Outlines:
    """All corners of the tiles (m) and the unit normals of the edges that begin there, in world axes.

    `shapes` are the rows of the tiles, `wholes` the numbers of what they are parts of, `vertices` how many each core
    has, `starts` and `counts` the corners of each; `before` and `after` are the corners next to each on its tile.
    """

    shapes: Integers
    wholes: Integers
    vertices: Integers
    starts: Integers
    counts: Integers
    x: Floats
    y: Floats
    normal_x: Floats
    normal_y: Floats
    before: Corners
    after: Corners

    @classmethod
    def of(
        cls, bodies: Records, shapes: Records, vertices: Records, tiles: Integers, wholes: Integers | None = None
    ) -> Outlines:
        """Those of the shapes in the rows `tiles`; all are parts of one whole unless `wholes` says otherwise."""
        owner, of_core = _columns(shapes, tiles, "body", "vertex_count")
        counts = np.where(of_core == 2, 4, of_core)
        x, y, normal_x, normal_y = _rings(shapes, vertices, tiles, counts)
        pose = "center_x", "center_y", "rotation_cos", "rotation_sin"
        center_x, center_y, cos, sin = _columns(bodies, np.repeat(owner, counts), *pose)
        # No matrix product: what that rounds differs from machine to machine.
        return cls(
            tiles,
            np.zeros(len(tiles), np.int64) if wholes is None else wholes,
            of_core,
            run_starts(counts),
            counts,
            center_x + (cos * x - sin * y),
            center_y + (sin * x + cos * y),
            cos * normal_x - sin * normal_y,
            sin * normal_x + cos * normal_y,
            *neighbours_in_rings(counts),
        )

    def with_others(self, others: Outlines) -> Outlines:
        """These tiles, and behind them others, which may be of other tables."""
        more = len(self.x)
        shift = {"starts": more, "before": more, "after": more}
        pairs = ((each.name, getattr(self, each.name), getattr(others, each.name)) for each in fields(self))
        return Outlines(*(np.concatenate([own, other + shift.get(name, 0)]) for name, own, other in pairs))

    def corners(self, tiles: Tiles) -> Corners:
        """All corners of some tiles, tile after tile."""
        return runs(self.starts[tiles], self.counts[tiles])

    def normals(self, edges: Corners) -> tuple[Floats, Floats]:
        """Normals of edges; zeros for -1."""
        side = edges >= 0
        return np.where(side, self.normal_x[edges], 0.0), np.where(side, self.normal_y[edges], 0.0)

    def bend(self, before: Corners, after: Corners) -> Floats:
        """Sine of the angle from the normal of one edge to that of another; positive where they make a corner that juts
        out."""
        (x, y), (other_x, other_y) = self.normals(before), self.normals(after)
        return x * other_y - y * other_x

    @cached_property
    def _lines(self) -> Floats:
        """Corner and normal of each edge in one row, which is read at once."""
        return np.stack([self.x, self.y, self.normal_x, self.normal_y], axis=1)

    @cached_property
    def lengths(self) -> Floats:
        """Length of each edge, m; 0 at the ends of lines without a radius."""
        across, up = self.x[self.after] - self.x, self.y[self.after] - self.y
        length: Floats = np.sqrt(across * across + up * up)
        return length

    @cached_property
    def flat(self) -> NDArray[np.bool_]:
        """Which tiles are lines without a radius."""
        flat: NDArray[np.bool_] = (self.vertices == 2) & (self.lengths[self.starts + 1] == 0.0)
        return flat

    def height(self, x: Floats, y: Floats, edges: Corners) -> Floats:
        """How far each point (m) is outside of the line of an edge."""
        lines = self._lines.take(edges, axis=0)
        height: Floats = (x - lines[:, 0]) * lines[:, 2] + (y - lines[:, 1]) * lines[:, 3]
        return height

    def within(self, x: Floats, y: Floats, tiles: Tiles, reach: float) -> tuple[NDArray[np.intp], Floats]:
        """Which points are outside of their tile by `reach` metres at most, and how far these are (within: negative).

        It is the distance to the line of the edge that is farthest below the point.
        """
        rows, height = np.arange(len(tiles)), np.full(len(tiles), -np.inf)
        starts, lasts = self.starts[tiles], self.counts[tiles] - 1
        for k in range(int(lasts.max(initial=-1)) + 1):
            edges = starts + np.minimum(k, lasts)  # a tile with fewer edges is asked for its last one again
            height = np.maximum(height, self.height(x, y, edges))
            rows, height, x, y, starts, lasts = kept(height <= reach, rows, height, x, y, starts, lasts)
        return rows, height


def _columns(table: Any, rows: Integers, *names: str) -> list[NDArray[Any]]:
    """Some columns of some rows of a table."""
    table = plain(table)
    return [table[name][rows] for name in names]


def kept(which: NDArray[np.bool_], *columns: Any) -> tuple[Any, ...]:
    """The chosen rows of some columns; `take` is several times as fast here as an index of flags."""
    rows = np.flatnonzero(which)
    return columns if len(rows) == len(which) else tuple(column.take(rows) for column in columns)


def _rings(shapes: Records, vertices: Records, tiles: Integers, counts: Integers) -> tuple[Floats, ...]:
    """Corners (m) and normals of tiles with so many of them each, in the frames of their bodies.

    A line begins where its edge to the right does; the edges 1 and 3 run across its ends.
    """
    of_core, start, radii = _columns(shapes, tiles, "vertex_count", "vertex_start", "radius")
    if not (of_core == 2).any():
        return tuple(_columns(vertices, runs(start, counts), "x", "y", "normal_x", "normal_y"))
    number = runs(np.zeros(len(tiles), np.int64), counts)
    of_line = np.repeat(of_core == 2, counts)
    first = np.repeat(start, counts)
    rows = first + np.where(of_line, (number + 1) // 2 % 2, number)
    faces = first + np.where(of_line, number // 2, number)
    radius = np.where(of_line, np.repeat(radii, counts), 0.0)
    across = of_line & (number % 2 == 1)
    out_x, out_y = _columns(vertices, faces, "normal_x", "normal_y")
    x, y = _columns(vertices, rows, "x", "y")
    x, y = x + radius * out_x, y + radius * out_y
    return x, y, np.where(across, -out_y, out_x), np.where(across, out_x, out_y)
