"""Words on a picture, and where they find room: no label covers another."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from sandbox.render.camera import Size, Vec
from sandbox.render.theme import Color

Box = tuple[float, float, float, float]
"""Left, top, right and bottom in pixels."""
Anchor = Literal["left", "middle", "right"]

LETTER = 0.56
"""Mean width of a letter, in parts of the size of the text."""
MOST_LABELS, MOST_TRIED = 300, 1200
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
        width = LETTER * self.size * len(self.text)
        left = self.at[0] - {"left": 0.0, "middle": 0.5, "right": 1.0}[self.anchor] * width
        return left, self.at[1] - 0.62 * self.size, left + width, self.at[1] + 0.62 * self.size


def place_labels(
    labels: Sequence[Label], size: Size, taken: Sequence[Box] = (), most: int = MOST_LABELS
) -> tuple[Label, ...]:
    """Those labels that find room in a picture of `size` pixels, each where it has room; at most `most`.

    None comes to lie in the boxes that are `taken`.
    """
    booked = {cell for box in taken for cell in _cells(box)}
    placed: list[Label] = []
    for label in _spread(labels):
        for candidate in _places(label):
            cells = _cells(candidate.box)
            if _within(candidate.box, size) and booked.isdisjoint(cells):
                booked.update(cells)
                placed.append(candidate)
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


def _places(label: Label) -> Iterable[Label]:
    """Right of the point, left of it, above and below; only where it is if it has no gap."""
    if label.gap == 0.0:
        return (label,)
    (x, y), gap = label.at, label.gap
    rise = gap + 0.5 * label.size
    return (
        replace(label, at=(x + gap, y), anchor="left", gap=0.0),
        replace(label, at=(x - gap, y), anchor="right", gap=0.0),
        replace(label, at=(x, y - rise), anchor="middle", gap=0.0),
        replace(label, at=(x, y + rise), anchor="middle", gap=0.0),
    )


def _within(box: Box, size: Size) -> bool:
    return box[0] >= 0.0 and box[1] >= 0.0 and box[2] <= size[0] and box[3] <= size[1]


def _cells(box: Box) -> list[tuple[int, int]]:
    """The cells of the raster that a box covers."""
    left, top, right, bottom = (int(side) // CELL for side in box)
    return [(column, row) for row in range(top, bottom + 1) for column in range(left, right + 1)]
