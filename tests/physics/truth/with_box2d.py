"""Box2D by its binding pyb2d3, with as many substeps as ours and its own contact stiffness and damping.

The slowest impact that bounces is set to ours (its default is 1 m/s). It calculates in single precision.
"""

from __future__ import annotations

from importlib.metadata import version
from typing import Any

import pyb2d3 as box2d

from sandbox.scene.flat import FlatBody, FlatJoint, FlatScene, FlatShape, Vec
from tests.physics.truth.experiment import RATE, LacksError

NAME = f"Box2D (pyb2d3 {version('pyb2d3')})"
_TYPES = {
    "static": box2d.BodyType.STATIC, "kinematic": box2d.BodyType.KINEMATIC, "dynamic": box2d.BodyType.DYNAMIC,
}  # fmt: skip


class Box2dRun:
    """A `Run` of Box2D."""

    def __init__(self, scene: FlatScene) -> None:
        if scene.regions:
            raise LacksError("Box2D has no fluids")
        self._substeps = scene.settings.substeps
        self._world = box2d.World(
            gravity=scene.gravity, restitution_threshold=scene.settings.restitution_threshold
        )  # fmt: skip
        self._world.sleeping_enabled = scene.settings.sleeping
        self._bodies = {flat.id: _build_body(self._world, flat) for flat in scene.bodies}
        self._ground = self._world.create_body(type=_TYPES["static"])
        for joint in scene.joints:
            self._build_joint(joint)

    def step(self, steps: int = 1) -> None:
        for _ in range(steps):
            self._world.step(1.0 / RATE, self._substeps)

    def place(self, name: str) -> Vec:
        x, y = self._bodies[name].world_center_of_mass()
        return x, y

    def angle(self, name: str) -> float:
        return float(self._bodies[name].angle)

    def velocity(self, name: str) -> Vec:
        x, y = self._bodies[name].linear_velocity
        return x, y

    def spin(self, name: str) -> float:
        return float(self._bodies[name].angular_velocity)

    def _build_joint(self, flat: FlatJoint) -> None:
        a, b = (self._ground if name is None else self._bodies[name] for name in (flat.body_a, flat.body_b))
        fields: dict[str, Any] = {
            "local_anchor_a": a.local_point(flat.anchor_a), "local_anchor_b": b.local_point(flat.anchor_b),
            "collide_connected": flat.collide,
        }  # fmt: skip
        if flat.kind == "revolute":
            self._world.create_revolute_joint(a, b, **fields)
        elif flat.kind == "distance":
            self._world.create_distance_joint(a, b, length=flat.length, **fields)
        else:
            raise ValueError(f"{flat.id}: no experiment has needed a {flat.kind} joint yet")


def _build_body(world: Any, flat: FlatBody) -> Any:
    if flat.mass is not None or flat.inertia is not None or flat.center is not None:
        raise ValueError(f"{flat.id}: experiments give masses by densities, which every engine takes")
    body = world.create_body(type=_TYPES[flat.type], position=flat.position, rotation=flat.angle)
    body.linear_damping, body.angular_damping = flat.linear_damping, flat.angular_damping
    for shape in flat.shapes:
        surface = box2d.surface_material(
            friction=shape.friction, restitution=shape.restitution, tangent_speed=shape.surface_speed
        )
        body.create_shape(box2d.shape_def(density=shape.density, material=surface), _outline(shape))
    # Only now: each shape moves the centre of mass, and with it the velocity.
    body.linear_velocity, body.angular_velocity = flat.velocity, flat.angular_velocity
    return body


def _outline(flat: FlatShape) -> Any:
    if len(flat.vertices) == 1:
        return box2d.circle(flat.vertices[0], flat.radius)
    if len(flat.vertices) == 2:
        return box2d.capsule(*flat.vertices, flat.radius)
    return box2d.polygon(points=flat.vertices, radius=flat.radius or None)
