"""Numbers as a scene has them."""

from __future__ import annotations

import math
from collections.abc import Iterable

Vec = tuple[float, float]

_PLACES = 9


def tidy(value: float) -> float:
    """A number to a billionth: what lies beyond is noise of arithmetic."""
    return round(value, _PLACES) + 0.0


def tidy_point(point: Vec) -> list[float]:
    """A point in whole billionths of a metre."""
    return [tidy(point[0]), tidy(point[1])]


def tidy_points(points: Iterable[Vec]) -> list[list[float]]:
    """Points in whole billionths of a metre."""
    return [tidy_point(point) for point in points]


def degrees(radians: float) -> float:
    """An angle as a scene tells it."""
    return tidy(math.degrees(radians))


def turned(point: Vec, angle: float) -> Vec:
    """A point turned about the origin by `angle` radians."""
    cosine, sine = math.cos(angle), math.sin(angle)
    return cosine * point[0] - sine * point[1], sine * point[0] + cosine * point[1]
