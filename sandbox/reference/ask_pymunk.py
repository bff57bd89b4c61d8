"""What pymunk says of two shapes where they lie, asked so that none of its known traps falsifies the answer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pymunk

from sandbox.reference.pair import Core, Pair
from sandbox.reference.poses import Poses
from sandbox.tables import Floats, Integers

PYMUNK_VERSION: str = pymunk.version


@dataclass(frozen=True)
class Answers:
    """One row a pair. `hit`; `depth` (m) of the deepest point; `normal` (n, 2) from a to b, (0, 0) where none came."""

    hit: np.ndarray[Any, np.dtype[np.bool_]]
    depth: Floats
    normal: Floats


class Probe:
    """All shapes of a world as pymunk shapes outside of any space, to be put where the world has them."""

    def __init__(self, poses: Poses, vertices: Any) -> None:
        self._shapes = poses.shapes
        self._bodies = [pymunk.Body(body_type=pymunk.Body.KINEMATIC) for _ in poses.bodies]
        self._probes = [self._probe(row, vertices) for row in poses.shapes]
        self._owners: Integers = np.array(poses.shapes.body)
        self._ranks = [min(int(count), 3) for count in poses.shapes.vertex_count]
        self._placed = np.full((len(poses.bodies), 3), np.nan)

    def _probe(self, row: Any, vertices: Any) -> Any:
        rows = vertices[row.vertex_start : row.vertex_start + row.vertex_count]
        points = tuple((float(x), float(y)) for x, y in zip(rows.x, rows.y, strict=True))
        return shape_of(self._bodies[row.body], Core(points, float(row.radius)))

    def ask(self, poses: Poses, pairs: Integers) -> Answers:
        """What pymunk says of `pairs` (n, 2) of shapes at these poses."""
        self._place(poses, np.unique(pairs))
        hit = np.zeros(len(pairs), np.bool_)
        depth, normal = np.zeros(len(pairs)), np.zeros((len(pairs), 2))
        for k, (a, b) in enumerate(pairs.tolist()):
            answer = self._ask_one(a, b)
            if answer is not None:
                hit[k], depth[k], normal[k] = True, answer[0], answer[1]
        return Answers(hit, depth, normal)

    def _ask_one(self, a: int, b: int) -> tuple[float, tuple[float, float]] | None:
        if self._ranks[a] <= self._ranks[b]:
            return collide(self._probes[a], self._probes[b])
        answer = collide(self._probes[b], self._probes[a])
        return None if answer is None else (answer[0], (-answer[1][0], -answer[1][1]))

    def _place(self, poses: Poses, shapes: Integers) -> None:
        """Put the bodies of these shapes where they are, if they are not there yet.

        `cache_bb` turns a shape: without it pymunk would answer for the pose before.
        """
        bodies = poses.bodies
        wanted = np.stack([bodies.center_x, bodies.center_y, bodies.angle], axis=1)
        asked = np.zeros(len(wanted), np.bool_)
        asked[self._owners[shapes]] = True
        moved = asked & (wanted != self._placed).any(axis=1)
        for k in np.flatnonzero(moved):
            x, y, angle = wanted[k].tolist()
            self._bodies[k].position, self._bodies[k].angle = (x, y), angle
        for k in np.flatnonzero(moved[self._owners]):
            self._probes[k].cache_bb()
        self._placed[moved] = wanted[moved]


def shape_of(body: pymunk.Body, core: Core) -> Any:
    """A core as a pymunk shape of `body`."""
    if core.kind == "circle":
        return pymunk.Circle(body, core.radius, core.points[0])
    if core.kind == "segment":
        start, end = core.points
        return pymunk.Segment(body, start, end, core.radius)
    return pymunk.Poly(body, core.points, radius=core.radius)


def collide(a: Any, b: Any) -> tuple[float, tuple[float, float]] | None:
    """(depth of the deepest point in m, normal from a to b), or None for shapes that pymunk calls separated.

    Circles have to come before segments, and both before polygons; their transforms have to be up to date.
    """
    try:
        points = a.shapes_collide(b)
    except AssertionError:  # pymunk's way of saying that there are no points
        return None
    return max(-point.distance for point in points.points), (points.normal.x, points.normal.y)


def ask_pair(pair: Pair) -> tuple[float, tuple[float, float]] | None:
    """`collide` for two shapes at their places, in the order given."""
    shapes = []
    for core, center in ((pair.a, pair.center_a), (pair.b, pair.center_b)):
        body = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
        body.position = center
        shapes.append(shape_of(body, core))
        shapes[-1].cache_bb()
    ranks = [min(len(core.points), 3) for core in (pair.a, pair.b)]
    if ranks[0] <= ranks[1]:
        return collide(*shapes)
    answer = collide(*shapes[::-1])
    return None if answer is None else (answer[0], (-answer[1][0], -answer[1][1]))
