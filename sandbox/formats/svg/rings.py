"""Which rings of a path are outlines, and which are holes in them.

Source: SVG 2, section 13.4.2 (`fill-rule`). A ring bounds what is filled if it is filled on one side of it only.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from itertools import pairwise

from sandbox.formats.numbers import Vec

Ring = Sequence[Vec]
Box = tuple[float, float, float, float]
"""Left, bottom, right, top."""
_SMALLEST = 2.0**-30


def outlines(rings: Sequence[Ring], even_odd: bool) -> list[tuple[Ring, list[Ring]]]:
    """Each outline with its holes. Rings are taken not to cross each other."""
    near = _boxes_around([ring[0] for ring in rings], [_box(ring) for ring in rings])
    inside = [[k for k in near[n] if k != n and _winding(rings[k], ring[0])] for n, ring in enumerate(rings)]
    turns = [1 if _area(ring) > 0.0 else -1 for ring in rings]
    found: dict[int, list[Ring]] = {}
    holes = []
    for n, ring in enumerate(rings):
        around = sum(turns[k] for k in inside[n])
        filled = [(len(inside[n]) + add) % 2 == 1 if even_odd else around + add * turns[n] != 0 for add in (0, 1)]
        if filled == [False, True]:
            found[n] = []
        elif filled == [True, False]:
            holes.append((n, ring))
    for n, ring in holes:
        around_it = [k for k in inside[n] if k in found]
        if around_it:
            found[max(around_it, key=lambda k: len(inside[k]))].append(ring)
    return [(rings[n], own) for n, own in found.items()]


def _area(ring: Ring) -> float:
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in pairwise([*ring, ring[0]]))


def _box(ring: Ring) -> Box:
    xs, ys = zip(*ring, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _boxes_around(points: Sequence[Vec], boxes: Sequence[Box]) -> list[list[int]]:
    """For each point the boxes that it lies in. Each box lies in a few cells of a grid that is as wide and as high as
    it, so that its own cells, one of each such grid, are all that a point is looked for in.
    """
    cells: defaultdict[tuple[float, ...], list[int]] = defaultdict(list)
    for k, (left, bottom, right, top) in enumerate(boxes):
        width, height = _cell(right - left), _cell(top - bottom)
        for column in range(math.floor(left / width), math.floor(right / width) + 1):
            for row in range(math.floor(bottom / height), math.floor(top / height) + 1):
                cells[width, height, column, row].append(k)
    grids = {(width, height) for width, height, *_ in cells}
    found = []
    for x, y in points:
        mine = (cells.get((width, height, x // width, y // height), ()) for width, height in grids)
        found.append(sorted(k for some in mine for k in some if _covers(boxes[k], (x, y))))
    return found


def _cell(extent: float) -> float:
    """The next power of two, by which division is exact."""
    return 2.0 ** math.frexp(max(extent, _SMALLEST))[1]


def _covers(box: Box, point: Vec) -> bool:
    return box[0] <= point[0] <= box[2] and box[1] <= point[1] <= box[3]


def _winding(ring: Ring, point: Vec) -> int:
    """How often a ring goes round a point."""
    x, y = point
    count = 0
    for (ax, ay), (bx, by) in pairwise([*ring, ring[0]]):
        if (ay <= y) != (by <= y):
            side = (bx - ax) * (y - ay) - (x - ax) * (by - ay)
            if (side > 0.0) == (by > ay):
                count += 1 if by > ay else -1
    return count
