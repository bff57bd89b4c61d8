"""Soft shadows and textures on a pygame surface that has `samples` pixels for each of the picture."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache
from typing import Any

import numpy as np
import pygame
from numpy.typing import NDArray
from PIL import Image, ImageFilter

from sandbox.render.camera import Floats
from sandbox.render.draw_list import SHADOW_DROP, SHADOW_SOFT, DrawList, ShapeItems
from sandbox.render.geometry import Ints
from sandbox.render.materials.textures import TILE, UNITS, textures

_BLUR = 0.23 * SHADOW_SOFT
"""Deviation of the blur that fades about as the shader does."""
_LEVELS = 5
Polygons = Sequence[Sequence[Any]]
"""The convex parts of one shape in pixels of the large surface."""


def paint_shadows(surface: Any, picture: DrawList, rows: Iterable[tuple[int, Polygons]], samples: int) -> None:
    """The shadows of the shapes `rows` of the draw list, as one soft blot."""
    size, theme = picture.camera.size, picture.theme
    mask = pygame.Surface(size, depth=24)
    for row, parts in rows:
        gray = round(255.0 * float(picture.shapes.shadow[row]))
        for part in parts:
            if gray > 0 and len(part) >= 3:
                points = np.array(part, np.float64) / samples + (0.0, SHADOW_DROP)
                pygame.draw.polygon(mask, (gray, gray, gray), np.floor(points).tolist())
    values = Image.fromarray(np.ascontiguousarray(pygame.surfarray.array_red(mask).T))
    soft = np.asarray(values.filter(ImageFilter.GaussianBlur(_BLUR)))
    box = _box(soft > 0)
    if box is None:
        return
    left, top, right, bottom = box
    blot = pygame.Surface((right - left, bottom - top), pygame.SRCALPHA)
    blot.fill([round(255 * part) for part in theme.shadow])
    alpha: Any = pygame.surfarray.pixels_alpha(blot)
    alpha[:] = np.rint(theme.shadow_opacity * soft[top:bottom, left:right].T)
    del alpha  # which holds a lock on the surface
    surface.blit(_enlarged(blot, samples), (left * samples, top * samples))


def paint_textures(surface: Any, picture: DrawList, rows: Iterable[tuple[int, Polygons]], samples: int) -> None:
    """The textures of the shapes `rows` of the draw list, whose fills are painted already."""
    owner = pygame.Surface(picture.camera.size, depth=24)
    for row, parts in rows:
        color = ((row + 1) >> 16, (row + 1) >> 8 & 255, (row + 1) & 255)
        for part in parts:
            if len(part) >= 3:
                pygame.draw.polygon(owner, color, (np.array(part, np.float64) / samples).astype(int).tolist())
    bytes_: Any = pygame.surfarray.array3d(owner).astype(np.int64)
    row_at = (bytes_[:, :, 0] << 16 | bytes_[:, :, 1] << 8 | bytes_[:, :, 2]) - 1
    box = _box(row_at.T >= 0)
    if box is None:
        return
    left, top, right, bottom = box
    cut = row_at[left:right, top:bottom]
    x, y = np.nonzero(cut >= 0)
    added = np.zeros(cut.shape)
    added[x, y] = texture_at(picture.shapes, cut[x, y], np.column_stack([x + left + 0.5, y + top + 0.5]))
    for sign, blend in ((1.0, pygame.BLEND_RGB_ADD), (-1.0, pygame.BLEND_RGB_SUB)):
        gray = np.rint(255.0 * np.clip(sign * added, 0.0, 1.0)).astype(np.uint8)
        layer = pygame.surfarray.make_surface(np.repeat(gray[:, :, None], 3, axis=2))
        surface.blit(_enlarged(layer, samples), (left * samples, top * samples), special_flags=blend)


def texture_at(items: ShapeItems, row: Ints, pixel: Floats) -> Floats:
    """What textures add to the colours of shapes `row` (p,) at pixels (p, 2) of the picture, sRGB (p,)."""
    to = pixel - items.origin[row]
    a, b = items.axis[row].T
    u, v = a * to[:, 0] + b * to[:, 1], b * to[:, 0] - a * to[:, 1]
    upright, tiles = items.upright[row], 1.0 / (UNITS * np.maximum(items.unit[row], 1e-9))
    along = np.where(upright, v, u) * tiles + items.shift[row, 0]
    across = np.where(upright, u, v) * tiles + items.shift[row, 1]
    strength = items.grain[row] * items.opacity[row]
    level = np.clip(np.rint(np.log2(np.maximum(TILE * tiles, 1.0))), 0, _LEVELS - 1).astype(np.int64)
    found = np.zeros(len(row))
    for each in np.unique(level).tolist():
        which = level == each
        found[which] = _sample(_shrunk()[each], items.texture[row[which]], along[which], across[which])
    added: Floats = found * strength
    return added


def _sample(tiles: NDArray[Any], number: Ints, along: Floats, across: Floats) -> Floats:
    """Between the four samples around each place; places are in tiles."""
    side = tiles.shape[1]
    x, y = (along % 1.0) * side - 0.5, (across % 1.0) * side - 0.5
    column, line = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
    s, t = x - column, y - line
    here, right = column % side, (column + 1) % side
    low, high = line % side, (line + 1) % side
    bottom = tiles[number, low, here] * (1.0 - s) + tiles[number, low, right] * s
    top = tiles[number, high, here] * (1.0 - s) + tiles[number, high, right] * s
    between: Floats = bottom * (1.0 - t) + top * t
    return between


@cache
def _shrunk() -> tuple[NDArray[Any], ...]:
    """The textures, and each time half as large."""
    levels: list[NDArray[Any]] = [textures()]
    for _ in range(_LEVELS - 1):
        large = levels[-1]
        levels.append((large[:, ::2, ::2] + large[:, 1::2, ::2] + large[:, ::2, 1::2] + large[:, 1::2, 1::2]) / 4)
    return tuple(levels)


def _box(mask: NDArray[np.bool_]) -> tuple[int, int, int, int] | None:
    """Left, top, right, bottom of what is True in (height, width); None if nothing is."""
    columns, lines = np.flatnonzero(mask.any(axis=0)), np.flatnonzero(mask.any(axis=1))
    if len(columns) == 0:
        return None
    return int(columns[0]), int(lines[0]), int(columns[-1]) + 1, int(lines[-1]) + 1


def _enlarged(layer: Any, samples: int) -> Any:
    width, height = layer.get_size()
    return pygame.transform.scale(layer, (width * samples, height * samples))
