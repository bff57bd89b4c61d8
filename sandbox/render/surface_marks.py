"""The layers of overlays on a pygame surface, and the words on the finished picture."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np
import pygame
import pygame.gfxdraw
from PIL import ImageDraw, ImageFont

from sandbox.render.camera import Floats
from sandbox.render.label import Label
from sandbox.render.marks import Marks
from sandbox.render.strokes import Fills, Strokes
from sandbox.render.theme import Color, Theme

HALO_PIXELS = 2
_FAR = 16_000.0
"""Pixels of the large surface beyond which corners are moved closer: SDL counts them in 16 bits here."""
_ANCHORS = {"left": "lm", "middle": "mm", "right": "rm"}


def paint_marks(surface: Any, layer: Marks, samples: int) -> None:
    """Draw fills, then strokes, on a surface that has `samples` pixels for each of the picture."""
    for fills in layer.fills:
        _paint_fills(surface, fills, samples)
    _paint_strokes(surface, layer.strokes, samples)


def paint_labels(picture: Any, labels: Sequence[Label], theme: Theme) -> None:
    """Write all labels on a Pillow image, each with a halo in the colour of the background."""
    if not labels:
        return
    draw = ImageDraw.Draw(picture)
    for label in labels:
        draw.text(
            label.at, label.text, fill=_rgb(label.color), font=_font(label.size), anchor=_ANCHORS[label.anchor],
            stroke_width=HALO_PIXELS, stroke_fill=_rgb(theme.background),
        )  # fmt: skip


def _paint_fills(surface: Any, fills: Fills, samples: int) -> None:
    corners = np.clip(np.floor(fills.points * samples), -_FAR, _FAR).astype(int).tolist()
    for points, color in zip(corners, _paints(fills.color, fills.opacity), strict=True):
        pygame.gfxdraw.filled_polygon(surface, points, color)


def _paint_strokes(surface: Any, strokes: Strokes, samples: int) -> None:
    start, way = strokes.start * samples, (strokes.end - strokes.start) * samples
    length = np.hypot(way[:, 0], way[:, 1])
    # pygame fills a polygon with its boundary pixels: one sample more than its width.
    half = np.maximum(strokes.width * samples - 1.0, 0.5) / 2
    dot = length == 0.0
    colors = _paints(strokes.color, strokes.opacity)
    unit = way / np.where(dot, 1.0, length)[:, None]
    side = half[:, None] * np.column_stack([-unit[:, 1], unit[:, 0]])
    cap = 0.5 * half[:, None] * unit  # about as far as a round end reaches
    a, b = start - cap, start + way + cap
    corners = np.clip(np.floor(np.stack([a + side, b + side, b - side, a - side], axis=1)), -_FAR, _FAR)
    rings, centers, radii = corners.astype(int).tolist(), np.floor(start).tolist(), (half + 0.5).tolist()
    opaque = (strokes.opacity >= 1.0).tolist()
    draw, blend = pygame.draw, pygame.gfxdraw
    for k, is_dot in enumerate(dot.tolist()):
        if is_dot and opaque[k]:
            draw.circle(surface, colors[k], centers[k], radii[k])
        elif is_dot:
            _blend_disc(surface, centers[k], radii[k], colors[k])
        elif opaque[k]:
            draw.polygon(surface, colors[k], rings[k])
        else:
            blend.filled_polygon(surface, rings[k], colors[k])


def _blend_disc(surface: Any, center: Sequence[float], radius: float, color: Any) -> None:
    x, y = center
    if abs(x) < _FAR and abs(y) < _FAR:
        pygame.gfxdraw.filled_circle(surface, round(x), round(y), max(round(radius), 1), color)


def _paints(color: Floats, opacity: Floats) -> Any:
    return np.rint(255.0 * np.clip(np.column_stack([color, opacity]), 0.0, 1.0)).astype(int).tolist()


@cache
def _font(size: float) -> Any:
    return ImageFont.load_default(size)


def _rgb(color: Color) -> tuple[int, int, int]:
    red, green, blue = (round(255 * part) for part in color)
    return red, green, blue
