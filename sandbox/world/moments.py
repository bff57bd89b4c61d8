"""Moments and widths of many convex cores at once, to the bit those of `geometry.mass`, one core at a time.

Every formula stands here with the same operations in the same order; only the loop over corners is numpy's.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sandbox._jit import interpreted
from sandbox.geometry.trig import PI, arctan2
from sandbox.tables import Floats, Integers
from sandbox.world.runs import neighbours_in_rings, owners, run_starts

_arctan2 = interpreted(arctan2)
Columns = tuple[Floats, Floats, Floats, Floats]
"""Area (m^2), first moments (m^3) and polar second moment (m^4)."""


@dataclass(frozen=True)
class Cores:
    """Many cores: their corners one after the other (m), how many each has, and their radii (m).

    `normal_x`, `normal_y` are the outward unit normals of the edges from each corner on, (0, 0) for a single one.
    """

    counts: Integers
    x: Floats
    y: Floats
    radius: Floats
    normal_x: Floats
    normal_y: Floats

    @classmethod
    def of(cls, counts: Integers, x: Floats, y: Floats, radius: Floats) -> Cores:
        """With their normals."""
        _, after = neighbours_in_rings(counts)
        across, up = x[after] - x, y[after] - y
        length = np.sqrt(across * across + up * up)
        length[np.repeat(counts == 1, counts)] = 1.0
        return cls(counts, x, y, radius, up / length, (x - x[after]) / length)


def sums(values: Floats, owner: Integers, count: int) -> Floats:
    """The sum of each owner's values, added one by one in their order."""
    return np.asarray(np.bincount(owner, values, count), float)


def core_moments(cores: Cores) -> Columns:
    """Moments of each core, rounded by its radius, about its frame's origin."""
    before, after = neighbours_in_rings(cores.counts)
    pieces = zip(_triangles(cores, after), _strips(cores, after), _sectors(cores, before), strict=True)
    owner = np.repeat(owners(cores.counts), 3)
    columns = [sums(np.stack(each, axis=1).ravel(), owner, len(cores.counts)) for each in pieces]
    return columns[0], columns[1], columns[2], columns[3]


def _triangles(cores: Cores, after: Integers) -> Columns:
    """Triangles of the origin and each edge; signed."""
    px, py, qx, qy = cores.x, cores.y, cores.x[after], cores.y[after]
    twice = px * qy - py * qx
    twice[np.repeat(cores.counts < 3, cores.counts)] = 0.0
    square = px * px + px * qx + qx * qx + py * py + py * qy + qy * qy
    return twice / 2.0, twice * (px + qx) / 6.0, twice * (py + qy) / 6.0, twice * square / 12.0


def _strips(cores: Cores, after: Integers) -> Columns:
    """Rectangles of width `radius` outside each edge."""
    px, py, qx, qy = cores.x, cores.y, cores.x[after], cores.y[after]
    radius = np.repeat(cores.radius, cores.counts)
    squared = (qx - px) * (qx - px) + (qy - py) * (qy - py)
    area = np.sqrt(squared) * radius
    x = (px + qx) / 2.0 + cores.normal_x * radius / 2.0
    y = (py + qy) / 2.0 + cores.normal_y * radius / 2.0
    return area, area * x, area * y, area * (squared + radius * radius) / 12.0 + area * (x * x + y * y)


def _sectors(cores: Cores, before: Integers) -> Columns:
    """Disc sectors at each corner, between the normals of the edges before and after it."""
    radius = np.repeat(cores.radius, cores.counts)
    nx, ny, mx, my = cores.normal_x[before], cores.normal_y[before], cores.normal_x, cores.normal_y
    turn = _turns(cores, nx * my - ny * mx, nx * mx + ny * my)
    area = radius * radius * turn / 2.0
    cubed = radius * radius * radius / 3.0
    own_x, own_y = cubed * (my - ny), cubed * (nx - mx)
    x, y = cores.x, cores.y
    second = radius * radius * radius * radius * turn / 4.0
    second = second + 2.0 * (x * own_x + y * own_y) + area * (x * x + y * y)
    return area, own_x + area * x, own_y + area * y, second


def _turns(cores: Cores, cross: Floats, dot: Floats) -> Floats:
    """The angle of each sector; 0 where nothing is rounded, as it has no weight there."""
    turns = np.where(np.repeat(cores.counts == 1, cores.counts), 2.0 * PI, 0.0)
    rows = np.flatnonzero(np.repeat((cores.radius > 0.0) & (cores.counts > 1), cores.counts))
    angles = np.array([_arctan2(y, x) for y, x in zip(cross[rows].tolist(), dot[rows].tolist(), strict=True)], float)
    turns[rows] = np.where(angles >= 0.0, angles, angles + 2.0 * PI)
    return turns


def half_widths(cores: Cores) -> Floats:
    """Half the smallest width of each core in metres; 0 for one or two corners."""
    widths = np.zeros(len(cores.counts))
    starts = run_starts(cores.counts)
    for count in np.unique(cores.counts[cores.counts >= 3]).tolist():
        which = np.flatnonzero(cores.counts == count)
        rows = starts[which][:, None] + np.arange(count)
        x, y, nx, ny = cores.x[rows], cores.y[rows], cores.normal_x[rows], cores.normal_y[rows]
        across = [
            (nx[:, k, None] * (x[:, k, None] - x) + ny[:, k, None] * (y[:, k, None] - y)).max(axis=1)
            for k in range(count)
        ]
        widths[which] = 0.5 * np.min(across, axis=0)
    return widths
