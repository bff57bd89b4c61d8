"""Shapes of a flat body as shapes of planck.js, with the share of their density that each has."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

from sandbox.formats.numbers import Vec
from sandbox.formats.remarks import Remarks
from sandbox.geometry.mass import edge_normals
from sandbox.scene.flat import FlatShape

Part = tuple[FlatShape, dict[str, Any], float]
"""Of which shape, the shape of planck.js, and its share of the density."""

MOST_VERTICES = 8
"""Of a polygon of Box2D; planck.js allows more, but not everybody who reads its files."""


def vector(point: Vec) -> dict[str, float]:
    """A vector as planck.js writes it."""
    return {"x": point[0], "y": point[1]}


def planck_shapes(shapes: Sequence[FlatShape], remarks: Remarks, place: str) -> Iterator[Part]:
    """All shapes of a body; links of a chain become chains again."""
    chain: list[FlatShape] = []
    for shape in (*shapes, None):
        is_link = shape is not None and bool(shape.seam)
        if chain and not (is_link and shape and shape.vertices[0] == chain[-1].vertices[1] and not _closed(chain)):
            yield from _chain(chain)
            chain = []
        if shape is not None and is_link:
            chain.append(shape)
        elif shape is not None:
            yield from _shape(shape, remarks, place)
    if any(shape.radius > 0.0 and len(shape.vertices) > 1 for shape in shapes):
        remarks.note(place, "rounded corners are cut off straight, and capsules are a box and two discs")


def _closed(chain: Sequence[FlatShape]) -> bool:
    return len(chain) > 2 and chain[-1].vertices[1] == chain[0].vertices[0]


def _chain(links: Sequence[FlatShape]) -> Iterator[Part]:
    """Links with a radius are capsules of their own: planck.js has no thick chains."""
    if links[0].radius > 0.0:
        for link in links:
            yield from _capsule(link)
        return
    points = [link.vertices[0] for link in links]
    is_loop = _closed(links)
    if not is_loop:
        points.append(links[-1].vertices[1])
    data = {
        "type": "chain", "vertices": [vector(point) for point in points], "isLoop": is_loop,
        "hasPrevVertex": is_loop, "hasNextVertex": is_loop, "prevVertex": None, "nextVertex": None,
    }  # fmt: skip
    if is_loop:
        data |= {"prevVertex": vector(points[-1]), "nextVertex": vector(points[1])}
    yield links[0], data, 1.0


def _shape(shape: FlatShape, remarks: Remarks, place: str) -> Iterator[Part]:
    corners = shape.vertices
    if len(corners) == 1:
        yield shape, _circle(corners[0], shape.radius), 1.0
    elif len(corners) == 2 and shape.radius > 0.0:
        yield from _capsule(shape)
    elif len(corners) == 2:
        data = {"type": "edge", "vertex1": vector(corners[0]), "vertex2": vector(corners[1])}
        empty = {"vertex0": None, "vertex3": None, "hasVertex0": False, "hasVertex3": False}
        yield shape, data | empty, 1.0
    else:
        ring = _chamfered(corners, shape.radius) if shape.radius > 0.0 else list(corners)
        if len(ring) > MOST_VERTICES:
            remarks.note(place, f"a polygon of more than {MOST_VERTICES} corners is cut into parts")
        for part in _fans(ring):
            yield shape, _polygon(part), 1.0


def _capsule(shape: FlatShape) -> Iterator[Part]:
    """The box between the ends, and a disc at each of half the density: mass and centre are those of the capsule."""
    (ax, ay), (bx, by) = shape.vertices
    x, y = edge_normals(shape.vertices)[0]
    x, y = x * shape.radius, y * shape.radius
    yield shape, _polygon([(ax + x, ay + y), (ax - x, ay - y), (bx - x, by - y), (bx + x, by + y)][::-1]), 1.0
    for end in shape.vertices:
        yield shape, _circle(end, shape.radius), 0.5


def _circle(center: Vec, radius: float) -> dict[str, Any]:
    return {"type": "circle", "p": vector(center), "radius": radius}


def _polygon(ring: Sequence[Vec]) -> dict[str, Any]:
    doubled = sum(a[0] * b[1] - a[1] * b[0] for a, b in pairwise([*ring, ring[0]]))
    return {"type": "polygon", "vertices": [vector(point) for point in (ring if doubled > 0.0 else ring[::-1])]}


def _chamfered(corners: Sequence[Vec], radius: float) -> list[Vec]:
    """Where the rounding of each corner begins and ends."""
    normals = edge_normals(corners)
    found: list[Vec] = []
    for k, (x, y) in enumerate(corners):
        found += [(x + radius * nx, y + radius * ny) for nx, ny in (normals[k - 1], normals[k])]
    return [point for k, point in enumerate(found) if math.dist(point, found[k - 1]) > 1e-9]


def _fans(ring: Sequence[Vec]) -> list[list[Vec]]:
    """Convex parts that share their first corner, of few enough corners each."""
    rest, stride = ring[1:], MOST_VERTICES - 2
    return [[ring[0], *rest[k : k + stride + 1]] for k in range(0, len(rest) - 1, stride)]
