"""Draw list -> runs of instance records, one a quad: what the shaders read."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise
from operator import itemgetter
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from sandbox.render.draw_list import SHADOW_DROP, SHADOW_SOFT, DrawList
from sandbox.render.line import Line
from sandbox.render.materials.textures import NONE, UNITS
from sandbox.render.strokes import Fills, Strokes, strokes

Instances: TypeAlias = NDArray[np.void]

INSTANCE = np.dtype(
    [
        ("origin", "f4", 2),
        ("axis", "f4", 2),
        ("extent", "f4", 4),
        ("detail", "f4", 4),
        ("paints", "u1", (3, 4)),
        ("grain", "f4", 4),
    ]
)
"""Fields and their order as in `shapes.vert.glsl`; `paints` are fill, edge and mark."""
FILL, EDGE, MARK = 0, 1, 2

TRIM_PIXELS = 20_000.0
"""Longer boxes are cut off screen, because 32-bit floats are too coarse for their far ends."""


MOST_PARTS = 16
"""Calls that the quads of one layer are drawn in at most."""


class Kind(NamedTuple):
    """What a shader has to do for quads, which takes time also where it turns out that there is nothing to do."""

    textured: bool
    outlined: bool
    """Whether some are polygons or other outlines; the others are boxes, circles, capsules and strokes."""


PLAIN = Kind(False, False)


@dataclass(frozen=True)
class Run:
    """Quads that are drawn in one call."""

    kind: Kind
    instances: Instances


def pack(picture: DrawList) -> list[Run]:
    """All quads of a picture from back to front: strokes below, what stands still, shadows, what moves, strokes above.

    Few calls: neighbours of the same kind are joined.
    """
    items, shapes = picture.shapes, pack_shapes(picture)
    textured, moving = (items.texture != NONE), items.moving
    layers: Sequence[tuple[bool, Instances]] = (
        (False, _lines(picture.below)), (False, shapes[~moving & ~textured]), (True, shapes[~moving & textured]),
        (False, _shadows(shapes, picture)), (False, shapes[moving & ~textured]), (True, shapes[moving & textured]),
        (False, _lines(picture.above)),
    )  # fmt: skip
    parts = [part for layer in layers for part in _by_outline(*layer)]
    runs = groupby(parts, key=itemgetter(0))
    return [Run(kind, _joined([instances for _, instances in each])) for kind, each in runs]


def _by_outline(textured: bool, layer: Instances) -> Iterator[tuple[Kind, Instances]]:
    """A layer in parts that are outlined or not, in its order; a motley one as a whole."""
    if len(layer) == 0:
        return
    outlined = layer["detail"][:, 3] != 0.0
    cuts = np.flatnonzero(outlined[1:] != outlined[:-1]) + 1
    if len(cuts) >= MOST_PARTS:
        yield Kind(textured, True), layer
        return
    for start, end in pairwise([0, *cuts.tolist(), len(layer)]):
        yield Kind(textured, bool(outlined[start])), layer[start:end]


def _joined(parts: Sequence[Instances]) -> Instances:
    return np.concatenate(parts) if len(parts) > 1 else parts[0]


def _lines(lines: Sequence[Line]) -> Instances:
    """The quads of strokes."""
    rows = [(*line.start, *line.end, line.width, *line.color, line.opacity) for line in lines]
    table = np.array(rows, np.float64).reshape(-1, 9)
    return pack_strokes(strokes(table[:, 0:2], table[:, 2:4], table[:, 4], table[:, 5:8], table[:, 8]))


def pack_strokes(strokes: Strokes) -> Instances:
    """The quads of strokes: capsules, a core as long as the line, and half the width around it."""
    out = np.zeros(len(strokes), INSTANCE)
    way = strokes.end - strokes.start
    length = np.hypot(way[:, 0], way[:, 1])
    out["origin"] = (strokes.start + strokes.end) / 2
    out["axis"] = np.where((length > 0.0)[:, None], way / np.maximum(length, 1e-300)[:, None], (1.0, 0.0))
    out["extent"][:, 0], out["extent"][:, 2] = length / 2, strokes.width / 2
    _paint(out, FILL, strokes.color, strokes.opacity)
    return out


def _paint(out: Instances, which: int, color: Any, alpha: Any) -> None:
    """Write one of the paints, a byte each part."""
    paint = out["paints"][:, which]
    paint[:, :3] = 255.0 * color + 0.5  # colours are in range: what theme and legend mix are shares of colours that are
    paint[:, 3] = 255.0 * alpha + 0.5


def triangles_of(fills: Fills) -> Any:
    """Convex polygons as fans (t, 6): x, y in pixels, sRGB, opacity."""
    points = fills.points
    first = np.broadcast_to(points[:, :1], points[:, 2:].shape)
    fan = np.stack([first, points[:, 1:-1], points[:, 2:]], axis=2).reshape(-1, 2)
    each = 3 * (points.shape[1] - 2)
    paint = np.column_stack([fills.color, fills.opacity])
    return np.hstack([fan, np.repeat(paint, each, axis=0)])


def pack_shapes(picture: DrawList) -> Instances:
    """A quad for each shape, in their order."""
    items, mesh, scale = picture.shapes, picture.mesh, picture.camera.scale
    out = np.zeros(len(items.index), INSTANCE)
    origin, half, trimmed = _trim(picture)
    out["origin"], out["axis"] = origin, items.axis
    out["extent"][:, :2] = half
    out["extent"][:, 2] = mesh.radius[items.index] * scale + items.grow
    out["extent"][:, 3] = items.line
    _paint(out, FILL, items.fill, items.opacity)
    _paint(out, EDGE, items.edge, items.hatched)
    _paint(out, MARK, items.mark, np.where(trimmed, 0.0, items.mark_opacity))
    out["detail"][:, :2] = mesh.mark.take(items.index, axis=0) * scale
    out["detail"][:, 2], out["detail"][:, 3] = mesh.start[items.index], mesh.count[items.index]
    if (items.texture != NONE).any():
        out["grain"] = _grain(picture, origin)
    return out


def _grain(picture: DrawList, origin: Any) -> Any:
    """What the shader needs to know of textures (k, 4): tiles a pixel, or minus that where the shape is higher than
    wide; the number of the texture and, after the point, its strength; where the tile starts.
    """
    items = picture.shapes
    tiles = 1.0 / (UNITS * np.maximum(items.unit, 1e-9))
    moved = origin - items.origin  # what was trimmed keeps its texture in place
    a, b = items.axis.T
    along, up = moved[:, 0] * a + moved[:, 1] * b, moved[:, 0] * b - moved[:, 1] * a
    upright = items.upright
    start = np.where(upright[:, None], np.column_stack([up, along]), np.column_stack([along, up])) * tiles[:, None]
    number = items.texture + 0.99 * items.grain
    return np.column_stack([np.where(upright, -tiles, tiles), number, (items.shift + start) % 1.0])


def _shadows(shapes: Instances, picture: DrawList) -> Instances:
    """The shapes that cast one as soft blots: an outline of negative width tells the shader how soft."""
    cast = np.flatnonzero(picture.shapes.shadow > 0.0)
    if len(cast) == 0:
        return shapes[:0]
    out, theme = shapes[cast], picture.theme
    out["origin"][:, 1] += SHADOW_DROP
    out["extent"][:, 2] += SHADOW_SOFT / 2
    out["extent"][:, 3] = -SHADOW_SOFT
    out["paints"][:, EDGE:] = 0
    _paint(out, FILL, np.array(theme.shadow), theme.shadow_opacity * picture.shapes.shadow[cast])
    return out


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
