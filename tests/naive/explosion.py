"""What an explosion does by definition: one impulse after another, from the public shapes of the bodies."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sandbox import ApplyImpulse, Explode, World
from sandbox.geometry.collide import contains
from sandbox.geometry.shapes import Shape

Vec = tuple[float, float]


def impulses(world: World, command: Explode, bodies: list[str]) -> Iterator[ApplyImpulse]:
    """The impulses on the shapes of `bodies`, all of which are solid."""
    for name in bodies:
        for shape in world.body(name).shapes:
            nearest, gap = _nearest(shape, command.point)
            towards = nearest if gap > 0.0 else world.body(name).center
            x, y = towards[0] - command.point[0], towards[1] - command.point[1]
            length = math.sqrt(x * x + y * y)
            if gap < command.radius and length > 0.0:
                x, y = x / length, y / length
                across = [x * v - y * u for u, v in shape.vertices]
                width = max(across) - min(across) + 2.0 * shape.radius
                size = command.impulse * width * (1.0 - max(gap, 0.0) / command.radius)
                yield ApplyImpulse(name, (size * x, size * y), point=nearest if gap > 0.0 else None)


def _nearest(shape: Shape, point: Vec) -> tuple[Vec, float]:
    """The place of a shape that is nearest to a point, and how far away it is; 0 if the shape holds the point."""
    core = shape.vertices
    edges = [_on_edge(a, b, point) for a, b in zip(core, (*core[1:], core[0]), strict=True)]
    (x, y), away = min(edges, key=lambda found: found[1])
    if contains(shape, point) or away == 0.0:
        return point, 0.0
    share = shape.radius / away
    return (x + (point[0] - x) * share, y + (point[1] - y) * share), away - shape.radius


def _on_edge(a: Vec, b: Vec, point: Vec) -> tuple[Vec, float]:
    x, y = b[0] - a[0], b[1] - a[1]
    square = x * x + y * y
    along = ((point[0] - a[0]) * x + (point[1] - a[1]) * y) / square if square > 0.0 else 0.0
    along = min(max(along, 0.0), 1.0)
    near = (a[0] + along * x, a[1] + along * y)
    dx, dy = point[0] - near[0], point[1] - near[1]
    return near, math.sqrt(dx * dx + dy * dy)
