"""The painter that needs no display: draw list -> pygame surface, drawn large and scaled down."""

from __future__ import annotations

from typing import Any

import numpy as np
import pygame

from sandbox.render.camera import Floats
from sandbox.render.contour import ContourTable
from sandbox.render.draw_list import DrawList, Line, ShapeItems, stroke_sizes
from sandbox.render.geometry import gather

HATCH_PIXELS = 7.0
"""Distance of the stripes on frozen bodies."""


class SurfacePainter:
    """Draws draw lists. Keeps the contours of the last mesh and scale: a film rarely changes them."""

    def __init__(self, samples: int = 3) -> None:
        """`samples` x `samples` points are averaged for each pixel."""
        self.samples = samples
        self._key: tuple[int, float] | None = None
        self._tables: tuple[ContourTable, ContourTable]

    def paint(self, picture: DrawList) -> Any:
        """Draw the picture; gives a `pygame.Surface` of `picture.camera.size` pixels."""
        width, height = picture.camera.size
        sheet = pygame.Surface((width * self.samples, height * self.samples), depth=24)
        sheet.fill(_rgb(picture.theme.background))
        for line in picture.below:
            self._stroke(sheet, line, picture.theme.background)
        self._shapes(sheet, picture)
        for line in picture.above:
            self._stroke(sheet, line, picture.theme.background)
        return pygame.transform.smoothscale(sheet, (width, height))

    def _stroke(self, sheet: Any, line: Line, background: tuple[float, ...]) -> None:
        points = np.array([line.start, line.end]) * self.samples
        along = points[1] - points[0]
        side = np.array([-along[1], along[0]]) / max(float(np.hypot(*along)), 1e-9)
        side *= max(line.width * self.samples, 1.0) / 2
        corners = [points[0] + side, points[1] + side, points[1] - side, points[0] - side]
        pygame.draw.polygon(sheet, _rgb(_over(line, background)), [tuple(p - 0.5) for p in corners])

    def _shapes(self, sheet: Any, picture: DrawList) -> None:
        items = picture.shapes
        outer, inner = self._contours(picture)
        edges = _placed(outer, items, self.samples)
        fills = _placed(inner, items, self.samples)
        marks = _marks(picture, self.samples)
        fill, edge, mark = _bytes(items.fill), _bytes(items.edge), _bytes(_mark_colors(items))
        for i in range(len(items.index)):
            pygame.draw.polygon(sheet, edge[i], edges[i])
            pygame.draw.polygon(sheet, fill[i], fills[i])
            if items.hatched[i]:
                _hatch(sheet, edge[i], np.array(fills[i]), HATCH_PIXELS * self.samples)
            if items.mark_opacity[i] > 0.0:
                pygame.draw.polygon(sheet, mark[i], marks[i])

    def _contours(self, picture: DrawList) -> tuple[ContourTable, ContourTable]:
        key = (id(picture.mesh), picture.camera.scale)
        if key != self._key:
            scale = picture.camera.scale
            grow, line = stroke_sizes(picture.mesh, scale)
            outer = ContourTable(picture.mesh, scale, grow, np.zeros_like(line))
            self._key, self._tables = key, (outer, ContourTable(picture.mesh, scale, grow, line))
        return self._tables


def rgb_bytes(surface: Any) -> bytes:
    """The pixels of a surface, row by row from the top, three bytes each."""
    return bytes(pygame.image.tobytes(surface, "RGB"))


def _placed(table: ContourTable, items: ShapeItems, samples: int) -> list[Any]:
    """The contour of every visible shape in pixels of the large sheet."""
    count = table.count[items.index]
    rows, first = gather(table.start[items.index], count)
    owner = np.repeat(np.arange(len(count)), count)
    return _runs(_place(table.points[rows], items, owner, samples), first)


def _place(points: Floats, items: ShapeItems, owner: Any, samples: int) -> Floats:
    a, b = items.axis[owner, 0], items.axis[owner, 1]
    u, v = points[:, 0], points[:, 1]
    turned = np.column_stack([a * u + b * v, b * u - a * v])
    placed: Floats = (items.origin[owner] + turned) * samples - 0.5
    return placed


def _runs(points: Floats, first: Any) -> list[Any]:
    values = points.tolist()
    ends = [*first[1:].tolist(), len(values)]
    return [values[a:b] for a, b in zip(first.tolist(), ends, strict=True)]


def _marks(picture: DrawList, samples: int) -> list[Any]:
    """Orientation marks as rectangles along the x axes of the shape frames."""
    items = picture.shapes
    span = picture.mesh.mark[items.index] * picture.camera.scale
    half = np.maximum(items.line, 0.7) * 0.75
    u = np.column_stack([span[:, 0], span[:, 1], span[:, 1], span[:, 0]]).ravel()
    v = np.column_stack([-half, -half, half, half]).ravel()
    owner = np.repeat(np.arange(len(half)), 4)
    return _runs(_place(np.column_stack([u, v]), items, owner, samples), np.arange(len(half)) * 4)


def _mark_colors(items: ShapeItems) -> Floats:
    opacity = items.mark_opacity[:, None]
    return items.fill * (1.0 - opacity) + items.mark * opacity


def _hatch(sheet: Any, color: Any, polygon: Floats, distance: float) -> None:
    """Diagonal stripes across a convex polygon: each stripe is cut where x + y crosses the boundary."""
    level = polygon.sum(axis=1)
    following = np.roll(polygon, -1, axis=0)
    after = following.sum(axis=1)
    for stripe in np.arange(np.ceil(level.min() / distance) * distance, level.max(), distance):
        cut = (level <= stripe) != (after <= stripe)
        part = (stripe - level[cut]) / (after[cut] - level[cut])
        ends = polygon[cut] + (following[cut] - polygon[cut]) * part[:, None]
        if len(ends) == 2:
            pygame.draw.line(sheet, color, ends[0], ends[1], 3)


def _over(line: Line, background: tuple[float, ...]) -> tuple[float, ...]:
    parts = zip(line.color, background, strict=True)
    return tuple(c * line.opacity + b * (1.0 - line.opacity) for c, b in parts)


def _rgb(color: tuple[float, ...]) -> tuple[int, ...]:
    return tuple(round(255 * part) for part in color)


def _bytes(colors: Floats) -> list[Any]:
    values: list[Any] = np.rint(255 * colors).astype(int).tolist()
    return values
