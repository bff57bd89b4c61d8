"""What every shape is to the tests: a convex core and a radius around it, and how its author numbered the edges."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, field
from math import dist
from typing import Protocol, Self

Vec = tuple[float, float]


class Core(Protocol):
    """What the tests ask of a shape: vertices counter-clockwise and the radius around them, metres."""

    @property
    def vertices(self) -> tuple[Vec, ...]:
        """1 point, 2 points or the corners of a polygon."""

    @property
    def radius(self) -> float:
        """Rounding, m."""


@dataclass(frozen=True)
class Shape(ABC):
    """What all shapes have in common; make one of its kinds: Circle, Capsule, Segment, Polygon or Box.

    `vertices` is the core the separating-axis test works on: 1 point, 2 points, or 3..64 corners counter-clockwise,
    no three of them in line. `radius` (m) rounds it. `given` are the vertices as the author numbered them, and
    `edge_numbers[i]` is the author's number, from 0, of the core's edge from vertex i to the next: edge k runs between
    `given[k]` and the one after it. A line has two sides and one edge: both sides have number 0.
    """

    vertices: tuple[Vec, ...] = field(init=False, repr=False, compare=False)
    given: tuple[Vec, ...] = field(init=False, repr=False, compare=False)
    edge_numbers: tuple[int, ...] = field(init=False, repr=False, compare=False)

    radius = 0.0

    def _set(self, **values: object) -> None:
        """Fill in fields while the value is being made."""
        for name, value in values.items():
            object.__setattr__(self, name, value)

    @abstractmethod
    def moved(self, translation: Sequence[float]) -> Self:
        """The same shape moved by `translation` (x, y) in metres; coordinates are rounded to the nearest floats."""


def edge_numbers(given: tuple[Vec, ...], corners: tuple[int, ...]) -> tuple[int, ...]:
    """The author's number of each edge of the core: of its longest part where the author broke it up."""
    count = len(corners)
    ends = [(corners[i], corners[(i + 1) % count]) for i in range(count)]
    backwards = sum(start > end for start, end in ends) > 1
    return tuple(_longest_part(given, *(pair[::-1] if backwards else pair)) for pair in ends)


def _longest_part(given: tuple[Vec, ...], start: int, end: int) -> int:
    """The longest edge on the way from vertex `start` to vertex `end`; the first one of equals."""
    count = len(given)
    parts = [(start + k) % count for k in range((end - start) % count)]
    return max(parts, key=lambda k: dist(given[k], given[(k + 1) % count]))
