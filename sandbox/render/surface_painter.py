"""The painter that needs no display: draw list -> image, drawn large on a pygame surface and averaged down."""

from __future__ import annotations

from typing import Any

import numpy as np
import pygame
import pygame.gfxdraw
from PIL import Image

from sandbox.render.camera import Floats
from sandbox.render.contour import ContourTable, clip, concave_pieces
from sandbox.render.draw_list import DrawList, ShapeItems, hollow_lines, stroke_sizes
from sandbox.render.field_drawing import RegionFill
from sandbox.render.geometry import Mesh, gather
from sandbox.render.line import Line
from sandbox.render.materials.textures import NONE
from sandbox.render.surface_finish import paint_shadows, paint_textures
from sandbox.render.surface_marks import paint_labels, paint_marks

HATCH_PIXELS = 7.0
"""Distance of the stripes on frozen bodies."""


class SurfacePainter:
    """Draws draw lists. Keeps the contours of the last mesh and scale: a film rarely changes them."""

    def __init__(self, samples: int = 3) -> None:
        """`samples` x `samples` points are averaged for each pixel."""
        self.samples = samples
        self._mesh: Mesh | None = None
        self._seen = (0.0, False)
        self._tables: tuple[ContourTable, ContourTable]

    def paint(self, picture: DrawList) -> Any:
        """Draw the picture; gives a `PIL.Image.Image` in RGB of `picture.camera.size` pixels."""
        width, height = picture.camera.size
        surface = pygame.Surface((width * self.samples, height * self.samples), depth=24)
        surface.fill(_rgb(picture.theme.background))
        for fill in picture.region_fills:
            self._fill_region(surface, fill)
        for line in picture.below:
            self._stroke(surface, line, picture.theme.background)
        self._shapes(surface, picture)
        for line in picture.above:
            self._stroke(surface, line, picture.theme.background)
        for layer in picture.marks:
            paint_marks(surface, layer, self.samples)
        # Pillow's average is exact; pygame's smoothscale darkens colours by about two levels.
        large = Image.frombytes("RGB", surface.get_size(), pygame.image.tobytes(surface, "RGB"))
        image = large.reduce(self.samples)
        paint_labels(image, picture.labels, picture.theme)
        return image

    def _fill_region(self, surface: Any, fill: RegionFill) -> None:
        points = np.rint(fill.points * self.samples)
        low = points.min(axis=0)
        layer = pygame.Surface((np.ptp(points, axis=0) + 1).tolist(), pygame.SRCALPHA)
        pygame.draw.polygon(layer, (*_rgb(fill.color), round(255 * fill.opacity)), (points - low).tolist())
        surface.blit(layer, low.tolist())

    def _stroke(self, surface: Any, line: Line, background: tuple[float, ...]) -> None:
        color = _rgb(_over(line, background))
        start, end = np.array([line.start, line.end]) * self.samples
        half = max(line.width * self.samples, 1.0) / 2
        if (start == end).all():
            pygame.draw.circle(surface, color, np.floor(start).tolist(), half)
            return
        if (start == end).any():  # level, or upright: exact as a rectangle
            low, high = np.minimum(start, end) - half, np.maximum(start, end) + half
            surface.fill(color, (*np.rint(low), *np.rint(high - low)))
            return
        side = np.array([start[1] - end[1], end[0] - start[0]]) * (half / np.hypot(*(end - start)))
        corners = np.floor([start + side, end + side, end - side, start - side])
        pygame.draw.polygon(surface, color, corners.tolist())

    def _shapes(self, surface: Any, picture: DrawList) -> None:
        items = picture.shapes
        outer, inner = self._contours(picture)
        edges = self._placed(outer, picture)
        fills = self._placed(inner, picture)
        marks = _marks(picture, self.samples)
        fill, edge, mark = _bytes(items.fill), _bytes(items.edge), _bytes(_mark_colors(items))
        textured = (items.texture != NONE) & (items.grain > 0.0)
        first = int((~items.moving).sum())
        for i in range(len(items.index)):
            if i == first:
                self._textures(surface, picture, np.flatnonzero(textured[:first]), fills)
                self._shadows(surface, picture, edges)
            if items.opacity[i] < 1.0 and picture.hollow:
                self._hollow(surface, picture, i, (edges[i], fills[i]), (fill[i], edge[i]))
            elif items.opacity[i] < 1.0:
                self._translucent(surface, picture, i, (edges[i], fills[i]), (fill[i], edge[i]))
            elif items.index[i] in picture.mesh.outlines:
                self._concave(surface, picture, i, fill[i], edge[i])
            else:
                _fill(surface, edge[i], edges[i])
                self._inside(surface, fill[i], fills[i], edge[i] if items.hatched[i] else None)
            if items.mark_opacity[i] > 0.0:
                pygame.draw.polygon(surface, mark[i], marks[i])
        last = np.flatnonzero(textured[first:]) + first if first < len(textured) else np.flatnonzero(textured)
        self._textures(surface, picture, last, fills)

    def _textures(self, surface: Any, picture: DrawList, rows: Any, fills: list[Any]) -> None:
        if len(rows):
            filled = ((i, self._parts(picture, i, fills[i])) for i in rows.tolist())
            paint_textures(surface, picture, filled, self.samples)

    def _shadows(self, surface: Any, picture: DrawList, edges: list[Any]) -> None:
        rows = np.flatnonzero(picture.shapes.shadow > 0.0)
        if len(rows):
            cast = ((i, self._parts(picture, i, edges[i])) for i in rows.tolist())
            paint_shadows(surface, picture, cast, self.samples)

    def _parts(self, picture: DrawList, i: int, ring: Any) -> list[Any]:
        """What a shape is filled with, as convex polygons in pixels of the large surface."""
        outline = picture.mesh.outlines.get(int(picture.shapes.index[i]))
        if outline is None:
            return [ring]
        pieces, _ = concave_pieces(outline, picture.camera.scale, picture.shapes.grow[i], picture.shapes.line[i])
        return [self._placed_piece(picture, i, piece) for piece in pieces]

    def _translucent(
        self, surface: Any, picture: DrawList, i: int, rings: tuple[Any, Any], colors: tuple[Any, Any]
    ) -> None:
        """A shape through which one sees what is behind; `rings` are its rim and where its outline ends within."""
        alpha = round(255 * picture.shapes.opacity[i])
        for part in self._parts(picture, i, rings[1]):
            if len(part) >= 3:
                pygame.gfxdraw.filled_polygon(surface, part, (*colors[0], alpha))
        if rings[0]:
            width = max(round(picture.shapes.line[i] * self.samples), 1)
            middle = _between(*rings) if len(rings[0]) == len(rings[1]) else rings[1]
            pygame.draw.lines(surface, colors[1], True, middle, width)

    def _inside(self, surface: Any, color: Any, points: list[Any], hatch: Any) -> None:
        _fill(surface, color, points)
        if hatch is not None and len(points) >= 3:
            _hatch(surface, hatch, np.array(points), HATCH_PIXELS * self.samples)

    def _hollow(self, surface: Any, picture: DrawList, i: int, rings: tuple[Any, Any], colors: tuple[Any, Any]) -> None:
        """A shape of which little more than the outline is seen; `rings` are its rim and the middle of its outline."""
        items, outline = picture.shapes, picture.mesh.outlines.get(int(picture.shapes.index[i]))
        alpha, width = round(255 * items.opacity[i]), max(round(items.line[i] * self.samples), 1)
        parts, strips = [rings[0]], []
        if outline is not None:
            pieces = concave_pieces(outline, picture.camera.scale, items.grow[i], items.line[i])
            parts, strips = ([self._placed_piece(picture, i, piece) for piece in group] for group in pieces)
        for part in parts:
            if len(part) >= 3:
                pygame.gfxdraw.filled_polygon(surface, part, (*colors[0], alpha))
        for strip in strips:
            _fill(surface, colors[1], strip)
        if outline is None and len(rings[1]) >= 3:
            pygame.draw.lines(surface, colors[1], True, rings[1], width)

    def _concave(self, surface: Any, picture: DrawList, i: int, color: Any, edge: Any) -> None:
        """The parts of a concave polygon, which overlap by their boundary pixels, and its outline over them."""
        items, mesh, scale = picture.shapes, picture.mesh, picture.camera.scale
        pieces = concave_pieces(mesh.outlines[items.index[i]], scale, items.grow[i], items.line[i])
        parts, strips = ([self._placed_piece(picture, i, piece) for piece in group] for group in pieces)
        for part in parts:
            self._inside(surface, color, part, edge if items.hatched[i] else None)
        for strip in strips:
            _fill(surface, edge, strip)

    def _placed_piece(self, picture: DrawList, i: int, piece: Floats) -> list[Any]:
        margin, (width, height) = 64.0, picture.camera.size
        placed = _place(piece, picture.shapes, np.full(len(piece), i), self.samples)
        high = (width * self.samples + margin, height * self.samples + margin)
        inside: list[Any] = clip(placed, (-margin, -margin), high).tolist()
        return inside

    def _placed(self, table: ContourTable, picture: DrawList) -> list[Any]:
        """The contour of every visible shape in pixels of the large surface."""
        items = picture.shapes
        runs = _place_all(table, items, self.samples)
        margin, size = 64.0, picture.camera.size
        high = (size[0] * self.samples + margin, size[1] * self.samples + margin)
        reach = picture.mesh.reach[items.index] * picture.camera.scale
        for i in np.flatnonzero(reach > max(size)):
            # pygame walks through all rows of a polygon, seen or not.
            if runs[i]:
                runs[i] = clip(np.array(runs[i]), (-margin, -margin), high).tolist()
        return runs

    def _contours(self, picture: DrawList) -> tuple[ContourTable, ContourTable]:
        mesh, scale = picture.mesh, picture.camera.scale
        hollow = picture.hollow
        if mesh is not self._mesh or (scale, hollow) != self._seen:
            grow, line = stroke_sizes(mesh, scale)
            inner = 0.5 * hollow_lines(mesh, scale) if hollow else line
            outer = ContourTable(mesh, scale, grow, np.zeros_like(line))
            self._tables = outer, ContourTable(mesh, scale, grow, inner)
            self._mesh, self._seen = mesh, (scale, hollow)
        return self._tables


def _fill(surface: Any, color: Any, points: list[Any]) -> None:
    if len(points) >= 3:  # else it was clipped away
        pygame.draw.polygon(surface, color, points)


def _between(outer: list[Any], inner: list[Any]) -> list[Any]:
    """The ring halfway between two of as many corners."""
    middle: list[Any] = ((np.array(outer) + np.array(inner)) / 2).tolist()
    return middle


def _place_all(table: ContourTable, items: ShapeItems, samples: int) -> list[Any]:
    count = table.count[items.index]
    rows, first = gather(table.start[items.index], count)
    owner = np.repeat(np.arange(len(count)), count)
    return _runs(_place(table.points[rows], items, owner, samples), first)


def _place(points: Floats, items: ShapeItems, owner: Any, samples: int) -> Floats:
    a, b = items.axis[owner, 0], items.axis[owner, 1]
    u, v = points[:, 0], points[:, 1]
    turned = np.column_stack([a * u + b * v, b * u - a * v])
    # pygame fills a polygon with its boundary pixels, so the pixel that holds a corner is the right one.
    placed: Floats = np.floor((items.origin[owner] + turned) * samples)
    return placed


def _runs(points: Floats, first: Any) -> list[Any]:
    values = points.tolist()
    ends = [*first.tolist(), len(values)][1:]  # none where nothing is in sight
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


def _hatch(surface: Any, color: Any, polygon: Floats, distance: float) -> None:
    """Diagonal stripes across a convex polygon: each stripe is cut where x + y crosses the boundary."""
    level = polygon.sum(axis=1)
    following = np.roll(polygon, -1, axis=0)
    after = following.sum(axis=1)
    for stripe in np.arange(np.ceil(level.min() / distance) * distance, level.max(), distance):
        cut = (level <= stripe) != (after <= stripe)
        part = (stripe - level[cut]) / (after[cut] - level[cut])
        ends = polygon[cut] + (following[cut] - polygon[cut]) * part[:, None]
        if len(ends) == 2:
            pygame.draw.line(surface, color, ends[0], ends[1], 3)


def _over(line: Line, background: tuple[float, ...]) -> tuple[float, ...]:
    parts = zip(line.color, background, strict=True)
    return tuple(c * line.opacity + b * (1.0 - line.opacity) for c, b in parts)


def _rgb(color: tuple[float, ...]) -> tuple[int, ...]:
    return tuple(round(255 * part) for part in color)


def _bytes(colors: Floats) -> list[Any]:
    values: list[Any] = np.rint(255 * colors).astype(int).tolist()
    return values
