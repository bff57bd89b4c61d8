"""Words on a picture, and where they find room: no label covers another."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from sandbox.render.camera import Size, Vec
from sandbox.render.theme import Color

Box = tuple[float, float, float, float]
"""Left, top, right and bottom in pixels."""
Anchor = Literal["left", "middle", "right"]

LETTER = 0.56
"""Mean width of a letter, in parts of the size of the text."""
MOST_LABELS, MOST_TRIED = 300, 1200
_BEFORE: dict[Anchor, float] = {"left": 0.0, "middle": 0.5, "right": 1.0}
"""Share of its width that lies left of a label's anchor."""
APART = 20, 12
"""Pixels across and down within which only the first of several points is tried."""
CELL = 6
"""Pixels of the raster on which labels book their room."""


@dataclass(frozen=True)
class Label:
    """A line of text, `size` pixels high, centred vertically on the pixel `at`, which is its `anchor`.

    With a `gap` (pixels) it stands so far beside `at`, on whichever side there is room. Those of higher `rank` come
    first.
    """

    text: str
    at: Vec
    color: Color
    size: float = 12.0
    anchor: Anchor = "left"
    gap: float = 0.0
    rank: float = 0.0

    @property
    def box(self) -> Box:
        """About what it covers."""
        return _box(self.at, self.anchor, self)


def place_labels(
    labels: Sequence[Label], size: Size, taken: Sequence[Box] = (), most: int = MOST_LABELS
) -> tuple[Label, ...]:
    """Those labels that find room in a picture of `size` pixels, each where it has room; at most `most`.

    None comes to lie in the boxes that are `taken`.
    """
    booked = np.zeros((size[1] // CELL + 1, size[0] // CELL + 1), np.bool_)
    for box in taken:
        booked[_cells(box)] = True
    placed: list[Label] = []
    for label in _spread(labels):
        for at, anchor in _places(label):
            box = _box(at, anchor, label)
            if _within(box, size) and not booked[_cells(box)].any():
                booked[_cells(box)] = True
                placed.append(replace(label, at=at, anchor=anchor, gap=0.0))
                break
        if len(placed) == most:
            break
    return tuple(placed)


def _spread(labels: Sequence[Label]) -> list[Label]:
    """The labels worth a try, by rank: of points that lie close together only the first."""
    firsts: dict[tuple[int, int], Label] = {}
    for label in sorted(labels, key=lambda label: -label.rank):
        firsts.setdefault((int(label.at[0]) // APART[0], int(label.at[1]) // APART[1]), label)
    return list(firsts.values())[:MOST_TRIED]


def _places(label: Label) -> Iterable[tuple[Vec, Anchor]]:
    """Right of the point, left of it, above and below; only where it is if it has no gap."""
    if label.gap == 0.0:
        return ((label.at, label.anchor),)
    (x, y), gap = label.at, label.gap
    rise = gap + 0.5 * label.size
    return ((x + gap, y), "left"), ((x - gap, y), "right"), ((x, y - rise), "middle"), ((x, y + rise), "middle")


def _box(at: Vec, anchor: Anchor, label: Label) -> Box:
    """About what a label covers if it stands there."""
    width = LETTER * label.size * len(label.text)
    left = at[0] - _BEFORE[anchor] * width
    return left, at[1] - 0.62 * label.size, left + width, at[1] + 0.62 * label.size


def _within(box: Box, size: Size) -> bool:
    return box[0] >= 0.0 and box[1] >= 0.0 and box[2] <= size[0] and box[3] <= size[1]


def _cells(box: Box) -> tuple[slice, slice]:
    """The rows and columns of the raster that a box covers."""
    left, top, right, bottom = (max(int(side) // CELL, 0) for side in box)
    return slice(top, bottom + 1), slice(left, right + 1)
