"""pymunk, with its steps as short as our substeps: four calls of `Space.step` for one step, 10 iterations in each.

Its `collision_slop` of 0.1 is meant for pixels; it gets 5 mm, which is what Box2D has. Friction and elasticity of a
pair are products in pymunk, so both shapes get the square root of what the pair is to have.
"""

from __future__ import annotations

import math

import pymunk

from sandbox.reference.space import build_space
from sandbox.scene.flat import FlatJoint, FlatScene, FlatShape, Vec
from tests.physics.truth.experiment import RATE, LacksError

NAME = f"pymunk {pymunk.version}"
SLOP = 0.005


class PymunkRun:
    """A `Run` of pymunk."""

    def __init__(self, scene: FlatScene) -> None:
        if scene.regions:
            raise LacksError("pymunk has no fluids")
        self._substeps = scene.settings.substeps
        self._space, bodies = build_space(scene)
        self._space.collision_slop = SLOP
        self._bodies = {flat.id: body for flat, body in zip(scene.bodies, bodies, strict=True)}
        for flat in scene.bodies:
            # A pymunk body has its shapes in a set, a space in the order in which they came.
            own = [shape for shape in self._space.shapes if shape.body is self._bodies[flat.id]]
            for shape, described in zip(own, flat.shapes, strict=True):
                _give_surface(shape, described)
        self._space.add(*(self._build_joint(flat) for flat in scene.joints))

    def step(self, steps: int = 1) -> None:
        for _ in range(steps * self._substeps):
            self._space.step(1.0 / (RATE * self._substeps))

    def place(self, name: str) -> Vec:
        body = self._bodies[name]
        x, y = body.local_to_world(body.center_of_gravity)
        return x, y

    def angle(self, name: str) -> float:
        return self._bodies[name].angle

    def velocity(self, name: str) -> Vec:
        x, y = self._bodies[name].velocity
        return x, y

    def spin(self, name: str) -> float:
        return self._bodies[name].angular_velocity

    def _build_joint(self, flat: FlatJoint) -> pymunk.Constraint:
        ground = self._space.static_body
        a, b = (ground if name is None else self._bodies[name] for name in (flat.body_a, flat.body_b))
        joint: pymunk.Constraint
        if flat.kind == "revolute":
            joint = pymunk.PivotJoint(a, b, flat.anchor_a)
        elif flat.kind == "distance":
            joint = pymunk.PinJoint(a, b, a.world_to_local(flat.anchor_a), b.world_to_local(flat.anchor_b))
        else:
            raise ValueError(f"{flat.id}: no experiment has needed a {flat.kind} joint yet")
        joint.collide_bodies = flat.collide
        return joint


def _give_surface(shape: pymunk.Shape, described: FlatShape) -> None:
    shape.elasticity = math.sqrt(described.restitution)
    # One vector for the whole shape: right for a belt that is only touched from above.
    shape.surface_velocity = (described.surface_speed, 0.0)
