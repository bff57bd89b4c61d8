"""What concave polygons look like: one outline with holes, and convex parts to fill it with."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from sandbox.render.camera import Floats
from sandbox.tables import Records


@dataclass(frozen=True)
class Outline:
    """A concave polygon in metres.

    `sides` (k, 2, 2) are start and end of each side, the inside on the left, ring after ring; `parts` are convex
    polygons (n, 2), counter-clockwise, that fill it; some of their corners may be straight. `thickness` is half the
    smallest width of its largest part, and `middle` (2,) lies well within that part.
    """

    sides: Floats
    parts: tuple[Floats, ...]
    middle: Floats
    thickness: float

    def centred(self) -> Outline:
        """The same about its middle."""
        parts = tuple(part - self.middle for part in self.parts)
        return replace(self, sides=self.sides - self.middle, parts=parts, middle=np.zeros(2))

    def distance(self, point: Floats) -> float:
        """Signed distance (m) of `point` (2,) from the polygon; negative inside."""
        a, b = self.sides[:, 0], self.sides[:, 1]
        along, to = b - a, point - a
        share = np.clip((to * along).sum(axis=1) / np.maximum((along * along).sum(axis=1), 1e-300), 0.0, 1.0)
        off = to - along * share[:, None]
        distance = float(np.hypot(off[:, 0], off[:, 1]).min())
        rises = (a[:, 1] <= point[1]) != (b[:, 1] <= point[1])
        turn = along[:, 0] * to[:, 1] - along[:, 1] * to[:, 0]
        crossed = rises & ((turn > 0.0) == (along[:, 1] > 0.0))
        return -distance if crossed.sum() % 2 else distance

    def strips(self, width: float) -> list[Floats]:
        """A polygon along each side, `width` metres to the inside: together they are the outline, round at dents."""
        edge = self.sides[:, 1] - self.sides[:, 0]
        normal = np.column_stack([-edge[:, 1], edge[:, 0]]) / np.hypot(edge[:, 0], edge[:, 1])[:, None]
        before = self._before()
        joint = normal + normal[before]
        squared = np.maximum((joint * joint).sum(axis=1), 0.4)
        dented = edge[before, 0] * edge[:, 1] - edge[before, 1] * edge[:, 0] < 0.0
        reach = np.where(dented, 1.0 / np.sqrt(squared), 2.0 / squared)
        inner = self.sides[:, 0] + width * joint * reach[:, None]
        strips = []
        for k, after in enumerate(np.argsort(before)):
            own = self.sides[k] + width * normal[k]
            end = [inner[after], own[1]] if dented[after] else [inner[after]]
            strips.append(np.array([*self.sides[k], *end, *([own[0], inner[k]] if dented[k] else [inner[k]])]))
        return strips

    def _before(self) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
        """For each side the one before it in its ring."""
        before = np.arange(len(self.sides)) - 1
        first = 0
        for k, side in enumerate(self.sides):
            if k + 1 == len(self.sides) or (side[1] != self.sides[k + 1, 0]).any():
                before[first] = k
                first = k + 1
        return before


def read_outline(shapes: Records, vertices: Records, outlines: Records, first: int) -> Outline:
    """The concave polygon whose first part is the shape `first`, in its body's frame."""
    row = shapes[first]
    sides: Any = outlines[row.outline_start : row.outline_start + row.outline_count]
    ends = np.column_stack([sides.start_x, sides.start_y, sides.end_x, sides.end_y]).reshape(-1, 2, 2)
    parts = [_core(shapes[first], vertices)]
    while first + len(parts) < len(shapes) and shapes[first + len(parts)].part == len(parts) + 1:
        parts.append(_core(shapes[first + len(parts)], vertices))
    largest = max(parts, key=_area)
    whole = tuple(_with_straight(part, ends[:, 0]) for part in parts)
    return Outline(ends, whole, largest.mean(axis=0), half_width(largest))


def _with_straight(core: Floats, corners: Floats) -> Floats:
    """A part with the corners of the whole that lie on its sides, so that no gap opens when pixels are rounded."""
    points: list[Floats] = []
    for a, b in zip(core, np.roll(core, -1, axis=0), strict=True):
        (u, v), to = b - a, corners - a
        length = u * u + v * v
        share = (to[:, 0] * u + to[:, 1] * v) / length
        off = np.abs(to[:, 1] * u - to[:, 0] * v) / length
        on = np.flatnonzero((share > 1e-7) & (share < 1.0 - 1e-7) & (off < 1e-7))
        points += [a, *corners[on[np.argsort(share[on])]]]
    return np.array(points)


def _core(row: Records, vertices: Records) -> Floats:
    rows: Any = vertices[row.vertex_start : row.vertex_start + row.vertex_count]
    return np.column_stack([rows.x, rows.y])


def _area(core: Floats) -> float:
    after = np.roll(core, -1, axis=0)
    return float((core[:, 0] * after[:, 1] - core[:, 1] * after[:, 0]).sum())


def half_width(core: Floats) -> float:
    """Half the smallest width of a convex polygon (n, 2), counter-clockwise."""
    edge = np.roll(core, -1, axis=0) - core
    normal = np.column_stack([-edge[:, 1], edge[:, 0]]) / np.maximum(np.hypot(*edge.T), 1e-300)[:, None]
    heights = normal @ core.T - (normal * core).sum(axis=1)[:, None]
    return float(heights.max(axis=1).min() / 2)
