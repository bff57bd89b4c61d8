"""The shapes of a body as plain values: where they are now, with the author's numbering of corners."""

from __future__ import annotations

from sandbox.geometry.shapes import Capsule, Circle, Polygon, Segment, Shape
from sandbox.scene.flat import FlatShape, Vec
from sandbox.world.state import State


def body_shapes(state: State, row: int) -> tuple[Shape, ...]:
    """The shapes of one body in world coordinates (m), in the order of the scene.

    Raises `ShapeError` where a shape is too small to be told apart so far from the origin.
    """
    body = state.bodies[row]
    place = float(body.position_x), float(body.position_y)
    turn = float(body.rotation_cos), float(body.rotation_sin)
    return tuple(_shape(shape, place, turn) for shape in state.census.bodies.items[row].shapes)


def _shape(shape: FlatShape, place: Vec, turn: Vec) -> Shape:
    core = [_placed(vertex, place, turn) for vertex in shape.vertices]
    if shape.kind == "circle":
        return Circle(core[0], shape.radius)
    if len(core) == 2:
        return Capsule(core[0], core[1], shape.radius) if shape.radius else Segment(core[0], core[1])
    if shape.clockwise:
        core = [core[0], *reversed(core[1:])]
    return Polygon(tuple(core), shape.radius)


def _placed(vertex: Vec, place: Vec, turn: Vec) -> Vec:
    (x, y), (cos, sin) = vertex, turn
    return place[0] + (cos * x - sin * y), place[1] + (sin * x + cos * y)
