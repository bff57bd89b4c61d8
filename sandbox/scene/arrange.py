"""Where the bodies of a generator go."""

from __future__ import annotations

import math
from collections.abc import Sequence

from sandbox.geometry.rotation import RADIANS_PER_DEGREE, cos_sin_degrees
from sandbox.scene.flat import FlatShape, Vec
from sandbox.scene.generators import Chain, Generator, Grid, Place, Pyramid, Row, Scatter, Stack
from sandbox.scene.scatter import scatter
from sandbox.scene.splitmix import SplitMix64

Placing = tuple[float, float, float | None]
"""x and y in metres and an angle in degrees; None keeps the prefab's angle."""


def outer_size(shapes: Sequence[FlatShape], degrees: float) -> Vec:
    """Width and height in metres of the box around shapes turned by `degrees`."""
    cos, sin = cos_sin_degrees(degrees)
    rims = [(cos * x - sin * y, sin * x + cos * y, s.radius) for s in shapes for x, y in s.vertices]
    width = max(x + r for x, _, r in rims) - min(x - r for x, _, r in rims)
    height = max(y + r for _, y, r in rims) - min(y - r for _, y, r in rims)
    return width, height


def reach(shapes: Sequence[FlatShape]) -> float:
    """Largest distance in metres of a surface point from the body's origin."""
    return max(math.sqrt(x * x + y * y) + s.radius for s in shapes for x, y in s.vertices)


def placings(generator: Generator, shapes: Sequence[FlatShape], degrees: float) -> list[Placing]:
    """A placing for each body, in the order of `body_names`; fewer if a scatter found no room for more.

    The shapes are those of the body; there need be none where the generator says how far apart bodies stand.
    """
    if isinstance(generator, Scatter):
        return _scattered(generator, 2 * reach(shapes) if generator.apart is None else generator.apart)
    if isinstance(generator, Place):
        return [(*generator.at, generator.angle)] * (generator.count or 1)
    if isinstance(generator, Chain):
        return _chained(generator, chain_step(generator, shapes))
    width, height = outer_size(shapes, degrees) if shapes else (0.0, 0.0)
    points: list[Vec]
    match generator:
        case Row():
            dx, dy = generator.step or (width, 0.0)
            points = [(k * dx, k * dy) for k in range(generator.count)]
        case Stack():
            points = [(0.0, k * (generator.spacing or height)) for k in range(generator.count)]
        case Grid():
            points = _grid(generator, generator.spacing or (width, height))
        case Pyramid():
            points = _pyramid(generator.rows, generator.spacing or (width, height))
        case _:
            raise TypeError(type(generator).__name__)
    left, up = generator.at
    return [(left + x, up + y, None) for x, y in points]


def chain_step(chain: Chain, shapes: Sequence[FlatShape]) -> Vec:
    """From one hinge of a chain to the next, m."""
    return chain.step or (outer_size(shapes, 0.0)[0], 0.0)


def _chained(chain: Chain, step: Vec) -> list[Placing]:
    from sandbox._jit import interpreted
    from sandbox.geometry.trig import arctan2  # kernels are heavy to import, and few scenes have chains

    (x, y), (dx, dy) = chain.at, step
    angle = interpreted(arctan2)(dy, dx) / RADIANS_PER_DEGREE
    return [(x + (k + 0.5) * dx, y + (k + 0.5) * dy, angle) for k in range(chain.count)]


def _grid(grid: Grid, spacing: Vec) -> list[Vec]:
    return [
        (column * spacing[0] + row % 2 * grid.stagger, row * spacing[1])
        for row in range(grid.rows)
        for column in range(grid.columns)
    ]


def _pyramid(rows: int, spacing: Vec) -> list[Vec]:
    return [
        ((column - (rows - 1 - row) / 2) * spacing[0], row * spacing[1])
        for row in range(rows)
        for column in range(rows - row)
    ]


def _scattered(generator: Scatter, apart: float) -> list[Placing]:
    random = SplitMix64(generator.seed)
    points = scatter(generator.count, generator.inside, apart, random)
    if generator.angle is None:
        return [(x, y, None) for x, y in points]
    return [(x, y, random.between(*generator.angle)) for x, y in points]
