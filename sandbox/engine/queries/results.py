"""What queries answer: small values, sorted the same way on every machine.

`body` is a body's id, `shape` the row of the shape in the world's shape table, as in `world.contacts`. Points are world
coordinates in metres; normals are unit vectors that point out of what was hit.
"""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.tables import Floats, Integers

Vec = tuple[float, float]


@dataclass(frozen=True, slots=True)
class RayHit:
    """Where a ray enters a shape: `fraction` of its way, 0..1.

    A ray that starts inside has fraction 0, its origin as the point, and the normal (0, 0): it crosses no surface.
    """

    body: str
    shape: int
    point: Vec
    normal: Vec
    fraction: float


@dataclass(frozen=True, slots=True)
class CastHit:
    """Where a moving shape first touches another: `fraction` of its way, 0..1, and the `point` they have in common.

    Shapes that overlap at the start have fraction 0 and the normal (0, 0).
    """

    body: str
    shape: int
    point: Vec
    normal: Vec
    fraction: float


@dataclass(frozen=True, slots=True)
class PointHit:
    """A shape and its surface point nearest to a given point: `distance` is negative when the point is inside."""

    body: str
    shape: int
    point: Vec
    normal: Vec
    distance: float


@dataclass(frozen=True, slots=True)
class Overlap:
    """A shape that a given one touches. Moving the given shape by `depth * normal` parts the two."""

    body: str
    shape: int
    point: Vec
    normal: Vec
    depth: float


@dataclass(frozen=True, slots=True)
class BodyDistance:
    """The closest points of two bodies and the shapes they belong to; `normal` points from the first to the second.

    `distance` is negative when they overlap: then it is the depth of those two shapes that overlap most.
    """

    distance: float
    point_a: Vec
    point_b: Vec
    normal: Vec
    shape_a: int
    shape_b: int


@dataclass(frozen=True, slots=True)
class RayHits:
    """The first hit of many rays, as columns in the order of the rays.

    A ray without a hit has body and shape -1, fraction 1, the end of its way as the point and the normal (0, 0).
    `body` is the index into `world.names`.
    """

    body: Integers
    shape: Integers
    point: Floats
    normal: Floats
    fraction: Floats

    def __len__(self) -> int:
        return len(self.fraction)
