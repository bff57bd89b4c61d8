"""Rows of the shape, vertex, outline and seam tables for many bodies at once, and what their shapes weigh."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import dataclass, fields
from functools import lru_cache
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from sandbox.geometry.mass import edge_normals
from sandbox.scene.flat import FlatBody, FlatShape, Vec
from sandbox.tables import Floats, Integers, Records, joined, plain
from sandbox.world import records
from sandbox.world.body_prototypes import build_prototypes
from sandbox.world.flush import join_parts
from sandbox.world.moments import Columns, Cores, core_moments, half_widths, sums
from sandbox.world.runs import owners, run_starts, runs

_KINDS = {
    "circle": records.CIRCLE, "box": records.BOX, "capsule": records.CAPSULE,
    "segment": records.SEGMENT, "polygon": records.POLYGON,
}  # fmt: skip
_SAME = (
    "radius", *records.SURFACE, "category", "mask", "group", "sensor", "part",
)  # fmt: skip


Rows: TypeAlias = NDArray[Any]
"""Rows of a table as a plain array."""


def first_shape(shapes: Records, body: int) -> int:
    """The row of the first shape of a body, or where it would be. `np.searchsorted` copies the column."""
    return bisect_left(plain(shapes)["body"], body)


@dataclass(frozen=True)
class Patterns:
    """What some bodies come to, wherever they are: a row of the body table for each, with mass, inertia, centre and
    extent, and the rows of their shapes, body after body. `counts` are the shapes of each, `seam_counts` the seam rows
    of each shape."""

    bodies: Rows
    counts: Integers
    shapes: Rows
    vertices: Rows
    outlines: Rows
    seams: Rows
    seam_counts: Integers

    def placed(self, of_body: Integers) -> tuple[Rows, Rows, Rows, Rows]:
        """The tables of shapes, vertices, outlines and seams of bodies with the patterns of those numbers."""
        if len(of_body) == len(self.bodies) == 1:
            return self.shapes.copy(), self.vertices, self.outlines, self.seams
        counts = self.counts[of_body]
        rows = runs(run_starts(self.counts)[of_body], counts)
        shapes, seam_counts = self.shapes.take(rows), self.seam_counts[rows]
        parts = []
        for table, start, each in (
            (self.vertices, "vertex_start", shapes["vertex_count"]),
            (self.outlines, "outline_start", shapes["outline_count"]),
            (self.seams, "seam_start", seam_counts),
        ):
            parts.append(table.take(runs(shapes[start], each)))
            shapes[start] = run_starts(each)
        shapes["body"] = owners(counts)
        return shapes, parts[0], parts[1], parts[2]

    def one(self, number: int) -> Patterns:
        """One of them by itself."""
        chosen = np.array([number])
        return Patterns(self.bodies[chosen], self.counts[chosen], *self.placed(chosen), self._seam_counts(number))

    def _seam_counts(self, number: int) -> Integers:
        first = int(self.counts[:number].sum())
        return self.seam_counts[first : first + int(self.counts[number])]

    @classmethod
    def joined(cls, parts: Sequence[Patterns]) -> Patterns:
        """Some of them, one after the other; each of `parts` is one."""
        if len(parts) == 1:
            return parts[0]
        whole = cls(*(joined([getattr(each, field.name) for each in parts]) for field in fields(cls)))
        shapes, counts = whole.shapes, whole.counts
        shapes["body"] = owners(counts)
        shapes["vertex_start"], shapes["outline_start"] = map(
            run_starts, (shapes["vertex_count"], shapes["outline_count"])
        )
        shapes["seam_start"] = run_starts(whole.seam_counts)
        return whole


def build_patterns(bodies: Sequence[FlatBody]) -> Patterns:
    """The patterns of `bodies`, one for each."""
    shapes = [shape for body in bodies for shape in body.shapes]
    counts = np.array([len(body.shapes) for body in bodies], np.int64)
    owner = owners(counts)
    cores = _cores(shapes)
    rows = _shape_rows(shapes, cores)
    rows.body = owner
    vertices = records.VERTEX.zeros(len(cores.x))
    vertices.x, vertices.y, vertices.normal_x, vertices.normal_y = cores.x, cores.y, cores.normal_x, cores.normal_y
    # Before centres of mass are known, on which nothing of it depends: other densities leave it as it is.
    joined = join_parts(np.array([body.type != "static" for body in bodies], np.bool_), rows, vertices)
    mass, inertia, center_x, center_y = _masses(rows, cores, owner, [body.center for body in bodies])
    of_vertex = np.repeat(owner, cores.counts)
    vertices.x, vertices.y = cores.x - center_x[of_vertex], cores.y - center_y[of_vertex]
    outlines = _outlines(rows, shapes, center_x[owner], center_y[owner])
    seams, seam_counts = _seams(rows, shapes, joined)
    prototypes = build_prototypes(bodies, (mass, inertia, center_x, center_y))
    prototypes["extent"] = _extents(rows, vertices, owner, len(bodies))
    return Patterns(
        prototypes, counts, plain(rows), plain(vertices), plain(outlines), plain(seams), seam_counts
    )  # fmt: skip


def _cores(shapes: Sequence[FlatShape]) -> Cores:
    counts = np.array([len(shape.vertices) for shape in shapes], np.int64)
    corners = np.array([vertex for shape in shapes for vertex in shape.vertices], float).reshape(-1, 2)
    return Cores.of(counts, corners[:, 0].copy(), corners[:, 1].copy(), _column(shapes, "radius", float))


def _column(items: Sequence[Any], name: str, kind: type) -> Any:
    return np.array([getattr(item, name) for item in items], kind)


def _shape_rows(shapes: Sequence[FlatShape], cores: Cores) -> Records:
    rows = records.SHAPE.zeros(len(shapes))
    rows.kind = [_KINDS[shape.kind] for shape in shapes]
    rows.vertex_start, rows.vertex_count = run_starts(cores.counts), cores.counts
    for name in _SAME:
        rows[name] = _column(shapes, name, rows[name].dtype.type)
    rows.thin = half_widths(cores) + cores.radius
    one_way = np.array([shape.one_way for shape in shapes], float).reshape(-1, 2)
    rows.one_way_x, rows.one_way_y = one_way.T
    rows.traits = np.where((one_way != 0.0).any(axis=1), records.ONE_WAY, 0)
    return rows


def _masses(rows: Records, cores: Cores, owner: Integers, centers: Sequence[Vec | None]) -> Columns:
    """Mass, inertia and centre of mass of each body; sensors weigh nothing."""
    density = np.where(rows.sensor == 0, rows.density, 0.0)
    count = len(centers)
    mass, first_x, first_y, second = (sums(density * each, owner, count) for each in core_moments(cores))
    heavy = mass > 0.0
    divisor = np.where(heavy, mass, 1.0)
    x, y = np.where(heavy, first_x / divisor, 0.0), np.where(heavy, first_y / divisor, 0.0)
    given = [k for k, center in enumerate(centers) if center is not None]
    for k in given:
        x[k], y[k] = centers[k]  # type: ignore[misc]
    shift = x * (x * mass - 2.0 * first_x) + y * (y * mass - 2.0 * first_y)
    return mass, second + shift, x, y


def _extents(rows: Records, vertices: Records, owner: Integers, count: int) -> Floats:
    """How far each body reaches from its centre of mass; its sensors do not count, unless it has nothing else."""
    has_solid = np.zeros(count, np.bool_)
    has_solid[owner[rows.sensor == 0]] = True
    reach = np.sqrt(vertices.x * vertices.x + vertices.y * vertices.y) + np.repeat(rows.radius, rows.vertex_count)
    counts = np.repeat((rows.sensor == 0) | ~has_solid[owner], rows.vertex_count)
    extent = np.zeros(count)
    np.maximum.at(extent, np.repeat(owner, rows.vertex_count)[counts], reach[counts])
    return extent


def _outlines(rows: Records, shapes: Sequence[FlatShape], center_x: Floats, center_y: Floats) -> Records:
    """Rows of the outline table for concave polygons; notes in the shape rows where each begins."""
    sides: list[tuple[float, float, float, float]] = []
    for k in np.flatnonzero(rows.part == 1).tolist():
        middle_x, middle_y = float(center_x[k]), float(center_y[k])
        before = len(sides)
        for ring in shapes[k].outline:
            moved = [(x - middle_x, y - middle_y) for x, y in ring]
            sides += [(*a, *b) for a, b in zip(moved, [*moved[1:], moved[0]], strict=True)]
        rows.outline_count[k] = len(sides) - before
    rows.outline_start = run_starts(rows.outline_count)
    table = records.OUTLINE.zeros(len(sides))
    table[:] = sides
    return table


def _seams(rows: Records, shapes: Sequence[FlatShape], joined: Records) -> tuple[Records, Integers]:
    """Rows of the seam table for parts of concave polygons and chains and for shapes that are `joined` in their body,
    and how many each shape has."""
    seams: list[tuple[float, ...]] = []
    counts = np.zeros(len(shapes), np.int64)
    abutting = np.flatnonzero(rows.traits & records.SEAMED)
    starts = dict(zip(abutting.tolist(), rows.seam_start[abutting].tolist(), strict=True))
    for k, shape in enumerate(shapes):
        if shape.outline:
            normals = _corner_normals(shape.outline)
            seams += [(*normals[v], *shown) for v, shown in zip(shape.vertices, shape.shown, strict=True)]
        elif shape.seam:
            seams += shape.seam
        elif k in starts:
            seams += joined[starts[k] : starts[k] + len(shape.vertices)].tolist()
        else:
            continue
        counts[k] = len(shape.vertices)
        rows.traits[k] |= records.SEAMED
    rows.seam_start = run_starts(counts)
    table = records.SEAM.zeros(len(seams))
    table[:] = seams
    return table, counts


@lru_cache(maxsize=1)
def _corner_normals(outline: tuple[tuple[Vec, ...], ...]) -> dict[Vec, tuple[float, ...]]:
    """The normals of both sides that meet in a corner of a polygon: x, y of the one before, x, y of the one after."""
    found: dict[Vec, tuple[float, ...]] = {}
    for ring in outline:
        normals = edge_normals(ring)
        found.update({vertex: (*normals[k - 1], *normals[k]) for k, vertex in enumerate(ring)})
    return found
