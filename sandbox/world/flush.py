"""Static shapes that abut: which of their edges are covered by others, so that nothing catches on them.

A floor of boxes is one surface, but the separating-axis test sees one box at a time. For each static polygon this finds
the stretches of its edges that show and, where another one goes on from a corner, between which normals that corner
lies: rows of the seam table, as concave polygons and chains have them. They hold until a static body is moved.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from sandbox.tables import Floats, Integers, Records
from sandbox.world.records import ONE_WAY, SEAM, SEAMED, STATIC

_NEAR = 1e-6
"""What is this near, in metres, is flush."""
_OUT = 3e-6
"""How far outside of an edge it has to be solid to count as covered, in metres."""
_LONG = 64
_FIELDS = ("before_x", "before_y", "after_x", "after_y")


def with_room_for_tiles(bodies: Records, shapes: Records, seams: Records) -> Records:
    """The seam table with further rows for every static polygon that may come to abut another one."""
    tiles = find_tiles(bodies, shapes)
    tiles = tiles[(shapes.traits[tiles] & SEAMED) == 0]
    if len(tiles) < 2:
        return seams
    counts = shapes.vertex_count[tiles]
    shapes.seam_start[tiles] = len(seams) + np.cumsum(counts) - counts
    rows = SEAM.zeros(len(seams) + int(counts.sum()))
    rows[: len(seams)] = seams
    return rows


def join_tiles(bodies: Records, shapes: Records, vertices: Records, seams: Records) -> None:
    """Find out anew which static polygons abut, and write it into the seam table and the traits of the shapes."""
    tiles = find_tiles(bodies, shapes)
    own = tiles[shapes.part[tiles] == 0]
    shapes.traits[own] &= ~SEAMED
    if len(own) < 2:
        return
    world = _World(bodies, shapes, vertices, tiles)
    one, two = _neighbours(world, own)
    keep = np.isin(one, own)
    one, two = one[keep], two[keep]
    if len(one) == 0:
        return
    order = np.lexsort((two, one))
    found, first = np.unique(one[order], return_index=True)
    for tile, others in zip(found.tolist(), np.split(two[order], first[1:]), strict=True):
        _join(world, seams, tile, others.tolist())


def find_tiles(bodies: Records, shapes: Records) -> Integers:
    """Static polygons with sharp corners that are solid from all sides."""
    static = (bodies.type[shapes.body] == STATIC) & (bodies.frozen_step[shapes.body] < 0)
    sharp = (shapes.vertex_count >= 3) & (shapes.radius == 0.0) & ((shapes.traits & ONE_WAY) == 0)
    return np.flatnonzero(static & sharp)


class _World:
    """Corners, normals and boxes of the tiles in world coordinates."""

    def __init__(self, bodies: Records, shapes: Records, vertices: Records, tiles: Integers) -> None:
        self.bodies, self.shapes, self.tiles = bodies, shapes, tiles
        of = np.repeat(shapes.body, shapes.vertex_count)
        cos, sin = bodies.rotation_cos[of], bodies.rotation_sin[of]
        x, y = vertices.x, vertices.y
        # No matrix product: what that rounds differs from machine to machine.
        self._x = bodies.center_x[of] + (cos * x - sin * y)
        self._y = bodies.center_y[of] + (sin * x + cos * y)
        self._normal_x = cos * vertices.normal_x - sin * vertices.normal_y
        self._normal_y = sin * vertices.normal_x + cos * vertices.normal_y
        starts = shapes.vertex_start
        self._starts, self._counts = starts.tolist(), shapes.vertex_count.tolist()
        self._outlines: dict[int, tuple[Floats, Floats]] = {}
        self.lower = np.stack([np.minimum.reduceat(each, starts) for each in (self._x, self._y)], axis=1)[tiles]
        self.upper = np.stack([np.maximum.reduceat(each, starts) for each in (self._x, self._y)], axis=1)[tiles]

    def corners(self, i: int) -> Floats:
        """(n, 2) of a tile, m."""
        return self._outline(i)[0]

    def normals(self, i: int) -> Floats:
        """(n, 2) of a tile's edges."""
        return self._outline(i)[1]

    def _outline(self, i: int) -> tuple[Floats, Floats]:
        if i not in self._outlines:
            rows = slice(self._starts[i], self._starts[i] + self._counts[i])
            corners = np.stack([self._x[rows], self._y[rows]], axis=1)
            self._outlines[i] = corners, np.stack([self._normal_x[rows], self._normal_y[rows]], axis=1)
        return self._outlines[i]

    def depth(self, i: int, point: Floats) -> float:
        """How far a point lies within a tile; negative outside."""
        corners, normals = self._outline(i)
        return -float(((point - corners) * normals).sum(axis=1).max())

    def covered(self, edge: tuple[Floats, Floats], i: int) -> tuple[float, float]:
        """From where to where, as shares of its length, an edge runs within a tile; from 1 to 0 if nowhere."""
        start, end = edge
        corners, normals = self._outline(i)
        at = ((start - corners) * normals).sum(axis=1) - _NEAR
        slope = ((end - start) * normals).sum(axis=1)
        first, last = 0.0, 1.0
        for height, rise in zip(at.tolist(), slope.tolist(), strict=True):
            if abs(rise) <= 1e-12 * abs(height) or rise == 0.0:
                if height > 0.0:
                    return 1.0, 0.0
            elif rise > 0.0:
                last = min(last, -height / rise)
            else:
                first = max(first, -height / rise)
        return (first, last) if first < last else (1.0, 0.0)


def _neighbours(world: _World, own: Integers) -> tuple[Integers, Integers]:
    """Pairs (both ways round) of tiles whose boxes meet and that collide with the same things: a sweep along x."""
    order = np.argsort(world.lower[:, 0], kind="stable")
    lower, upper = world.lower[order] - _NEAR, world.upper[order] + _NEAR
    ends = np.searchsorted(lower[:, 0], upper[:, 0], side="right")
    ones: list[Integers] = []
    twos: list[Integers] = []
    for first in range(0, len(order), _LONG):
        rows = np.arange(first, min(first + _LONG, len(order)))
        counts = np.maximum(ends[rows] - rows - 1, 0)
        one = np.repeat(rows, counts)
        two = one + 1 + np.arange(len(one)) - np.repeat(np.cumsum(counts) - counts, counts)
        meet = (lower[one, 1] <= upper[two, 1]) & (lower[two, 1] <= upper[one, 1])
        ones.append(world.tiles[order[one[meet]]])
        twos.append(world.tiles[order[two[meet]]])
    one, two = np.concatenate(ones), np.concatenate(twos)
    shapes = world.shapes
    alike: NDArray[np.bool_] = shapes.category[one] == shapes.category[two]
    alike &= (shapes.mask[one] == shapes.mask[two]) & (shapes.group[one] == shapes.group[two])
    one, two = one[alike], two[alike]
    return np.concatenate([one, two]), np.concatenate([two, one])


def _join(world: _World, seams: Records, tile: int, others: list[int]) -> None:
    """Fill in the rows of one tile, if any of its edges or corners is covered."""
    corners, normals = world.corners(tile), world.normals(tile)
    shown = [
        _shown(world, corners[k], corners[(k + 1) % len(corners)], normals[k], others) for k in range(len(corners))
    ]
    sides = [_sides(world, tile, k, shown, others) for k in range(len(corners))]
    whole = all(each == (0.0, 1.0) for each in shown)
    if whole and all(
        (pair[0] == normals[k - 1]).all() and (pair[1] == normals[k]).all() for k, pair in enumerate(sides)
    ):
        return
    shape = world.shapes[tile]
    body = world.bodies[shape.body]
    shape.traits |= SEAMED
    for k, (before, after) in enumerate(sides):
        row = seams[shape.seam_start + k]
        for name, value in zip(_FIELDS, (*_local(body, before), *_local(body, after)), strict=True):
            row[name] = value
        row.shown_from, row.shown_to = shown[k]


def _local(body: Records, direction: Floats) -> tuple[float, float]:
    """A direction in the body's frame."""
    x, y = direction.tolist()
    return body.rotation_cos * x + body.rotation_sin * y, body.rotation_cos * y - body.rotation_sin * x


def _length(way: Floats) -> float:
    x, y = way.tolist()
    return math.sqrt(x * x + y * y)


def _shown(world: _World, start: Floats, end: Floats, normal: Floats, others: list[int]) -> tuple[float, float]:
    """From where to where an edge shows, as shares of its length: what is covered from its ends on is left off."""
    edge = start + _OUT * normal, end + _OUT * normal
    near = 2.0 * _NEAR / _length(end - start)
    first, last = 0.0, 1.0
    covers = sorted(world.covered(edge, i) for i in others)
    for a, b in covers:
        if a <= first + near and b > first:
            first = b
    for a, b in sorted(covers, key=lambda cover: -cover[1]):
        if b >= last - near and a < last:
            last = a
    first = 0.0 if first <= near else first
    last = 1.0 if last >= 1.0 - near else last
    return (first, last) if last - first > near else (1.0, 0.0)


def _sides(
    world: _World, tile: int, k: int, shown: list[tuple[float, float]], others: list[int]
) -> tuple[Floats, Floats]:
    """Normals of the sides of the whole that end and that begin in corner k of a tile; zeros within the whole."""
    point, normals = world.corners(tile)[k], world.normals(tile)
    ends_here, begins_here = shown[k - 1][1] == 1.0, shown[k][0] == 0.0 and shown[k][1] > 0.0
    before, after = normals[k - 1], normals[k]
    if ends_here and begins_here:
        return before, after
    for other in others:
        depth = world.depth(other, point)
        if depth > _NEAR:
            return np.zeros(2), np.zeros(2)
        if depth < -_NEAR:
            continue
        arriving, leaving = _through(world, other, point)
        if not ends_here and _is_free(world, point, arriving, -1.0, [tile, *others], other):
            before, ends_here = arriving, True
        if not begins_here and _is_free(world, point, leaving, 1.0, [tile, *others], other):
            after, begins_here = leaving, True
    if not ends_here:
        before = after if begins_here else np.zeros(2)
    if not begins_here:
        after = before if ends_here else np.zeros(2)
    return before, after


def _through(world: _World, i: int, point: Floats) -> tuple[Floats, Floats]:
    """Normals of the edges of a tile that arrive at and leave a point on its outline: the same one between corners."""
    corners, normals = world.corners(i), world.normals(i)
    for k, corner in enumerate(corners):
        if _length(corner - point) <= 2.0 * _NEAR:
            return normals[k - 1], normals[k]
    k = int((((point - corners) * normals).sum(axis=1)).argmax())
    return normals[k], normals[k]


def _is_free(world: _World, point: Floats, normal: Floats, ahead: float, tiles: list[int], own: int) -> bool:
    """Whether the edge with that normal shows just ahead of (1) or behind (-1) a point on it."""
    along = np.array([-normal[1], normal[0]])
    probe = point + 4.0 * _OUT * ahead * along + _OUT * normal
    return all(world.depth(i, probe) < -_NEAR for i in tiles if i != own)
