"""Who can meet whom, as the engine's filters decide it."""

from __future__ import annotations

from itertools import product

from sandbox.scene.flat import FlatBody, FlatShape


def filters_agree(a: FlatShape, b: FlatShape) -> bool:
    """Whether two shapes collide, or a sensor feels the other."""
    if a.group == b.group != 0:
        return a.group > 0
    return bool(a.category & b.mask) and bool(b.category & a.mask)


def can_push(a: FlatBody, b: FlatBody) -> bool:
    """Whether solid shapes of two bodies collide where they meet, one of which is dynamic."""
    if a.id == b.id or "dynamic" not in (a.type, b.type):
        return False
    return any(not (s.sensor or t.sensor) and filters_agree(s, t) for s, t in product(a.shapes, b.shapes))


def can_feel(sensor: FlatShape, bearer: FlatBody, other: FlatBody) -> bool:
    """Whether a sensor of `bearer` feels a solid shape of another body."""
    if bearer.id == other.id or (bearer.type == "static" and other.type == "static"):
        return False
    return any(not shape.sensor and filters_agree(sensor, shape) for shape in other.shapes)
