"""Ellipses and rounded boxes as shapes of a scene."""

from __future__ import annotations

import math

from sandbox.formats.numbers import Vec, tidy, tidy_point
from sandbox.formats.outlines import Words


def capsule_words(width: float, height: float) -> Words:
    """A box whose shorter sides are half circles, about its middle; m."""
    radius, half = min(width, height) / 2.0, abs(width - height) / 2.0
    if half < 1e-6:
        return {"circle": tidy(radius)}
    end = (half, 0.0) if width > height else (0.0, half)
    return {"capsule": [tidy_point((-end[0], -end[1])), tidy_point(end)], "radius": tidy(radius)}


def ellipse_points(width: float, height: float, tolerance: float) -> list[Vec]:
    """An ellipse about the origin as a polygon whose corners lie on it."""
    count = sides_of(max(width, height) / 2.0, tolerance)
    steps = [2.0 * math.pi * k / count for k in range(count)]
    return [(width / 2.0 * math.cos(t), height / 2.0 * math.sin(t)) for t in steps]


def sides_of(radius: float, tolerance: float) -> int:
    """How many sides a circle needs so that none lies further than `tolerance` within it: 8 to 48, a multiple of 4."""
    if tolerance >= radius:
        return 8
    count = math.pi / max(1e-3, math.acos(1.0 - tolerance / radius))
    return min(48, max(8, 4 * math.ceil(count / 4.0)))
