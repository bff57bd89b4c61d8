"""All overlapping pairs by looking at every pair of boxes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Box:
    """One shape's bounds in metres, its body, whether it moves, and its collision filter."""

    lower: tuple[float, float]
    upper: tuple[float, float]
    body: int
    moves: bool = True
    category: int = 1
    mask: int = 0xFFFFFFFF
    group: int = 0


def may_meet(a: Box, b: Box) -> bool:
    """A common group decides: positive always, negative never. Otherwise each has to be in the other's mask."""
    if a.group != 0 and a.group == b.group:
        return a.group > 0
    return bool(a.category & b.mask) and bool(b.category & a.mask)


def all_pairs(boxes: list[Box]) -> list[tuple[int, int]]:
    """Sorted pairs (i, j), i < j, of boxes that share a point, of two bodies of which one moves, and that may meet."""
    if not boxes:
        return []
    lower = np.array([box.lower for box in boxes])
    upper = np.array([box.upper for box in boxes])
    pairs = []
    for i, box in enumerate(boxes):
        meets = (lower[i + 1 :] <= upper[i]).all(axis=1) & (upper[i + 1 :] >= lower[i]).all(axis=1)
        for j in np.flatnonzero(meets) + i + 1:
            other = boxes[j]
            if box.body != other.body and (box.moves or other.moves) and may_meet(box, other):
                pairs.append((i, int(j)))
    return pairs
