"""A polygon that may be concave and may have holes, as few convex parts.

The parts are the same for any winding and any first vertex, because points are numbered by their place.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from sandbox.geometry.merge import Ring, Turns, convex_parts, sides
from sandbox.geometry.polygon import MAX_VERTICES, ConcaveError, Vec, convex_polygon
from sandbox.geometry.rings import Rings, clean_rings
from sandbox.geometry.triangulate import triangulate


class Part(NamedTuple):
    """A convex polygon (m, counter-clockwise). `inner[i]`: the edge from vertex i to the next lies within the whole."""

    vertices: tuple[Vec, ...]
    inner: tuple[bool, ...]


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


@lru_cache(maxsize=1024)
def _decompose(outline: tuple[Vec, ...], holes: tuple[tuple[Vec, ...], ...]) -> Decomposition:
    if not holes and len(outline) <= MAX_VERTICES:
        try:
            core = convex_polygon(outline)
            return Decomposition((core,), (Part(core, (False,) * len(core)),))
        except ConcaveError:
            pass
    rings = clean_rings(outline, holes)
    return Decomposition(tuple(tuple(rings.vertices[i] for i in ring) for ring in rings.rings), _parts(rings))


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
    """The corners of a face. An edge is an inner one if no piece of it is a side of the whole."""
    kept = turns.corners(face)
    start = face.index(kept[0])
    pieces = [side not in outer for side in sides(face[start:] + face[:start])]
    places = [(face.index(i) - start) % len(face) for i in kept]
    inner = tuple(all(pieces[a:b]) for a, b in zip(places, [*places[1:], len(face)], strict=True))
    return Part(tuple(vertices[i] for i in kept), inner)
