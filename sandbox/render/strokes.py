"""Strokes and fills by the thousand, as arrays: what overlays are made of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from sandbox.render.camera import Floats


@dataclass(frozen=True)
class Strokes:
    """Strokes with round ends, a row each: `start`, `end` (n, 2) and `width` (n,) in pixels, `color` (n, 3) sRGB,
    `opacity` (n,) 0..1. One whose ends are the same is a dot.
    """

    start: Floats
    end: Floats
    width: Floats
    color: Floats
    opacity: Floats

    def __len__(self) -> int:
        return len(self.width)


@dataclass(frozen=True)
class Fills:
    """Convex polygons of `k` corners each: `points` (n, k, 2) pixels, `color` (n, 3) sRGB, `opacity` (n,) 0..1."""

    points: Floats
    color: Floats
    opacity: Floats

    def __len__(self) -> int:
        return len(self.opacity)


def strokes(start: ArrayLike, end: ArrayLike, width: ArrayLike, color: ArrayLike, opacity: ArrayLike = 1.0) -> Strokes:
    """Strokes from `start` to `end` (n, 2); a single width, colour or opacity is that of all."""
    a, b = np.asarray(start, np.float64).reshape(-1, 2), np.asarray(end, np.float64).reshape(-1, 2)
    n = len(a)
    return Strokes(a, b, _each(width, n), _colors(color, n), _each(opacity, n))


def fills(points: ArrayLike, color: ArrayLike, opacity: ArrayLike) -> Fills:
    """Polygons (n, k, 2) of a colour and opacity."""
    corners = np.asarray(points, np.float64)
    return Fills(corners, _colors(color, len(corners)), _each(opacity, len(corners)))


def joined(parts: Sequence[Strokes]) -> Strokes:
    """All of them, one after the other."""
    if not parts:
        return NO_STROKES
    names = ("start", "end", "width", "color", "opacity")
    return Strokes(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))


def _each(value: ArrayLike, n: int) -> Floats:
    return np.broadcast_to(np.asarray(value, np.float64), (n,))


def _colors(value: ArrayLike, n: int) -> Floats:
    return np.broadcast_to(np.asarray(value, np.float64), (n, 3))


NO_STROKES = strokes(np.zeros((0, 2)), np.zeros((0, 2)), 1.0, (0.0, 0.0, 0.0))
