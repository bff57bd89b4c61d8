"""What shows of tiles that abut, tile by tile, edge by edge, corner by corner: the judge of `world/flush.py`.

A line is a tile with the outline of its straight sides. Plain numbers and loops over all other tiles; every formula has
its operations in the order of the tables' own, so that the rows come out the same to the bit.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

Vec = tuple[float, float]
NEAR, OUT = 1e-6, 3e-6
WHOLE, NOWHERE = (0.0, 1.0), (1.0, 0.0)


Edge = tuple["Tile", int]
"""The edge of a tile from its corner of that number on."""


@dataclass(frozen=True, eq=False)
class Tile:
    """A polygon or a line: corners, normals of the edges from each on, filters, and what it is a part of: a body that
    moves, or -1 for all that is static. Whether it is by itself: no part of a concave polygon or chain."""

    corners: tuple[Vec, ...]
    normals: tuple[Vec, ...]
    filters: tuple[int, int, int]
    whole: int
    alone: bool
    line: bool

    def height(self, point: Vec, k: int) -> float:
        """How far a point is outside of the line of edge k."""
        (x, y), (nx, ny) = self.corners[k], self.normals[k]
        return (point[0] - x) * nx + (point[1] - y) * ny

    def heights(self, point: Vec) -> list[float]:
        """The same for all edges."""
        return [self.height(point, k) for k in range(len(self.corners))]

    def length(self, k: int) -> float:
        """Length of edge k; 0 at the ends of lines without a radius."""
        return _length(self.corners[k], self.corners[(k + 1) % len(self.corners)])

    @property
    def flat(self) -> bool:
        """Whether it is a line without a radius."""
        return self.line and self.length(1) == 0.0


@dataclass(frozen=True)
class Seams:
    """What shows of a tile: stretches of its edges, and the normals of the sides before and after each vertex."""

    shown: list[Vec]
    sides: list[tuple[Vec, Vec]]


def read_tiles(state: Any) -> dict[int, Tile]:
    """All tiles of a state by the rows of their shapes."""
    flat = [shape for body in state.census.bodies.items for shape in body.shapes]
    tiles = {}
    for row, shape in enumerate(state.shapes):
        body = state.bodies[int(shape.body)]
        solid = body.frozen_step < 0 and not shape.traits & 2 and not shape.sensor
        line = bool(shape.vertex_count == 2)
        if not solid or not (line or (shape.vertex_count >= 3 and shape.radius == 0.0)):
            continue
        rows = state.vertices[shape.vertex_start : shape.vertex_start + shape.vertex_count]
        c, s, x, y = (float(body[name]) for name in ("rotation_cos", "rotation_sin", "center_x", "center_y"))
        corners = [(float(v.x), float(v.y)) for v in rows]
        normals = [(float(v.normal_x), float(v.normal_y)) for v in rows]
        if body.type != 0:
            c, s, x, y = 1.0, 0.0, 0.0, 0.0
            corners = [*flat[row].vertices]
        if line:
            corners, normals = _around_line(corners, normals, float(shape.radius))
        tiles[row] = Tile(
            tuple((x + (c * u - s * v), y + (s * u + c * v)) for u, v in corners),
            tuple((c * u - s * v, s * u + c * v) for u, v in normals),
            (int(shape.category), int(shape.mask), int(shape.group)),
            int(shape.body) if body.type != 0 else -1,
            bool(shape.part == 0),
            line,
        )
    return tiles


def _around_line(ends: list[Vec], normals: list[Vec], radius: float) -> tuple[list[Vec], list[Vec]]:
    """The outline of a line: its side to the right, its end, its side to the left, its beginning."""
    places = [(0, 0), (1, 0), (1, 1), (0, 1)]
    corners = [(ends[k][0] + radius * normals[n][0], ends[k][1] + radius * normals[n][1]) for k, n in places]
    (rx, ry), (lx, ly) = normals
    return corners, [(rx, ry), (-ry, rx), (lx, ly), (-ly, lx)]


def seams(tiles: dict[int, Tile], row: int) -> Seams | None:
    """What the tile in that row has of the whole; None if nothing of it is covered."""
    tile = tiles[row]
    if not tile.alone:
        return None
    others = [each for other, each in tiles.items() if other != row and each.filters == tile.filters]
    others = [other for other in others if other.whole == tile.whole and _boxes_meet(tile, other)]
    if not others:
        return None
    numbers = range(len(tile.corners))
    shown = [_shown(tile, k, others) for k in numbers]
    edges = [_with_round_end(tile, k, _edges(tile, k, shown, others), others) for k in numbers]
    sides = [(_normal(before), _normal(after)) for before, after in edges]
    own = [(tile.normals[k - 1], tile.normals[k]) for k in numbers]
    if all(each == WHOLE for each in shown) and sides == own:
        return None
    if tile.line:
        return Seams(shown[::2], [_at_end(tile, k, edges) for k in (0, 2)])
    return Seams(shown, sides)


def _at_end(tile: Tile, k: int, edges: list[tuple[Edge | None, Edge | None]]) -> tuple[Vec, Vec]:
    """The sides before and after the end of a line from which its edge k leaves: of both corners there, the one that
    juts out; all directions between its two sides where nothing goes on."""
    pairs = edges[k], edges[k - 1]
    own = [((tile, j - 1 if j else len(edges) - 1), (tile, j)) for j in (k, (k - 1) % len(edges))]
    if list(pairs) == own:
        return tile.normals[k - 2], tile.normals[k]
    here, across = ((_normal(before), _normal(after)) for before, after in pairs)
    return across if _cross(*across) > _cross(*here) else here


def _with_round_end(
    tile: Tile, k: int, edges: tuple[Edge | None, Edge | None], others: list[Tile]
) -> tuple[Edge | None, Edge | None]:
    """The edges of the whole at a corner; of a round line's that lies within the whole its own two, if some of the
    quarter of the round end between these is in no other tile."""
    if edges != (None, None) or not tile.line or tile.flat:
        return edges
    before = (k - 1) % 4
    (from_x, from_y), (to_x, to_y) = tile.normals[before], tile.normals[k]
    side, end = (k, before) if k % 2 == 0 else (before, k)
    radius, (side_x, side_y), (x, y) = 0.5 * tile.length(end), tile.normals[side], tile.corners[k]
    beside = [other for other in others if not _parted_aslant(tile, other)]
    for half in (n / 8 for n in range(1, 8)):
        c, s = (1.0 - half * half) / (1.0 + half * half), 2.0 * half / (1.0 + half * half)
        point = x + radius * (c * from_x + s * to_x - side_x), y + radius * (c * from_y + s * to_y - side_y)
        if all(max(other.heights(point)) > NEAR for other in beside):
            return (tile, before), (tile, k)
    return edges


def _parted_aslant(one: Tile, two: Tile) -> bool:
    """Whether the outlines of two tiles lie apart along one of a few directions, so that neither knows of the other."""
    for x, y in ((1, 1), (1, -1), (2, 1), (2, -1), (1, 2), (1, -2)):
        a, b = ([x * u + y * v for u, v in tile.corners] for tile in (one, two))
        if min(a) > max(b) + 5e-4 or min(b) > max(a) + 5e-4:
            return True
    return False


def _normal(edge: Edge | None) -> Vec:
    return edge[0].normals[edge[1]] if edge else (0.0, 0.0)


def _cross(one: Vec, two: Vec) -> float:
    return one[0] * two[1] - one[1] * two[0]


def _boxes_meet(one: Tile, two: Tile) -> bool:
    return all(
        min(c[k] for c in a.corners) - NEAR <= max(c[k] for c in b.corners) + NEAR
        for k in (0, 1)
        for a, b in ((one, two), (two, one))
    )


def _shown(tile: Tile, k: int, others: list[Tile]) -> Vec:
    """The stretch of an edge that shows."""
    start, end, normal = tile.corners[k], tile.corners[(k + 1) % len(tile.corners)], tile.normals[k]
    reach = OUT if tile.length(k) > 0.0 else 0.0
    out = reach * normal[0], reach * normal[1]
    edge = (start[0] + out[0], start[1] + out[1]), (end[0] + out[0], end[1] + out[1])
    near = 2.0 * NEAR / max(tile.length(k), 4.0 * NEAR)
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


def _edges(tile: Tile, k: int, shown: list[Vec], others: list[Tile]) -> tuple[Edge | None, Edge | None]:
    """The edges of the whole that end and begin in a corner."""
    point = tile.corners[k]
    before: Edge | None = (tile, (k - 1) % len(tile.corners)) if shown[k - 1][1] == 1.0 else None
    after: Edge | None = (tile, k) if shown[k][0] == 0.0 and shown[k][1] > 0.0 else None
    if before and after:
        return _parted(tile, point, before, after, others)
    if any(max(other.heights(point)) < -NEAR for other in others):
        return None, None
    for other in others:
        if max(other.heights(point)) <= NEAR:
            arriving, leaving = _through(other, point)
            rest = [tile, *(each for each in others if each is not other)]
            if not before and _is_free(point, arriving, -1.0, rest):
                before = arriving
            if not after and _is_free(point, leaving, 1.0, rest):
                after = leaving
    return before or after, after or before


def _parted(tile: Tile, point: Vec, before: Edge, after: Edge, others: list[Tile]) -> tuple[Edge, Edge]:
    """The same where both edges of a tile show: a line without a radius that begins there parts what lies between."""
    line = next((other for other in others if other.flat and max(other.heights(point)) <= NEAR), None)
    if line is None:
        return before, after
    arriving, leaving = _through(line, point)
    rest = [tile, *(each for each in others if each is not line)]
    found = []
    if arriving and _is_free(point, arriving, -1.0, rest):
        found.append((arriving, after))
    if leaving and _is_free(point, leaving, 1.0, rest):
        found.append((before, leaving))
    return max(found, key=lambda pair: _cross(_normal(pair[0]), _normal(pair[1])), default=(before, after))


def _through(other: Tile, point: Vec) -> tuple[Edge | None, Edge | None]:
    """The edges that arrive at a point on a tile's outline and leave it; of a flat line at its ends only."""
    count = len(other.corners)
    here = [k for k in range(count) if _length(other.corners[k], point) <= 2.0 * NEAR]
    arriving = next(((other, (k - 1) % count) for k in here if other.length((k - 1) % count) > 0.0), None)
    leaving = next(((other, k) for k in here if other.length(k) > 0.0), None)
    if arriving or leaving:
        return arriving, leaving
    if other.flat:
        return None, None
    heights = other.heights(point)
    edge = other, heights.index(max(heights))
    return edge, edge


def _is_free(point: Vec, edge: Edge | None, ahead: float, tiles: list[Tile]) -> bool:
    """Whether just ahead of a point, or behind it, no tile is in the way of an edge."""
    if edge is None:
        return False
    normal = _normal(edge)
    step = 4.0 * OUT * ahead
    probe = point[0] + step * -normal[1] + OUT * normal[0], point[1] + step * normal[0] + OUT * normal[1]
    return all(max(tile.heights(probe)) > NEAR for tile in tiles)


def _length(one: Vec, two: Vec) -> float:
    x, y = two[0] - one[0], two[1] - one[1]
    return math.sqrt(x * x + y * y)
