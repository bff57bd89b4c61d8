"""Arcs of ellipses, as paths of SVG have them, as points.

Source: SVG 2, appendix B.2.4, "Conversion from endpoint to center parameterization".
"""

from __future__ import annotations

import math
from collections.abc import Iterator

Vec = tuple[float, float]

MOST_SIDES = 200
"""Sides of one curve."""


def arc_points(start: Vec, end: Vec, radii: Vec, shape: list[float], tolerance: float) -> Iterator[Vec]:
    """Points between the ends of an arc, not further than `tolerance` apart from it.

    `shape` is the turn of its ellipse in degrees, and the flags for the larger arc and for the one that turns from x to
    y. Radii that are too small for the two ends grow as far as needed.
    """
    turn = math.radians(shape[0])
    cosine, sine = math.cos(turn), math.sin(turn)
    dx, dy = (start[0] - end[0]) / 2, (start[1] - end[1]) / 2
    x, y = cosine * dx + sine * dy, cosine * dy - sine * dx
    rx, ry = radii
    grow = math.sqrt(max(1.0, (x / rx) ** 2 + (y / ry) ** 2))
    rx, ry = rx * grow, ry * grow
    reach = (rx * y) ** 2 + (ry * x) ** 2
    share = math.sqrt(max(0.0, (rx * ry) ** 2 - reach) / reach) if reach > 0.0 else 0.0
    share = -share if shape[1] == shape[2] else share
    cx, cy = share * rx * y / ry, -share * ry * x / rx
    first = math.atan2((y - cy) / ry, (x - cx) / rx)
    sweep = math.atan2((-y - cy) / ry, (-x - cx) / rx) - first
    if shape[2] and sweep < 0.0:
        sweep += 2.0 * math.pi
    elif not shape[2] and sweep > 0.0:
        sweep -= 2.0 * math.pi
    middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    count = _steps(max(rx, ry), sweep, tolerance)
    for k in range(1, count):
        angle = first + sweep * k / count
        px, py = cx + rx * math.cos(angle), cy + ry * math.sin(angle)
        yield cosine * px - sine * py + middle[0], sine * px + cosine * py + middle[1]


def _steps(radius: float, angle: float, tolerance: float) -> int:
    """How many sides an arc of so many radians needs, so that none lies further than `tolerance` from it."""
    if tolerance >= radius:
        return max(1, math.ceil(abs(angle) / (math.pi / 4.0)))
    return min(MOST_SIDES, max(1, math.ceil(abs(angle) / max(1e-6, 2.0 * math.acos(1.0 - tolerance / radius)))))
