"""What shows of static tiles that abut, tile by tile, edge by edge, corner by corner: the judge of `world/flush.py`.

Plain numbers and loops over all other tiles; every formula has its operations in the order of the tables' own, so that
the rows come out the same to the bit.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

Vec = tuple[float, float]
NEAR, OUT = 1e-6, 3e-6
WHOLE, NOWHERE = (0.0, 1.0), (1.0, 0.0)


@dataclass(frozen=True)
class Tile:
    """A static polygon in the world: corners, normals of the edges from each on, filters, whether it is by itself."""

    corners: tuple[Vec, ...]
    normals: tuple[Vec, ...]
    filters: tuple[int, int, int]
    alone: bool

    def height(self, point: Vec, k: int) -> float:
        """How far a point is outside of the line of edge k."""
        (x, y), (nx, ny) = self.corners[k], self.normals[k]
        return (point[0] - x) * nx + (point[1] - y) * ny

    def heights(self, point: Vec) -> list[float]:
        """The same for all edges."""
        return [self.height(point, k) for k in range(len(self.corners))]


@dataclass(frozen=True)
class Seams:
    """What shows of a tile: stretches of its edges, and the normals of the sides before and after each corner."""

    shown: list[Vec]
    sides: list[tuple[Vec, Vec]]


def read_tiles(state: Any) -> dict[int, Tile]:
    """All tiles of a state by the rows of their shapes."""
    tiles = {}
    for row, shape in enumerate(state.shapes):
        body = state.bodies[int(shape.body)]
        solid = body.type == 0 and body.frozen_step < 0 and not shape.traits & 2
        if not solid or shape.vertex_count < 3 or shape.radius > 0.0:
            continue
        rows = state.vertices[shape.vertex_start : shape.vertex_start + shape.vertex_count]
        c, s = float(body.rotation_cos), float(body.rotation_sin)
        tiles[row] = Tile(
            tuple((body.center_x + (c * v.x - s * v.y), body.center_y + (s * v.x + c * v.y)) for v in rows),
            tuple((c * v.normal_x - s * v.normal_y, s * v.normal_x + c * v.normal_y) for v in rows),
            (int(shape.category), int(shape.mask), int(shape.group)),
            bool(shape.part == 0),
        )
    return tiles


def seams(tiles: dict[int, Tile], row: int) -> Seams | None:
    """What the tile in that row has of the whole; None if nothing of it is covered."""
    tile = tiles[row]
    if not tile.alone or sum(each.alone for each in tiles.values()) < 2:
        return None
    others = [each for other, each in tiles.items() if other != row and each.filters == tile.filters]
    others = [other for other in others if _boxes_meet(tile, other)]
    if not others:
        return None
    numbers = range(len(tile.corners))
    shown = [_shown(tile, k, others) for k in numbers]
    sides = [_sides(tile, k, shown, others) for k in numbers]
    own = [(tile.normals[k - 1], tile.normals[k]) for k in numbers]
    return None if all(each == WHOLE for each in shown) and sides == own else Seams(shown, sides)


def _boxes_meet(one: Tile, two: Tile) -> bool:
    return all(
        min(c[k] for c in a.corners) - NEAR <= max(c[k] for c in b.corners) + NEAR
        for k in (0, 1)
        for a, b in ((one, two), (two, one))
    )


def _shown(tile: Tile, k: int, others: list[Tile]) -> Vec:
    """The stretch of an edge that shows."""
    start, end, normal = tile.corners[k], tile.corners[(k + 1) % len(tile.corners)], tile.normals[k]
    out = OUT * normal[0], OUT * normal[1]
    edge = (start[0] + out[0], start[1] + out[1]), (end[0] + out[0], end[1] + out[1])
    near = 2.0 * NEAR / _length(start, end)
    first, last = WHOLE
    covers = sorted(_covered(*edge, other) for other in others)
    for a, b in covers:
        if a <= first + near and b > first:
            first = b
    for a, b in sorted(covers, key=lambda cover: -cover[1]):
        if b >= last - near and a < last:
            last = a
    first = 0.0 if first <= near else first
    last = 1.0 if last >= 1.0 - near else last
    return (first, last) if last - first > near else NOWHERE


def _covered(start: Vec, end: Vec, other: Tile) -> Vec:
    """From where to where an edge runs within another tile."""
    first, last = WHOLE
    for k, (nx, ny) in enumerate(other.normals):
        height = other.height(start, k) - NEAR
        rise = (end[0] - start[0]) * nx + (end[1] - start[1]) * ny
        if abs(rise) <= 1e-12 * abs(height) or rise == 0.0:
            if height > 0.0:
                return NOWHERE
        elif rise > 0.0:
            last = min(last, -height / rise)
        else:
            first = max(first, -height / rise)
    return (first, last) if first < last else NOWHERE


def _sides(tile: Tile, k: int, shown: list[Vec], others: list[Tile]) -> tuple[Vec, Vec]:
    """The normals of the sides of the whole that end and begin in a corner."""
    point = tile.corners[k]
    before: Vec | None = tile.normals[k - 1] if shown[k - 1][1] == 1.0 else None
    after: Vec | None = tile.normals[k] if shown[k][0] == 0.0 and shown[k][1] > 0.0 else None
    if before and after:
        return before, after
    if any(max(other.heights(point)) < -NEAR for other in others):
        return (0.0, 0.0), (0.0, 0.0)
    for other in others:
        if max(other.heights(point)) <= NEAR:
            arriving, leaving = _through(other, point)
            rest = [tile, *(each for each in others if each is not other)]
            if not before and _is_free(point, arriving, -1.0, rest):
                before = arriving
            if not after and _is_free(point, leaving, 1.0, rest):
                after = leaving
    return before or after or (0.0, 0.0), after or before or (0.0, 0.0)


def _through(other: Tile, point: Vec) -> tuple[Vec, Vec]:
    """The normals of the edges that arrive at a point on a tile's outline and leave it."""
    for k, corner in enumerate(other.corners):
        if _length(corner, point) <= 2.0 * NEAR:
            return other.normals[k - 1], other.normals[k]
    heights = other.heights(point)
    normal = other.normals[heights.index(max(heights))]
    return normal, normal


def _is_free(point: Vec, normal: Vec, ahead: float, tiles: list[Tile]) -> bool:
    """Whether just ahead of a point, or behind it, no tile is in the way of an edge with that normal."""
    step = 4.0 * OUT * ahead
    probe = point[0] + step * -normal[1] + OUT * normal[0], point[1] + step * normal[0] + OUT * normal[1]
    return all(max(tile.heights(probe)) > NEAR for tile in tiles)


def _length(one: Vec, two: Vec) -> float:
    x, y = two[0] - one[0], two[1] - one[1]
    return math.sqrt(x * x + y * y)
