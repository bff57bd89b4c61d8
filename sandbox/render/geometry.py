"""The drawing mesh: what the shapes look like in their own frames. Built once, and anew when bodies come or
go; frames only move it.

Each shape has a *shape frame* fixed in its body, in which it is symmetric where it can be: circles, boxes,
capsules and segments are all rounded boxes there (half extents plus a radius), and only polygons need their
vertices; the half extents of a polygon are those of a box about the shape frame's origin that holds it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.render.camera import Floats
from sandbox.render.outline import Outline, half_width, read_outline
from sandbox.tables import Records
from sandbox.world.records import BOX, CAPSULE, CIRCLE, POLYGON, SEGMENT

Ints = NDArray[np.int64]


@dataclass(frozen=True)
class Mesh:
    """All shapes of a world as one sees them; one row a shape, metres. The parts of a concave polygon are one row.

    `body` index (m,); `kind` (m,); `offset` (m, 2) origin and `axis` (m, 2) x axis (cos, sin) of the shape
    frame in the body's frame; `half` (m, 2) half extents of the core; `radius` (m,) rounding. Polygon `i` has
    the core `points[start[i]:start[i] + count[i]]` (p, 2) in its shape frame; `count` is 0 for other kinds. Where it
    is negative, the row is the concave polygon `outlines[i]`, and from `start[i]` on there are the two ends of each of
    `-count[i]` sides. `thickness` (m,) is half the smallest width, rounding included; `sensor` (m,). `layout` is that
    of the state it was built for: once it differs, rows have moved.
    """

    body: Ints
    kind: Ints
    offset: Floats
    axis: Floats
    half: Floats
    radius: Floats
    start: Ints
    count: Ints
    points: Floats
    thickness: Floats
    outlines: Mapping[int, Outline]
    sensor: NDArray[np.bool_]
    layout: int = 0

    @cached_property
    def reach(self) -> Floats:
        """Radius of a circle about the shape frame's origin that holds the shape (m,)."""
        return np.hypot(self.half[:, 0], self.half[:, 1]) + self.radius

    @cached_property
    def mark(self) -> Floats:
        """The orientation mark: where it starts and ends on the shape frame's x axis (m, 2)."""
        thick, end = self.thickness, self.half[:, 0] + self.radius
        edge = np.column_stack([end - 0.55 * thick, end - 0.25 * thick])
        middle = np.column_stack([np.zeros(len(thick)), 0.45 * thick])
        spoke = np.column_stack([np.zeros(len(thick)), 0.999 * end])
        circle = (self.kind == CIRCLE)[:, None]
        return np.where(circle, spoke, np.where((self.count != 0)[:, None], middle, edge))

    def core(self, shape: int) -> Floats:
        """Core vertices of one convex shape in its frame, counter-clockwise: 1, 2, 4 or n rows."""
        if self.count[shape]:
            return self.points[self.start[shape] : self.start[shape] + self.count[shape]]
        x, y = self.half[shape]
        if x == 0.0 and y == 0.0:
            return np.zeros((1, 2))
        if y == 0.0:
            return np.array([[-x, 0.0], [x, 0.0]])
        return np.array([[-x, -y], [x, -y], [x, y], [-x, y]])


def build_mesh(shapes: Records, vertices: Records, outlines: Records, layout: int = 0) -> Mesh:
    """The mesh of a world's shape, vertex and outline records. Parts of a concave polygon are one row of it."""
    further = (np.asarray(shapes.part) > 1) & (np.asarray(shapes.kind) == POLYGON)
    seen = np.flatnonzero(~further)
    outlined = np.asarray(shapes.outline_count)[seen] > 0
    concave = {k: read_outline(shapes, vertices, outlines, int(seen[k])) for k in np.flatnonzero(outlined).tolist()}
    drawn: Any = shapes[seen]
    mesh = replace(_convex_mesh(drawn, vertices), layout=layout)
    return _with_outlines(mesh, concave) if concave else mesh


def _convex_mesh(shapes: Records, vertices: Records) -> Mesh:
    count = np.asarray(shapes.vertex_count)
    rows, first = gather(np.asarray(shapes.vertex_start), count)
    owner = np.repeat(np.arange(len(shapes)), count)
    axis = _axes(shapes, vertices)
    turned = _turn_back(np.column_stack([vertices.x[rows], vertices.y[rows]]), axis[owner])
    low, high = _extremes(turned, first)
    middle, half = (low + high) / 2, (high - low) / 2
    polygon = ~_is_rounded_box(shapes)
    for i in np.flatnonzero(polygon):
        # The mean of the corners, unlike the middle of the box around them, always lies inside.
        middle[i] = turned[first[i] : first[i] + count[i]].mean(axis=0)
        half[i] = np.maximum(high[i] - middle[i], middle[i] - low[i])
    half[np.asarray(shapes.kind) == SEGMENT, 1] = 0.0
    half[np.asarray(shapes.kind) == CAPSULE, 1] = 0.0
    core = (turned - middle[owner])[polygon[owner]]
    counts = np.where(polygon, count, 0)
    starts = np.concatenate([[0], np.cumsum(counts)])[:-1].astype(np.int64)
    return Mesh(
        np.array(shapes.body), np.array(shapes.kind), _turn(middle, axis), axis, half,
        np.array(shapes.radius), starts, counts, core, _thickness(half, core, starts, counts) + shapes.radius, {},
        np.array(shapes.sensor) == 1,
    )  # fmt: skip


def _with_outlines(mesh: Mesh, concave: Mapping[int, Outline]) -> Mesh:
    """The mesh with some rows made concave polygons; their sides come after all other points."""
    points = [mesh.points]
    end = len(mesh.points)
    for i, outline in concave.items():
        mesh.offset[i] = outline.middle
        sides = outline.centred().sides.reshape(-1, 2)
        mesh.half[i] = np.abs(sides).max(axis=0)
        mesh.thickness[i] = outline.thickness
        mesh.start[i], mesh.count[i] = end, -(len(sides) // 2)
        points.append(sides)
        end += len(sides)
    centred = {i: outline.centred() for i, outline in concave.items()}
    return replace(mesh, points=np.vstack(points), outlines=centred)


def _thickness(half: Floats, points: Floats, start: Ints, count: Ints) -> Floats:
    thickness: Floats = half.min(axis=1)
    for i in np.flatnonzero(count):
        thickness[i] = half_width(points[start[i] : start[i] + count[i]])
    return thickness


def _is_rounded_box(shapes: Records) -> Any:
    kind, count = np.asarray(shapes.kind), np.asarray(shapes.vertex_count)
    two = ((kind == CAPSULE) | (kind == SEGMENT)) & (count == 2)
    return (kind == CIRCLE) & (count == 1) | (kind == BOX) & (count == 4) | two


def gather(start: Ints, count: Ints) -> tuple[Ints, Ints]:
    """Rows of all runs `start[i] : start[i] + count[i]` in one array, and where each run begins."""
    first = np.concatenate([[0], np.cumsum(count)])[:-1].astype(np.int64)
    return np.repeat(start - first, count) + np.arange(int(count.sum())), first


def _axes(shapes: Records, vertices: Records) -> Floats:
    """The x axis of each shape frame: the first edge for what has a direction, else the body's own x axis."""
    axis = np.tile([1.0, 0.0], (len(shapes), 1))
    for i in np.flatnonzero(_is_rounded_box(shapes) & (shapes.vertex_count > 1)):
        a, b = vertices[shapes.vertex_start[i]], vertices[shapes.vertex_start[i] + 1]
        length = float(np.hypot(b.x - a.x, b.y - a.y))
        if length > 0.0:
            axis[i] = (b.x - a.x) / length, (b.y - a.y) / length
    return axis


def _extremes(points: Floats, first: Ints) -> tuple[Floats, Floats]:
    if len(points) == 0:
        return np.zeros((0, 2)), np.zeros((0, 2))
    return np.minimum.reduceat(points, first), np.maximum.reduceat(points, first)


def _turn(points: Floats, axis: Floats) -> Floats:
    x, y, c, s = points[:, 0], points[:, 1], axis[:, 0], axis[:, 1]
    return np.column_stack([c * x - s * y, s * x + c * y])


def _turn_back(points: Floats, axis: Floats) -> Floats:
    return _turn(points, axis * (1.0, -1.0))
