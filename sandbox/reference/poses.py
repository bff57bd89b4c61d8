"""All shapes of a state at given poses, as NumPy sees them: independent of the step, its bounds and its grid."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from sandbox.reference.pair import Core, Pair
from sandbox.tables import Floats, Integers, Records
from sandbox.world.records import BODY, VERTEX


@dataclass(frozen=True)
class Poses:
    """Bodies as they lie, their shapes, and the cores of the shapes.

    `cores` are turned into world axes but measured from the centre of their body, as everywhere in the engine; they
    have the same bits as the step's own, because both come from the same products and sums.
    """

    bodies: Records
    shapes: Records
    cores: Records

    @classmethod
    def of(cls, bodies: Records, shapes: Records, vertices: Records) -> Poses:
        """The poses of `bodies` now; later changes of `bodies` do not show."""
        kept = BODY.zeros(len(bodies))
        kept[:] = bodies
        owner = np.repeat(shapes.body, shapes.vertex_count)
        c, s = kept.rotation_cos[owner], kept.rotation_sin[owner]
        cores = VERTEX.zeros(len(vertices))
        cores.x, cores.y = c * vertices.x - s * vertices.y, s * vertices.x + c * vertices.y
        cores.normal_x = c * vertices.normal_x - s * vertices.normal_y
        cores.normal_y = s * vertices.normal_x + c * vertices.normal_y
        return cls(kept, shapes, cores)

    @cached_property
    def centers(self) -> Floats:
        """(shapes, 2) m: the centre of each shape's body."""
        owner = self.shapes.body
        return np.stack([self.bodies.center_x[owner], self.bodies.center_y[owner]], axis=1)

    @cached_property
    def boxes(self) -> Floats:
        """(shapes, 4) m: lower x, lower y, upper x, upper y of each shape with its radius and nothing more."""
        start = np.asarray(self.shapes.vertex_start)
        columns: list[Any] = []
        for bound, sign in ((np.minimum, -1.0), (np.maximum, 1.0)):
            for k, name in enumerate(("x", "y")):
                core = bound.reduceat(self.cores[name], start) if len(start) else np.zeros(0)
                columns.append(self.centers[:, k] + core + sign * self.shapes.radius)
        return np.stack(columns, axis=1)

    @cached_property
    def _corners(self) -> Integers:
        """(shapes, most vertices): rows of `cores` of each shape; short ones repeat their first."""
        most = int(self.shapes.vertex_count.max(initial=1))
        column = np.arange(most)[None, :]
        rows: Integers = self.shapes.vertex_start[:, None] + np.where(
            column < self.shapes.vertex_count[:, None], column, 0
        )
        return rows

    def overlap_along(self, pairs: Integers, normals: Floats) -> Floats:
        """(pairs,) m: how far b has to go along its unit normal until the axis separates it from a.

        The definition of a projection, for pairs (n, 2) of shapes and normals (n, 2) that point from a to b.
        """
        a, b = pairs[:, 0], pairs[:, 1]
        way = self.centers[b] - self.centers[a]
        top = self._along(a, normals).max(axis=1, initial=-np.inf)
        bottom = self._along(b, normals).min(axis=1, initial=np.inf) + (normals * way).sum(axis=1)
        gap: Floats = bottom - top - self.shapes.radius[a] - self.shapes.radius[b]
        return -gap

    def _along(self, shapes: Integers, normals: Floats) -> Floats:
        rows = self._corners[shapes]
        along: Floats = self.cores.x[rows] * normals[:, :1] + self.cores.y[rows] * normals[:, 1:]
        return along

    def size(self, pairs: Integers) -> Floats:
        """(pairs,) m: extents of both bodies, added."""
        extent = self.bodies.extent[self.shapes.body]
        size: Floats = extent[pairs[:, 0]] + extent[pairs[:, 1]]
        return size

    def reach(self, pairs: Integers) -> Floats:
        """(pairs,) m: the largest coordinate that either shape has in the world, without its sign."""
        far = np.abs(self.boxes).max(axis=1, initial=0.0)
        reach: Floats = np.maximum(far[pairs[:, 0]], far[pairs[:, 1]])
        return reach

    def pair(self, a: int, b: int) -> Pair:
        """The exact shapes of one pair."""
        ca, cb = self.centers[a], self.centers[b]
        return Pair(self._core(a), self._core(b), (float(ca[0]), float(ca[1])), (float(cb[0]), float(cb[1])))

    def _core(self, shape: int) -> Core:
        row = self.shapes[shape]
        rows: Any = self.cores[row.vertex_start : row.vertex_start + row.vertex_count]
        points = tuple((float(x), float(y)) for x, y in zip(rows.x, rows.y, strict=True))
        return Core(points, float(row.radius))
