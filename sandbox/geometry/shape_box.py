"""The box around a shape, and how far two boxes are apart."""

from __future__ import annotations

from math import hypot

from sandbox.geometry.shape import Shape

Box = tuple[float, float, float, float]
"""Left, bottom, right, top in metres."""


def box_of(shape: Shape) -> Box:
    """Left, bottom, right and top of a shape (m)."""
    xs, ys, r = [x for x, _ in shape.vertices], [y for _, y in shape.vertices], shape.radius
    return min(xs) - r, min(ys) - r, max(xs) + r, max(ys) + r


def box_gap(p: Box, q: Box) -> float:
    """How far two boxes are apart (m); 0 where they overlap."""
    return hypot(max(p[0] - q[2], q[0] - p[2], 0.0), max(p[1] - q[3], q[1] - p[3], 0.0))
