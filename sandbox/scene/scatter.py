"""Random places in a rectangle that keep a distance from each other."""

from __future__ import annotations

from sandbox.scene.flat import Vec
from sandbox.scene.splitmix import SplitMix64

_TRIES_EACH, _TRIES_MORE = 20, 10_000
_MISSES = 10_000
"""After so many in a row, there is no room for more."""


def scatter(count: int, box: tuple[float, float, float, float], apart: float, random: SplitMix64) -> list[Vec]:
    """Up to `count` points (m) in `box` (left, bottom, right, top), each at least `apart` m from all others.

    Throws darts and keeps those that keep their distance; fewer points than asked for means that no room was
    found for more.
    """
    left, bottom, right, top = box
    # Points nearer than `apart` lie in the 3 by 3 cells around; the least size keeps the cell numbers small.
    cell = max(apart, (right - left + top - bottom) * 1e-6)
    cells: dict[tuple[int, int], list[Vec]] = {}
    points: list[Vec] = []
    misses = 0
    for _ in range(_TRIES_EACH * count + _TRIES_MORE):
        if len(points) == count or misses > _MISSES:
            break
        misses += 1
        point = (random.between(left, right), random.between(bottom, top))
        column, row = int((point[0] - left) // cell), int((point[1] - bottom) // cell)
        if apart == 0.0 or _has_room(point, column, row, cells, apart * apart):
            cells.setdefault((column, row), []).append(point)
            points.append(point)
            misses = 0
    return points


def _has_room(point: Vec, column: int, row: int, cells: dict[tuple[int, int], list[Vec]], apart_squared: float) -> bool:
    for i in (column - 1, column, column + 1):
        for j in (row - 1, row, row + 1):
            for x, y in cells.get((i, j), ()):
                if (point[0] - x) * (point[0] - x) + (point[1] - y) * (point[1] - y) < apart_squared:
                    return False
    return True
