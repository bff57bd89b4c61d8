"""Of two groups of shapes, the two that matter."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

from sandbox.geometry.collide import collide, distance
from sandbox.geometry.shape import Shape


def nearest_pair(shapes_a: Sequence[Shape], shapes_b: Sequence[Shape]) -> tuple[int, int]:
    """The numbers, from 0, of the deepest pair; if none overlaps, of the nearest; of the first of equals."""
    pairs = list(product(range(len(shapes_a)), range(len(shapes_b))))
    if len(pairs) == 1:
        return pairs[0]
    return min(pairs, key=lambda pair: _apart(shapes_a[pair[0]], shapes_b[pair[1]]))


def _apart(a: Shape, b: Shape) -> float:
    """Distance, or minus the depth (m)."""
    contact = collide(a, b)
    return distance(a, b).value if contact is None else -contact.depth
