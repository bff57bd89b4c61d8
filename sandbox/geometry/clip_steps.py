"""How the contact points of one pair come about, step by step: the same way as `manifold.py`, with its kernels.

The face that gave the axis is the reference face. The edge of the other core that faces it most is the incident edge;
it is cut at both sides of the reference face, and what lies beneath the face gives the points.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sandbox._jit import interpreted
from sandbox.geometry.collide import Contact
from sandbox.geometry.core import CoreRows
from sandbox.geometry.pair import CORE, Pair, pair_of
from sandbox.geometry.sat import FAR, face_separation, facing_edge
from sandbox.geometry.sat_rows import Vec
from sandbox.geometry.shapes import Shape
from sandbox.tables import Records

_face_separation, _facing_edge = interpreted(face_separation), interpreted(facing_edge)


@dataclass(frozen=True)
class BestFace:
    """The face of a core along whose normal the other one is least deep: the author's number from 1, and how deep.

    `separation` (m) is from core to core, radii left out.
    """

    edge: int
    separation: float


@dataclass(frozen=True)
class Clipping:
    """Clipping of one pair, in metres and world coordinates.

    `owner` is whose face is the reference face; `normal` its unit normal. `reference` and `incident` run counter-
    clockwise, each with the author's edge number from 1. `low` and `high` are where the ends of the reference face lie
    along the face's direction, `before` where those of the incident edge do. `clipped` are the ends of the incident
    edge after cutting, `gaps` how far each is from the reference surface (negative: beneath it), in the same order.
    """

    owner: str
    normal: Vec
    reference_edge: int
    reference: tuple[Vec, Vec]
    incident_edge: int
    incident: tuple[Vec, Vec]
    low: float
    high: float
    before: tuple[float, float]
    clipped: tuple[Vec, Vec]
    gaps: tuple[float, float]


def best_faces(a: Shape, b: Shape) -> tuple[BestFace | None, BestFace | None]:
    """What the kernel makes of the faces of a, and of b; None for a disc, which has none."""
    pair = pair_of(a, b)
    (core_a, core_b), (dx, dy), rows = _core_rows(pair), pair.displacement, _records(pair)
    of_a = _face_separation(rows, core_a, core_b, dx, dy, FAR)
    of_b = _face_separation(rows, core_b, core_a, -dx, -dy, FAR)
    return _best(a, *of_a), _best(b, *of_b)


def clipping(a: Shape, b: Shape, contact: Contact) -> Clipping | None:
    """The clipping behind a contact; None where a disc or two corners meet, as there is nothing to clip."""
    if contact.axis_edge is None:
        return None
    mine, other = (a, b) if contact.axis_owner == "a" else (b, a)
    if len(other.vertices) == 1:
        return None
    sign = 1.0 if contact.axis_owner == "a" else -1.0
    normal = sign * contact.normal[0] + 0.0, sign * contact.normal[1] + 0.0
    face, facing = _face_towards(mine, contact.axis_edge, normal), _incident(a, b, contact, normal)
    return _clip(contact.axis_owner, normal, mine, face, other, facing)


def _clip(owner: str, normal: Vec, mine: Shape, face: int, other: Shape, facing: int) -> Clipping:
    # Both edges run counter-clockwise, so the incident one goes against the direction of the face.
    reference, incident = _edge(mine, face), _edge(other, facing)
    tangent = -normal[1], normal[0]
    low, high = _dot(tangent, reference[0]), _dot(tangent, reference[1])
    before = _dot(tangent, incident[0]), _dot(tangent, incident[1])
    clipped = _cut(incident, before, low, high)
    radii = mine.radius + other.radius
    offset = _dot(normal, reference[0])
    gaps = _dot(normal, clipped[0]) - offset - radii, _dot(normal, clipped[1]) - offset - radii
    return Clipping(
        owner, normal, mine.edge_numbers[face] + 1, reference, other.edge_numbers[facing] + 1, incident,
        low, high, before, clipped, gaps,
    )  # fmt: skip


def _edge(shape: Shape, index: int) -> tuple[Vec, Vec]:
    return shape.vertices[index], shape.vertices[(index + 1) % len(shape.vertices)]


def _cut(edge: tuple[Vec, Vec], ends: Vec, low: float, high: float) -> tuple[Vec, Vec]:
    """The part of an edge between the two sides, which lie at `low` and `high` along the reference face."""
    (first, last), span = edge, ends[1] - ends[0]

    def at(place: float) -> Vec:
        t = (place - ends[0]) / span
        return first[0] + t * (last[0] - first[0]), first[1] + t * (last[1] - first[1])

    start = first if low <= ends[0] <= high else at(low if ends[0] < low else high)
    end = last if low <= ends[1] <= high else at(low if ends[1] < low else high)
    return start, end


def _face_towards(shape: Shape, number: int, normal: Vec) -> int:
    """The core's index of the author's edge `number`: of a line's two faces the one that looks along `normal`."""
    core = shape.vertices
    faces = [i for i in range(len(core)) if shape.edge_numbers[i] == number]

    def along(i: int) -> float:
        (x0, y0), (x1, y1) = core[i], core[(i + 1) % len(core)]
        return normal[0] * (y1 - y0) + normal[1] * (x0 - x1)

    return max(faces, key=along)


def _incident(a: Shape, b: Shape, contact: Contact, normal: Vec) -> int:
    pair = pair_of(a, b)
    core_a, core_b = _core_rows(pair)
    return int(_facing_edge(_records(pair), core_b if contact.axis_owner == "a" else core_a, *normal))


def _best(shape: Shape, separation: float, face: int) -> BestFace | None:
    return BestFace(shape.edge_numbers[face] + 1, float(separation)) if face >= 0 else None


def _core_rows(pair: Pair) -> tuple[CoreRows, CoreRows]:
    (m, n), (radius_a, radius_b) = pair.counts, pair.radii
    return CoreRows(0, m, radius_a), CoreRows(m, n, radius_b)


def _records(pair: Pair) -> Records:
    """The pair's rows for kernels that run as Python."""
    return np.asarray(pair.cores).view(CORE.dtype).view(np.recarray)


def _dot(u: Vec, v: Vec) -> float:
    return u[0] * v[0] + u[1] * v[1]
