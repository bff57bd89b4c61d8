"""Draw list -> one instance record a quad: what the shader reads."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from sandbox.render.draw_list import DrawList
from sandbox.render.line import Line
from sandbox.render.strokes import Fills, Strokes

Instances: TypeAlias = NDArray[np.void]

INSTANCE = np.dtype(
    [
        ("origin", "f4", 2),
        ("axis", "f4", 2),
        ("extent", "f4", 4),
        ("fill", "f4", 4),
        ("edge", "f4", 4),
        ("mark", "f4", 4),
        ("detail", "f4", 4),
    ]
)
"""Fields and their order as in `shapes.vert.glsl`."""

TRIM_PIXELS = 20_000.0
"""Longer boxes are cut off screen, because 32-bit floats are too coarse for their far ends."""


def pack(picture: DrawList) -> Instances:
    """All quads of a picture from back to front."""
    below, shapes, above = len(picture.below), len(picture.shapes.index), len(picture.above)
    out = np.zeros(below + shapes + above, INSTANCE)
    _strokes(out[:below], picture.below)
    _shapes(out[below : below + shapes], picture)
    _strokes(out[below + shapes :], picture.above)
    return out


def _strokes(out: Instances, lines: Sequence[Line]) -> None:
    """Strokes are capsules: a core as long as the line, and half the width around it."""
    for row, line in zip(out, lines, strict=True):
        dx, dy = line.end[0] - line.start[0], line.end[1] - line.start[1]
        length = float(np.hypot(dx, dy))
        row["origin"] = (line.start[0] + line.end[0]) / 2, (line.start[1] + line.end[1]) / 2
        row["axis"] = (dx / length, dy / length) if length > 0.0 else (1.0, 0.0)
        row["extent"] = length / 2, 0.0, line.width / 2, 0.0
        row["fill"] = *line.color, line.opacity


def pack_strokes(strokes: Strokes) -> Instances:
    """The quads of the strokes of an overlay."""
    out = np.zeros(len(strokes), INSTANCE)
    way = strokes.end - strokes.start
    length = np.hypot(way[:, 0], way[:, 1])
    out["origin"] = (strokes.start + strokes.end) / 2
    out["axis"] = np.where((length > 0.0)[:, None], way / np.maximum(length, 1e-300)[:, None], (1.0, 0.0))
    out["extent"][:, 0], out["extent"][:, 2] = length / 2, strokes.width / 2
    out["fill"][:, :3], out["fill"][:, 3] = strokes.color, strokes.opacity
    return out


def triangles_of(fills: Fills) -> Any:
    """Convex polygons as fans (t, 6): x, y in pixels, sRGB, opacity."""
    points = fills.points
    first = np.broadcast_to(points[:, :1], points[:, 2:].shape)
    fan = np.stack([first, points[:, 1:-1], points[:, 2:]], axis=2).reshape(-1, 2)
    each = 3 * (points.shape[1] - 2)
    paint = np.column_stack([fills.color, fills.opacity])
    return np.hstack([fan, np.repeat(paint, each, axis=0)])


def _shapes(out: Instances, picture: DrawList) -> None:
    items, mesh, scale = picture.shapes, picture.mesh, picture.camera.scale
    origin, half, trimmed = _trim(picture)
    out["origin"], out["axis"] = origin, items.axis
    out["extent"][:, :2] = half
    out["extent"][:, 2] = mesh.radius[items.index] * scale + items.grow
    out["extent"][:, 3] = items.line
    out["fill"][:, :3], out["fill"][:, 3] = items.fill, items.opacity
    out["edge"][:, :3], out["edge"][:, 3] = items.edge, items.hatched
    out["mark"][:, :3], out["mark"][:, 3] = items.mark, np.where(trimmed, 0.0, items.mark_opacity)
    out["detail"][:, :2] = mesh.mark.take(items.index, axis=0) * scale
    out["detail"][:, 2], out["detail"][:, 3] = mesh.start[items.index], mesh.count[items.index]


def _trim(picture: DrawList) -> tuple[Any, Any, Any]:
    """Origins and half extents in pixels, with the far ends of huge boxes moved to a little off screen."""
    items, mesh, camera = picture.shapes, picture.mesh, picture.camera
    half = mesh.half.take(items.index, axis=0) * camera.scale
    huge = (half.max(axis=1, initial=0.0) > TRIM_PIXELS) & (mesh.count[items.index] == 0)
    if not huge.any():
        return items.origin, half, huge
    origin, half = items.origin.copy(), half.copy()
    a, b = items.axis[huge, 0], items.axis[huge, 1]
    to = np.asarray(camera.size) / 2 - origin[huge]
    seen = np.column_stack([to[:, 0] * a + to[:, 1] * b, to[:, 0] * b - to[:, 1] * a])
    low = np.clip(seen - TRIM_PIXELS / 2, -half[huge], half[huge])
    high = np.clip(seen + TRIM_PIXELS / 2, -half[huge], half[huge])
    middle = (low + high) / 2
    origin[huge] += np.column_stack([a * middle[:, 0] + b * middle[:, 1], b * middle[:, 0] - a * middle[:, 1]])
    half[huge] = (high - low) / 2
    return origin, half, huge
