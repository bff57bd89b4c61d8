"""From a chain to its links: segments that know what joins them."""

from __future__ import annotations

import math
from collections.abc import Sequence

from sandbox.scene.flat import SeamRow, Vec

_SHOWN, _HIDDEN = (0.0, 1.0), (1.0, 0.0)


def links(points: Sequence[Vec], closed: bool) -> list[tuple[Vec, Vec]]:
    """The two ends of every link, in order."""
    after = [*points[1:], points[0]] if closed else points[1:]
    return list(zip(points, after, strict=False))


def left_of(link: tuple[Vec, Vec]) -> Vec:
    """Unit normal to the left of a link's direction."""
    (ax, ay), (bx, by) = link
    length = math.hypot(bx - ax, by - ay)
    return -(by - ay) / length, (bx - ax) / length


def seams(points: Sequence[Vec], closed: bool, one_sided: bool, ghosts: Sequence[Vec] | None) -> list[list[SeamRow]]:
    """For every link the rows of its two vertices: which directions lead out there, and which of its sides show.

    The side to the right is the edge from the first vertex on, that to the left the edge from the second.
    """
    own = [left_of(link) for link in links(points, closed)]
    first = last = None
    if closed:
        first, last = own[-1], own[0]
    elif ghosts:
        first, last = left_of((ghosts[0], points[0])), left_of((points[-1], ghosts[1]))
    before = [first, *own[:-1]]
    after = [*own[1:], last]
    right = _HIDDEN if one_sided else _SHOWN
    return [
        [(*_joint(before[k], n, one_sided), *right), (*_joint(n, after[k], one_sided), *_SHOWN)]
        for k, n in enumerate(own)
    ]


def _joint(one: Vec | None, two: Vec | None, one_sided: bool) -> tuple[float, float, float, float]:
    """Between which directions, counter-clockwise, what touches the point where two links meet may be pushed.

    Given by the left normals of both; None beyond an end. Where both are alike, or turn the other way round, nothing
    lies between them.
    """
    if one is None or two is None:
        return _end(one, two, one_sided)
    if one_sided or one[0] * two[1] - one[1] * two[0] < 0.0:
        return *two, *one
    return -one[0], -one[1], -two[0], -two[1]


def _end(one: Vec | None, two: Vec | None, one_sided: bool) -> tuple[float, float, float, float]:
    """The same at a free end: all directions that lead away from the link."""
    if one is not None:
        along = one[1], -one[0]
        return (*along, *one) if one_sided else (-one[0], -one[1], *one)
    assert two is not None
    back = -two[1], two[0]
    return (*two, *back) if one_sided else (*two, -two[0], -two[1])
