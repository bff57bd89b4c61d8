"""Shapes of a flat body as Box2D's, by way of pyb2d3."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from sandbox.scene.flat import FlatShape, Vec

_MOST_VERTICES = 8


def add_shapes(b2: Any, body: Any, shapes: Sequence[FlatShape]) -> None:
    """Give `body` its shapes; `b2` is the package pyb2d3. Links of one-sided chains become chains again.

    Polygons of more vertices than Box2D knows are cut into fans that share their first vertex.
    """
    chain: list[FlatShape] = []
    for shape in shapes:
        if chain and not (_is_link(shape) and shape.vertices[0] == chain[-1].vertices[1]):
            _add_chain(b2, body, chain)
            chain = []
        if _is_link(shape):
            chain.append(shape)
        else:
            _add_shape(b2, body, shape)
    if chain:
        _add_chain(b2, body, chain)


def _is_link(shape: FlatShape) -> bool:
    """Whether it is part of a one-sided chain, which alone Box2D has."""
    return bool(shape.seam) and any(shape.one_way)


def _add_shape(b2: Any, body: Any, shape: FlatShape) -> None:
    definition = b2.shape_def(density=shape.density, is_sensor=shape.sensor)
    definition.material, definition.filter = _material(b2, shape), _filter(b2, shape)
    definition.enable_sensor_events = True  # without it sensors feel nothing, and cost nothing
    for geometry in _geometries(b2, shape):
        body.create_shape(definition, geometry)


def _geometries(b2: Any, shape: FlatShape) -> Iterator[Any]:
    corners = shape.vertices
    if len(corners) == 1:
        yield b2.circle(corners[0], shape.radius)
    elif len(corners) == 2:
        yield b2.capsule(*corners, shape.radius) if shape.radius > 0.0 else b2.segment(*corners)
    else:
        radius = shape.radius if shape.radius > 0.0 else None
        for part in _fans(corners):
            yield b2.polygon(part, radius=radius)


def _fans(corners: Sequence[Vec]) -> list[list[Vec]]:
    rest = corners[1:]
    stride = _MOST_VERTICES - 2
    return [[corners[0], *rest[k : k + stride + 1]] for k in range(0, len(rest) - 1, stride)]


def _add_chain(b2: Any, body: Any, links: Sequence[FlatShape]) -> None:
    """Box2D's chains are solid from the right of their direction, ours from the left."""
    points = [link.vertices[0] for link in links]
    closed = links[-1].vertices[1] == points[0]
    if not closed:
        points.append(links[-1].vertices[1])
        # The first and the last point of an open chain are ghosts there: these lead straight on.
        points = [_beyond(points[1], points[0]), *points, _beyond(points[-2], points[-1])]
    points.reverse()
    first = links[0]
    body.create_chain(b2.chain_def(points, material=_material(b2, first), is_loop=closed, filter=_filter(b2, first)))


def _beyond(one: Vec, two: Vec) -> Vec:
    return 2.0 * two[0] - one[0], 2.0 * two[1] - one[1]


def _material(b2: Any, shape: FlatShape) -> Any:
    return b2.surface_material(
        friction=shape.friction, restitution=shape.restitution, tangent_speed=shape.surface_speed,
    )  # fmt: skip


def _filter(b2: Any, shape: FlatShape) -> Any:
    return b2.make_filter(category_bits=shape.category, mask_bits=shape.mask, group_index=shape.group)
