"""A flat scene as a pymunk space."""

from __future__ import annotations

import math
from typing import Any

import pymunk

from sandbox.geometry.mass import Moments, moments
from sandbox.scene.flat import FlatBody, FlatScene, FlatShape

_TYPES = {
    "static": pymunk.Body.STATIC, "kinematic": pymunk.Body.KINEMATIC, "dynamic": pymunk.Body.DYNAMIC,
}  # fmt: skip


def build_space(scene: FlatScene) -> tuple[pymunk.Space, list[pymunk.Body]]:
    """(space, bodies in the order of the scene), with masses, surfaces and filters as in the scene.

    pymunk multiplies frictions and restitutions of a pair: square roots of the friction coefficients give the same
    product as ours; restitution has no such form and is passed as it is.
    """
    space = pymunk.Space()
    space.gravity = scene.gravity
    bodies = [_build_body(space, body) for body in scene.bodies]
    return space, bodies


def _build_body(space: pymunk.Space, flat: FlatBody) -> pymunk.Body:
    total = Moments(0.0, 0.0, 0.0, 0.0)
    for shape in flat.shapes:
        total = total.plus(Moments(*(shape.density * value for value in moments(shape.vertices, shape.radius))))
    body = pymunk.Body(body_type=_TYPES[flat.type])
    if flat.type == "dynamic":
        center = flat.center or (total.first_x / total.area, total.first_y / total.area)
        middle = total.second + center[0] * (center[0] * total.area - 2.0 * total.first_x)
        middle += center[1] * (center[1] * total.area - 2.0 * total.first_y)
        body.mass = flat.mass if flat.mass is not None else total.area
        body.moment = flat.inertia if flat.inertia is not None else middle * body.mass / total.area
        body.center_of_gravity = center
        if flat.fixed_rotation:
            body.moment = math.inf
    body.position, body.angle = flat.position, flat.angle
    if flat.type != "static":
        body.velocity, body.angular_velocity = flat.velocity, flat.angular_velocity
    space.add(body, *(_build_shape(body, shape) for shape in flat.shapes))
    return body


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
    return shape
