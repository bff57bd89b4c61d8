"""Contours of rounded convex shapes as polygons, for painters that can only fill polygons."""

from __future__ import annotations

import math

import numpy as np

from sandbox.render.camera import Floats, Vec
from sandbox.render.geometry import Ints, Mesh
from sandbox.render.outline import Outline

TOLERANCE_PIXELS, MOST_CHORDS = 0.1, 100_000
"""Largest distance between an arc and the chords that stand for it, and how many chords there can be."""


def contour(core: Floats, radius: float, tolerance: float = TOLERANCE_PIXELS) -> Floats:
    """The boundary (k, 2), counter-clockwise, of all points within `radius` of the convex `core` (n >= 1)."""
    if radius <= 0.0:
        return core
    if len(core) == 1:
        return np.vstack([core[0] + radius * _arc(0.0, 2.0 * math.pi, radius, tolerance)])
    directions = np.roll(core, -1, axis=0) - core
    angles = np.arctan2(-directions[:, 0], directions[:, 1])
    arcs = []
    for i, vertex in enumerate(core):
        turn = (angles[i] - angles[i - 1]) % (2.0 * math.pi)
        arcs.append(vertex + radius * _arc(angles[i - 1], turn, radius, tolerance))
    return np.vstack(arcs)


def _arc(begin: float, turn: float, radius: float, tolerance: float) -> Floats:
    step = 2.0 * math.acos(max(1.0 - tolerance / radius, 0.5))
    chords = min(max(math.ceil(turn / step), 1), MOST_CHORDS)
    angle = begin + np.linspace(0.0, turn, chords + 1)
    return np.column_stack([np.cos(angle), np.sin(angle)])


def inset(core: Floats, distance: float) -> Floats:
    """The convex polygon `core` (n >= 3, counter-clockwise) with every edge moved inwards by `distance`."""
    edge = np.roll(core, -1, axis=0) - core
    normal = np.column_stack([edge[:, 1], -edge[:, 0]]) / np.hypot(edge[:, 0], edge[:, 1])[:, None]
    before = np.roll(normal, 1, axis=0)
    lean = np.maximum(1.0 + (normal * before).sum(axis=1), 0.2)
    moved: Floats = core - distance * (normal + before) / lean[:, None]
    return moved


def shape_contour(core: Floats, radius: float, shrink: float) -> Floats:
    """The contour of a shape moved inwards by `shrink`: the rounding gives way first, then the core."""
    if shrink < radius or len(core) < 3:
        return contour(core, max(radius - shrink, 0.05))
    return inset(core, shrink - radius)


def clip(polygon: Floats, low: Vec, high: Vec) -> Floats:
    """The part of a convex polygon (k, 2) inside a rectangle (Sutherland and Hodgman 1974); maybe no rows."""
    for axis in (0, 1):
        polygon = cut_polygon(polygon, polygon[:, axis] - low[axis])
        polygon = cut_polygon(polygon, high[axis] - polygon[:, axis])
    return polygon


def cut_polygon(polygon: Floats, height: Floats) -> Floats:
    """What of a polygon has `height` (k,) >= 0, where the height varies linearly along the edges."""
    points = []
    for i in range(len(polygon)):
        before, h0, here, h1 = polygon[i - 1], height[i - 1], polygon[i], height[i]
        if (h0 < 0.0) != (h1 < 0.0):
            points.append(before + (here - before) * (h0 / (h0 - h1)))
        if h1 >= 0.0:
            points.append(here)
    return np.array(points).reshape(-1, 2)


class ContourTable:
    """Contours of all shapes of a mesh at one scale, in pixels, one after the other: (k, 2) and runs.

    Those of concave polygons are empty: see `concave_pieces`.
    """

    points: Floats
    start: Ints
    count: Ints

    def __init__(self, mesh: Mesh, scale: float, grow: Floats, shrink: Floats) -> None:
        """`grow` and `shrink` (m,) in pixels: what is added to the radius, how far the boundary moves in."""
        cache: dict[tuple[bytes, float, float], Floats] = {}
        runs = []
        for i in range(len(mesh.body)):
            if i in mesh.outlines:
                runs.append(np.zeros((0, 2)))
                continue
            core, radius = mesh.core(i) * scale, float(mesh.radius[i] * scale + grow[i])
            key = (core.tobytes(), radius, float(shrink[i]))
            if key not in cache:
                cache[key] = shape_contour(core, radius, float(shrink[i]))
            runs.append(cache[key])
        self.points = np.vstack(runs) if runs else np.zeros((0, 2))
        self.count = np.array([len(run) for run in runs], dtype=np.int64)
        self.start = np.cumsum(self.count) - self.count


def concave_pieces(outline: Outline, scale: float, grow: float, line: float) -> tuple[list[Floats], list[Floats]]:
    """A concave polygon as convex polygons in pixels: what to fill, and then its outline, `line` pixels wide."""
    parts = [contour(part * scale, grow) for part in outline.parts]
    return parts, [strip * scale for strip in outline.strips(line / scale)]
