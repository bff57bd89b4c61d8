"""When two shapes that move and turn meet, by looking everywhere on their way.

The separation is the greatest gap along any direction: one of a side of either core, or from a vertex to another. It
changes no faster than by the way and the rims of the turning shapes. So an interval of the way may be passed over if
the separation in its middle is farther from a level than half of it could bring; all others are halved.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tests.naive import convex

Array = np.ndarray
Core = Sequence[tuple[float, float]]
MOST = 500


class TooCloseError(Exception):
    """The separation runs along the level for so long that looking everywhere takes too long."""


@dataclass(frozen=True)
class Mover:
    """A rounded core about its body's centre, and the straight way of that in the time from 0 to 1."""

    core: Core
    radius: float
    center: tuple[float, float]
    way: tuple[float, float] = (0.0, 0.0)
    angle: float = 0.0
    turn: float = 0.0

    def at(self, t: Array) -> Array:
        """Its core in the world at some times: (time, vertex, coordinate)."""
        c, s = np.cos(self.angle + t * self.turn)[:, None], np.sin(self.angle + t * self.turn)[:, None]
        u, v = np.array(self.core, float).T
        x, y = (self.center[i] + t[:, None] * self.way[i] for i in range(2))
        return np.stack([x + c * u - s * v, y + s * u + c * v], axis=2)

    def rim(self) -> float:
        """Way of its outermost core point around its centre."""
        return abs(self.turn) * max(math.hypot(u, v) for u, v in self.core)


@dataclass(frozen=True)
class Meeting:
    """Two of them."""

    a: Mover
    b: Mover

    def exact_separation(self, t: float) -> float:
        """Signed separation (m) at time t, in exact arithmetic."""
        first, second = (convex.exact(each.at(np.array([t]))[0].tolist()) for each in (self.a, self.b))
        return convex.separation(first, second) - self.a.radius - self.b.radius

    def separations(self, t: Array) -> Array:
        """Signed separations (m) at some times."""
        return greatest_gaps(self.a.at(t), self.b.at(t)) - self.a.radius - self.b.radius

    def separation(self, t: float) -> float:
        """Signed separation (m) at time t."""
        return float(self.separations(np.array([t]))[0])

    def fastest(self) -> float:
        """No faster (m in all) does the separation change."""
        way = math.hypot(self.b.way[0] - self.a.way[0], self.b.way[1] - self.a.way[1])
        return way + self.a.rim() + self.b.rim()

    def first_below(self, level: float, fine: float) -> float | None:
        """First time at which the separation is below a level, to within `fine` m of it; None if that is never.

        Raises `TooCloseError`.
        """
        starts, width, fastest = np.zeros(1), 1.0, self.fastest()
        while len(starts):
            gaps = self.separations(starts + 0.5 * width)
            starts = starts[gaps - 0.5 * fastest * width <= level]
            if fastest * width <= fine:
                break
            width *= 0.5
            starts = np.stack([starts, starts + width], axis=1).ravel()
            if len(starts) > MOST:
                raise TooCloseError
        return float(starts[0]) if len(starts) else None


def greatest_gaps(a: Array, b: Array) -> Array:
    """Signed separations of two cores at some times: (time, vertex, coordinate) of both."""
    found = np.full(len(a), -np.inf)
    for x, y in _directions(a, b):
        length = np.hypot(x, y)
        with np.errstate(invalid="ignore"):
            reach_a, reach_b = (x[:, None] * core[:, :, 0] + y[:, None] * core[:, :, 1] for core in (a, b))
            gap = np.where(length > 0.0, (reach_b.min(axis=1) - reach_a.max(axis=1)) / length, -np.inf)
        found = np.maximum(found, gap)
    return np.where(found > -np.inf, found, 0.0)


def _directions(a: Array, b: Array) -> list[tuple[Array, Array]]:
    """Where the greatest gap may be: across the sides of both, and from each vertex of a to each of b."""
    found = [(q[0], q[1]) for q in (b[:, j].T - a[:, i].T for i in range(a.shape[1]) for j in range(b.shape[1]))]
    for core in (a, b):
        side = np.roll(core, -1, axis=1) - core
        for x, y in (side[:, i].T for i in range(core.shape[1])):
            found += [(y, -x), (-y, x)]
    return found
