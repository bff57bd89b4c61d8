"""A flat scene as a pymunk space."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pymunk

from sandbox.reference.own_mass import own_mass
from sandbox.scene.flat import FlatBody, FlatScene, FlatShape

_TYPES = {
    "static": pymunk.Body.STATIC, "kinematic": pymunk.Body.KINEMATIC, "dynamic": pymunk.Body.DYNAMIC,
}  # fmt: skip


def build_space(scene: FlatScene) -> tuple[pymunk.Space, list[pymunk.Body]]:
    """(space, bodies in the order of the scene), with masses, surfaces and filters as in the scene.

    pymunk multiplies frictions and restitutions of a pair: square roots of the friction coefficients give the same
    product as ours; restitution has no such form and is passed as it is. `left_out` says what else differs.
    """
    space = pymunk.Space()
    space.gravity = scene.gravity
    bodies = [add_body(space, body) for body in scene.bodies]
    return space, bodies


def add_body(space: pymunk.Space, flat: FlatBody, solid: bool = False) -> pymunk.Body:
    """A body in `space`. With `solid`, one-way shapes are there and hold from both sides; else they are left out."""
    body = pymunk.Body(body_type=_TYPES[flat.type])
    if flat.type == "dynamic":
        body.mass, body.center_of_gravity, body.moment = own_mass(flat)
        if flat.fixed_rotation:
            body.moment = math.inf
    # The angle first: pymunk turns a body about its centre of gravity, which moves the origin.
    body.angle = flat.angle
    body.position = flat.position
    if flat.type != "static":
        body.velocity, body.angular_velocity = flat.velocity, flat.angular_velocity
    if flat.gravity_scale != 1.0 or flat.linear_damping or flat.angular_damping:
        body.velocity_func = _own_motion(flat)
    space.add(body, *(_build_shape(body, shape) for shape in flat.shapes if solid or not any(shape.one_way)))
    return body


def _own_motion(flat: FlatBody) -> Callable[[pymunk.Body, Any, float, float], None]:
    """Gravity scale and damping of one body, as pymunk's hook for integrating velocities."""

    def update(body: pymunk.Body, gravity: Any, _damping: float, dt: float) -> None:
        spin = body.angular_velocity
        pull = (gravity[0] * flat.gravity_scale, gravity[1] * flat.gravity_scale)
        pymunk.Body.update_velocity(body, pull, math.exp(-flat.linear_damping * dt), dt)
        body.angular_velocity = spin * math.exp(-flat.angular_damping * dt)

    return update


def left_out(scene: FlatScene) -> tuple[str, ...]:
    """What of the surfaces of a scene pymunk does otherwise, a line each."""
    shapes = [shape for body in scene.bodies for shape in body.shapes]
    notes = {
        "pymunk multiplies the restitutions of a pair; here the larger one holds": "restitution",
        "pymunk has no rolling resistance": "rolling_resistance",
        "pymunk's surface velocity is left out: it is one vector, not a speed around the shape": "surface_speed",
    }
    found = ["pymunk runs at its defaults: 10 iterations a step, overlaps of 0.1 m allowed"]
    found += [text for text, field in notes.items() if any(getattr(shape, field) for shape in shapes)]
    if any(shape.group > 0 for shape in shapes):
        found.append("pymunk has no groups that always collide")
    return tuple(found)


def _build_shape(body: pymunk.Body, flat: FlatShape) -> Any:
    shape: Any
    if len(flat.vertices) == 1:
        shape = pymunk.Circle(body, flat.radius, flat.vertices[0])
    elif len(flat.vertices) == 2:
        shape = pymunk.Segment(body, *flat.vertices, flat.radius)
    else:
        shape = pymunk.Poly(body, flat.vertices, radius=flat.radius)
    shape.friction, shape.elasticity = math.sqrt(flat.friction), flat.restitution
    shape.filter = pymunk.ShapeFilter(max(0, -flat.group), flat.category, flat.mask)
    shape.sensor = flat.sensor
    return shape
