"""The tutorial's program, with each of its slips on a switch: the same steps in the same order, in our own code."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum, auto

Point = tuple[float, float]
Row = tuple[float, float, float, float, str]


class Slip(Enum):
    """What the printed program does wrong."""

    MAXIMUM_NEVER_GROWS = auto()
    OTHER_NAME_FOR_B = auto()
    MINIMA_COMPARED = auto()
    OTHER_FIELD_NAMES = auto()


@dataclass(frozen=True)
class ExplainedPolygon:
    """A polygon as the first piece of the program declares it."""

    vertices: Sequence[Point]
    edges: Sequence[Point]


@dataclass(frozen=True)
class Polygon:
    """A polygon as the test reads it, and as the whole program declares it in the end."""

    vertex: Sequence[Point]
    edge: Sequence[Point]


def edges_of(vertices: Sequence[Point]) -> list[Point]:
    """The vector from each vertex to the next."""
    following = [*vertices[1:], vertices[0]]
    return [(x1 - x0, y1 - y0) for (x0, y0), (x1, y1) in zip(vertices, following, strict=True)]


def run(
    a: Sequence[Point], b: Sequence[Point], *slips: Slip, edges_b: Sequence[Point] | None = None
) -> tuple[bool, list[Row]]:
    """(colliding, rows of amax, amin, bmax, bmin, gap); `edges_b` as somebody wrote them down, else those of b."""
    declared = ExplainedPolygon if Slip.OTHER_FIELD_NAMES in slips else Polygon
    first, second = declared(a, edges_of(a)), declared(b, edges_of(b) if edges_b is None else edges_b)
    stack = []
    for x, y in first.edge:
        perpendicular = -y, x
        stack.append(perpendicular)
    for x, y in second.edge:
        if Slip.OTHER_NAME_FOR_B not in slips:
            perpendicular = -y, x
        stack.append(perpendicular)
    rows: list[Row] = []
    for axis in stack:
        amin, amax = _interval(first.vertex, axis, Slip.MAXIMUM_NEVER_GROWS in slips)
        bmin, bmax = _interval(second.vertex, axis, False)
        overlap = amin < bmax and bmin < amax
        if Slip.MINIMA_COMPARED in slips:
            overlap = (amin < bmax and amin > bmin) or (bmin < amax and bmin > amin)
        rows.append((amax, amin, bmax, bmin, "No" if overlap else "Yes"))
        if not overlap:
            return False, rows
    return True, rows


def _interval(vertices: Sequence[Point], axis: Point, slipped: bool) -> tuple[float, float]:
    low = high = None
    for x, y in vertices:
        dot = x * axis[0] + y * axis[1]
        if high is None or (dot < low if slipped else dot > high):
            high = dot
        if low is None or dot < low:
            low = dot
    assert low is not None
    assert high is not None
    return low, high
