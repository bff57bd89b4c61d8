"""Which directions lead out of a whole: of a polygon, a chain or a floor of tiles, however it may be cut into parts.

A whole is its rings: closed runs of corners with the solid on their left. A chain is the ring that goes along it and
back. Where something touches a side, only the side's normal leads out; at a corner all directions between the normals
of its two sides do, if they open outwards; in a dent none but the two themselves.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

Vec = tuple[float, float]
TURN = 2.0 * math.pi


@dataclass(frozen=True)
class Way:
    """A way out that is nearest to some point around it: how far that is outside (m), and in which direction."""

    distance: float
    normal: Vec


def sides(rings: Sequence[Sequence[Vec]]) -> list[tuple[Vec, Vec]]:
    """All sides, ring after ring."""
    return [(ring[k], ring[(k + 1) % len(ring)]) for ring in rings for k in range(len(ring))]


def corners(rings: Sequence[Sequence[Vec]]) -> list[tuple[Vec, Vec, Vec]]:
    """All corners with the ones before and after them."""
    return [(ring[k - 1], ring[k], ring[(k + 1) % len(ring)]) for ring in rings for k in range(len(ring))]


def outward(start: Vec, end: Vec) -> Vec:
    """Unit normal of a side."""
    x, y = end[0] - start[0], end[1] - start[1]
    length = math.hypot(x, y)
    return y / length, -x / length


def along(point: Vec, start: Vec, end: Vec) -> float:
    """Where a point lies along a side, in metres from its start."""
    x, y = end[0] - start[0], end[1] - start[1]
    return ((point[0] - start[0]) * x + (point[1] - start[1]) * y) / math.hypot(x, y)


def height(point: Vec, start: Vec, end: Vec) -> float:
    """How far outside of a side's line a point is, m."""
    x, y = outward(start, end)
    return (point[0] - start[0]) * x + (point[1] - start[1]) * y


def turned(first: Vec, second: Vec) -> float:
    """Angle from one direction to another, counter-clockwise, 0 to a whole turn."""
    return math.atan2(first[0] * second[1] - first[1] * second[0], first[0] * second[0] + first[1] * second[1]) % TURN


def opening(before: Vec, corner: Vec, after: Vec) -> float:
    """Angle between the normals of the sides that meet in a corner; more than half a turn in a dent."""
    return turned(outward(before, corner), outward(corner, after))


def is_between(normal: Vec, before: Vec, corner: Vec, after: Vec, slant: float) -> bool:
    """Whether a direction lies, but for a slant (rad), between the normals of the sides that meet in a corner."""
    most = opening(before, corner, after)
    if most > math.pi + 1e-9:
        return False
    angle = turned(outward(before, corner), normal)
    return angle <= most + slant or angle >= TURN - slant


def leads_out(rings: Sequence[Sequence[Vec]], normal: Vec, point: Vec, reach: float, slant: float) -> bool:
    """Whether a direction leads out of the whole somewhere within `reach` of a point."""
    for start, end in sides(rings):
        angle = turned(outward(start, end), normal)
        if distance([(start, end)], point) <= reach and min(angle, TURN - angle) <= slant:
            return True
    return any(
        math.dist(point, corner) <= reach and is_between(normal, before, corner, after, slant)
        for before, corner, after in corners(rings)
    )


def ways_out(rings: Sequence[Sequence[Vec]], point: Vec, reach: float) -> list[Way]:
    """From a point outside of the whole, the ways from it that are shortest around themselves, up to `reach`."""
    found = []
    for start, end in sides(rings):
        above = height(point, start, end)
        if 0.0 < above <= reach and 0.0 <= along(point, start, end) <= math.dist(start, end):
            found.append(Way(above, outward(start, end)))
    for before, corner, after in corners(rings):
        distance = math.dist(point, corner)
        if 0.0 < distance <= reach:
            normal = (point[0] - corner[0]) / distance, (point[1] - corner[1]) / distance
            if is_between(normal, before, corner, after, 0.0):
                found.append(Way(distance, normal))
    return found


def distance(rings: Sequence[Sequence[Vec]], point: Vec) -> float:
    """How far a point is from the rings, m."""
    found = math.inf
    for start, end in sides(rings):
        place, length = along(point, start, end), math.dist(start, end)
        found = min(found, math.hypot(max(-place, place - length, 0.0), height(point, start, end)))
    return found


def holds(rings: Sequence[Sequence[Vec]], point: Vec) -> bool:
    """Whether a point lies inside: how often does a ray to the right cross the rings?"""
    inside = False
    for (ax, ay), (bx, by) in sides(rings):
        if (ay > point[1]) != (by > point[1]) and point[0] < ax + (point[1] - ay) / (by - ay) * (bx - ax):
            inside = not inside
    return inside
