"""A polygon that may be concave and may have holes, as few convex parts.

The parts are the same for any winding and any first vertex, because points are numbered by their place.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

from sandbox.geometry.merge import Ring, Turns, convex_parts, sides
from sandbox.geometry.polygon import MAX_VERTICES, ConcaveError, Vec, convex_polygon
from sandbox.geometry.rings import Rings, clean_rings
from sandbox.geometry.triangulate import triangulate

_ALL, _NOTHING = (0.0, 1.0), (1.0, 0.0)


class Part(NamedTuple):
    """A convex polygon (m, counter-clockwise) and what of its edges shows on the outside of the whole.

    `shown[i]` is the stretch of the edge from vertex i to the next on which sides of the whole lie, from the first to
    the last of them, as shares of its length; (1, 0) where there is none.
    """

    vertices: tuple[Vec, ...]
    shown: tuple[tuple[float, float], ...]


class Decomposition(NamedTuple):
    """`rings`: the outline counter-clockwise, then the holes clockwise, in metres; `parts`: what they enclose."""

    rings: tuple[tuple[Vec, ...], ...]
    parts: tuple[Part, ...]


def decompose(outline: Sequence[Vec], holes: Sequence[Sequence[Vec]] = ()) -> Decomposition:
    """Convex parts of at most 64 vertices that fill `outline` except for `holes` (m, either winding, finite).

    No vertices are added. A vertex that lies on the straight side of a part, to a billionth of the polygon's size, is
    none of that part's. Raises `PolygonError` with the vertex, and the hole, to look at.
    """
    return _decompose(_floats(outline), tuple(_floats(hole) for hole in holes))


def _floats(ring: Sequence[Vec]) -> tuple[Vec, ...]:
    return tuple((float(x), float(y)) for x, y in ring)


def check_outline(outline: Sequence[Vec], holes: Sequence[Sequence[Vec]] = ()) -> None:
    """Raises `PolygonError` where `decompose` would, and cuts nothing."""
    _read(_floats(outline), tuple(_floats(hole) for hole in holes))


@lru_cache(maxsize=1024)
def _decompose(outline: tuple[Vec, ...], holes: tuple[tuple[Vec, ...], ...]) -> Decomposition:
    given = _read(outline, holes)
    if isinstance(given, tuple):
        return Decomposition((given,), (Part(given, (_ALL,) * len(given)),))
    return Decomposition(tuple(tuple(given.vertices[i] for i in ring) for ring in given.rings), _parts(given))


def _read(outline: tuple[Vec, ...], holes: tuple[tuple[Vec, ...], ...]) -> tuple[Vec, ...] | Rings:
    """The corners of a polygon that is convex, or the rings of another one."""
    if not holes and len(outline) <= MAX_VERTICES:
        try:
            return convex_polygon(outline)
        except ConcaveError:
            pass
    return clean_rings(outline, holes)


def _parts(given: Rings) -> tuple[Part, ...]:
    order = sorted((i for ring in given.rings for i in ring), key=lambda i: given.points[i])
    number = {i: k for k, i in enumerate(order)}
    points, vertices = [given.points[i] for i in order], [given.vertices[i] for i in order]
    rings = [[number[i] for i in ring] for ring in given.rings]
    outer = {side for ring in rings for side in sides(ring)}
    turns = Turns(points)
    faces = convex_parts(turns, triangulate(points, rings))
    return tuple(_part(turns, vertices, face, outer) for face in faces)


def _part(turns: Turns, vertices: Sequence[Vec], face: Ring, outer: set[tuple[int, int]]) -> Part:
    """The corners of a face, and where the pieces of its edges that are sides of the whole begin and end."""
    kept = turns.corners(face)
    start = face.index(kept[0])
    ring = face[start:] + face[: start + 1]
    places = [*((face.index(i) - start) % len(face) for i in kept), len(face)]
    edges = [ring[a : b + 1] for a, b in pairwise(places)]
    shown = tuple(_shown(vertices, edge, [piece in outer for piece in pairwise(edge)]) for edge in edges)
    return Part(tuple(vertices[i] for i in kept), shown)


def _shown(vertices: Sequence[Vec], edge: Ring, is_side: list[bool]) -> tuple[float, float]:
    """From where to where sides of the whole lie on an edge; `edge` are all points on it."""
    if not any(is_side):
        return _NOTHING
    first, last = is_side.index(True), len(is_side) - is_side[::-1].index(True)
    return _share(vertices, edge, first), _share(vertices, edge, last)


def _share(vertices: Sequence[Vec], edge: Ring, k: int) -> float:
    """How far along an edge its k-th point lies."""
    if k in (0, len(edge) - 1):
        return float(k > 0)
    return math.dist(vertices[edge[0]], vertices[edge[k]]) / math.dist(vertices[edge[0]], vertices[edge[-1]])
