"""The metre grid behind the bodies: 1, 2 or 5 times a power of ten apart, so that lines never crowd."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sandbox.render.camera import Camera

MINOR_PIXELS = 34.0
"""Smallest distance between two grid lines on screen."""


@dataclass(frozen=True)
class GridLine:
    """A line at x (`vertical`) or y = `pixel`, which is `metres`; `rank` 0 minor, 1 major (5 or 10 times a power
    of ten metres), 2 through the origin.
    """

    vertical: bool
    pixel: float
    metres: float
    rank: int


def spacing(scale: float, smallest: float = MINOR_PIXELS) -> float:
    """Metres between lines at `scale` pixels a metre: the least of 1, 2, 5 x 10^k wide enough."""
    least = smallest / scale
    power = 10.0 ** math.floor(math.log10(least))
    return next(k * power for k in (1.0, 2.0, 5.0, 10.0, 20.0) if k * power >= least)


def grid_lines(camera: Camera) -> list[GridLine]:
    """All lines of the visible grid, minor ones first."""
    step = spacing(camera.scale)
    x0, y0, x1, y1 = camera.bounds
    lines = [GridLine(True, *line) for line in _positions(x0, x1, step, camera, 0)]
    lines += [GridLine(False, *line) for line in _positions(y0, y1, step, camera, 1)]
    return sorted(lines, key=lambda line: line.rank)


def _positions(low: float, high: float, step: float, camera: Camera, axis: int) -> list[tuple[float, float, int]]:
    indices = range(math.ceil(low / step), math.floor(high / step) + 1)
    points = np.zeros((len(indices), 2))
    points[:, axis] = np.array(indices) * step
    pixels = camera.to_screen(points)[:, axis]
    group = 2 if round(step / 10.0 ** math.floor(math.log10(step) + 1e-9)) == 5 else 5
    ranks = [2 if k == 0 else 1 if k % group == 0 else 0 for k in indices]
    return [(float(p), k * step, rank) for p, k, rank in zip(pixels, indices, ranks, strict=True)]
