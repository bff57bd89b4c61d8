"""Of two groups of shapes, the two that matter."""

from __future__ import annotations

from collections.abc import Sequence

from sandbox.geometry.collide import collide, distance
from sandbox.geometry.shape import Shape
from sandbox.geometry.shape_box import box_gap, box_of


def nearest_pair(shapes_a: Sequence[Shape], shapes_b: Sequence[Shape]) -> tuple[int, int]:
    """The numbers, from 0, of the deepest pair; if none overlaps, of the nearest; of the first of equals.

    Pairs whose boxes are farther apart than two shapes already seen are passed over.
    """
    if len(shapes_a) == len(shapes_b) == 1:
        return 0, 0
    boxes = [box_of(shape) for shape in shapes_a], [box_of(shape) for shape in shapes_b]
    pairs = [(box_gap(p, q), i, j) for i, p in enumerate(boxes[0]) for j, q in enumerate(boxes[1])]
    _, i, j = min(pairs)
    best = _apart(shapes_a[i], shapes_b[j]), i, j
    for gap, i, j in sorted(pairs)[1:]:
        if gap > max(best[0], 0.0):
            break
        best = min(best, (_apart(shapes_a[i], shapes_b[j]), i, j))
    return best[1:]


def _apart(a: Shape, b: Shape) -> float:
    """Distance, or minus the depth (m)."""
    contact = collide(a, b)
    return distance(a, b).value if contact is None else -contact.depth
