"""A body of a world as a whole: its convex shapes, and the outlines of the concave polygons they are parts of."""

from __future__ import annotations

from sandbox.engine.world import World
from sandbox.render.sat_page import Whole
from sandbox.world.body_shapes import body_shapes


def whole(world: World, name: str) -> Whole:
    """Shapes and outlines (m) where the body is now. Raises `UnknownBodyError`."""
    index = world.directory.body(name)
    parts = body_shapes(world.state, index)
    row = world.state.bodies[index]
    x, y = float(row.position_x), float(row.position_y)
    cos, sin = float(row.rotation_cos), float(row.rotation_sin)
    rings = [ring for shape in world.flat.bodies[index].shapes if shape.part == 1 for ring in shape.outline]
    placed = (tuple((x + (cos * u - sin * v), y + (sin * u + cos * v)) for u, v in ring) for ring in rings)
    return Whole(parts, tuple(placed))
