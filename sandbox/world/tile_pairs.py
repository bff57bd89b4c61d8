"""Which tiles lie side by side: pairs whose boxes meet, and that no line aslant parts.

Tiles of alike size form a level, whose plane is cut into strips as high as its tiles are at most, those of each whole
by themselves; along a strip they are sorted. A tile asks each level for what lies near it, so the cost grows with the
tiles and the pairs, whatever the sizes.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from sandbox.tables import Floats, Integers
from sandbox.world.runs import owners, runs
from sandbox.world.tile_outlines import Outlines, Tiles, kept

_NEAR = 1e-6
"""Boxes this near to each other, in metres, on both sides, meet."""
_AT_ONCE = 60_000
"""So many pairs at a time keep the memory small."""
_MARGIN = 1.001
"""Levels allow for what differences of coordinates round."""
_ASLANT = ((1.0, 1.0), (1.0, -1.0), (2.0, 1.0), (2.0, -1.0), (1.0, 2.0), (1.0, -2.0))
"""Directions along which tiles whose boxes meet may still lie apart: of what is long and aslant, boxes say little."""
_APART = 5e-4
"""Gap along such a direction past which nothing of two tiles meets: well over 1e-4 m, however long the direction is."""


@dataclass(frozen=True)
class _Boxes:
    left: Floats
    low: Floats
    right: Floats
    high: Floats
    aslant: list[tuple[Floats, Floats]]
    """From where to where tiles reach along each of `_ASLANT`."""
    wholes: Integers

    @classmethod
    def of(cls, outlines: Outlines) -> _Boxes:
        starts = outlines.starts
        left, low = (np.minimum.reduceat(each, starts) - _NEAR for each in (outlines.x, outlines.y))
        right, high = (np.maximum.reduceat(each, starts) + _NEAR for each in (outlines.x, outlines.y))
        ways = (x * outlines.x + y * outlines.y for x, y in _ASLANT)
        reaches = [(np.minimum.reduceat(way, starts), np.maximum.reduceat(way, starts) + _APART) for way in ways]
        return cls(left, low, right, high, reaches, outlines.wholes)


class _Level:
    """Tiles between half of `width` and all of it wide, and likewise high, strip after strip, sorted by their left."""

    def __init__(self, boxes: _Boxes, tiles: Tiles, width: float, height: float) -> None:
        self._width, self._height = width, height
        left, strip = boxes.left[tiles], np.floor(boxes.low[tiles] / height)
        self._lowest, self._highest = strip.min() - 1.0, strip.max() + 1.0
        self._lefts = np.sort(left)
        self._strips, number = np.unique(self._numbered(boxes, tiles, strip), return_inverse=True)
        keys = number * (len(tiles) + 1) + np.searchsorted(self._lefts, left)
        order = np.argsort(keys, kind="stable")
        self._keys, self.tiles = keys[order], tiles[order]

    def near(self, boxes: _Boxes, asking: Tiles) -> tuple[Integers, Integers, Integers]:
        """Runs of the level's tiles in which those lie that `asking` may meet: whose run, where it begins and ends."""
        lowest, highest = (boxes.low[asking] - self._height) / self._height, boxes.high[asking] / self._height
        bottom = np.searchsorted(self._strips, self._numbered(boxes, asking, np.floor(lowest)))
        top = np.searchsorted(self._strips, self._numbered(boxes, asking, np.floor(highest)), side="right")
        whose, line = owners(top - bottom), runs(bottom, top - bottom) * (len(self.tiles) + 1)
        first = np.searchsorted(self._lefts, boxes.left[asking] - self._width)
        last = np.searchsorted(self._lefts, boxes.right[asking], side="right")
        starts, ends = (np.searchsorted(self._keys, line + rank[whose]) for rank in (first, last))
        return whose, starts, ends

    def _numbered(self, boxes: _Boxes, tiles: Tiles, strip: Floats) -> Floats:
        """Strips of the wholes of some tiles, each with numbers of its own."""
        each = self._highest - self._lowest + 1.0
        number: Floats = boxes.wholes[tiles] * each + (np.clip(strip, self._lowest, self._highest) - self._lowest)
        return number


def meeting_tiles(outlines: Outlines, asking: Tiles) -> Iterator[tuple[Tiles, Tiles]]:
    """All pairs of a tile in `asking` and another one whose boxes meet, some at a time, sorted.

    All pairs of one tile come at the same time; those of a later one come later.
    """
    boxes = _Boxes.of(outlines)
    levels = list(_levels(boxes))
    blocks = [asking]
    while blocks:
        block = blocks.pop()
        found = [level.near(boxes, block) for level in levels]
        total = sum(int((ends - starts).sum()) for _, starts, ends in found)
        if len(block) > 1 and total > _AT_ONCE:
            blocks += np.array_split(block, min(len(block), 2 + total // _AT_ONCE))[::-1]
            continue
        parts = [_meeting(boxes, level, block, *each) for level, each in zip(levels, found, strict=True)]
        one, two = (np.concatenate(each) for each in zip(*parts, strict=True))
        order = np.lexsort((two, one))
        yield one[order], two[order]


def count_near(outlines: Outlines) -> int:
    """How many pairs of edges those tiles have that `meeting_tiles` would look at for all, each from both sides."""
    boxes = _Boxes.of(outlines)
    counts = outlines.counts
    total = 0
    for level in _levels(boxes):
        whose, starts, ends = level.near(boxes, np.arange(len(counts)))
        before = np.concatenate([[0], np.cumsum(counts[level.tiles])])
        total += int(((before[ends] - before[starts]) * counts[whose]).sum())
    return total


def count_meeting(outlines: Outlines, most: int) -> int:
    """How many pairs of edges those tiles have that `meeting_tiles` finds; it stops to look past `most`."""
    counts = outlines.counts
    total = 0
    for one, two in meeting_tiles(outlines, np.arange(len(counts))):
        total += int((counts[one] * counts[two]).sum())
        if total > most:
            break
    return total


def _levels(boxes: _Boxes) -> Iterator[_Level]:
    sizes = [(boxes.right - boxes.left) * _MARGIN, (boxes.high - boxes.low) * _MARGIN]
    exponents = np.stack([np.frexp(each)[1] for each in sizes], axis=1)
    kinds, number = np.unique(exponents, axis=0, return_inverse=True)
    number = number.ravel()
    for k, (wide, high) in enumerate(kinds.tolist()):
        yield _Level(boxes, np.flatnonzero(number == k), 2.0**wide, 2.0**high)


def _meeting(
    boxes: _Boxes, level: _Level, asking: Tiles, whose: Integers, starts: Integers, ends: Integers
) -> tuple[Tiles, Tiles]:
    counts = ends - starts
    one, two = asking[np.repeat(whose, counts)], level.tiles[runs(starts, counts)]
    for below, above in ((boxes.low, boxes.high), (boxes.left, boxes.right), *boxes.aslant):
        one, two = kept((below[one] <= above[two]) & (below[two] <= above[one]), one, two)
    one, two = kept(one != two, one, two)
    return one, two
