"""A scene that pymunk steps, with bodies that come and go."""

from __future__ import annotations

import math
from collections.abc import Iterable

import pymunk

from sandbox.reference.ask_pymunk import PYMUNK_VERSION
from sandbox.reference.led import Led
from sandbox.reference.run import Pose, left_out, one_way_shapes, other_joints
from sandbox.reference.space import add_body
from sandbox.reference.space_joints import KINDS, add_joint
from sandbox.scene.flat import FlatBody, FlatJoint, FlatScene, Vec

_SECONDS_TO_SLEEP = 0.5
_NOBODY = pymunk.ShapeFilter(categories=0, mask=0)


class PymunkRun:
    """A space of pymunk at `iterations` a step and else at its defaults. It sleeps where the scene does, unless it is
    told not to."""

    label = f"pymunk {PYMUNK_VERSION}"

    def __init__(self, scene: FlatScene, iterations: int = 10, sleeps: bool = True) -> None:
        self._space = pymunk.Space()
        self._space.gravity = scene.gravity
        self._space.iterations = iterations
        if sleeps and scene.settings.sleeping:
            self._space.sleep_time_threshold = _SECONDS_TO_SLEEP
        self._seconds = 1.0 / scene.settings.step_rate
        self._bodies: dict[str | None, pymunk.Body] = {}
        self._led = Led(scene.settings.step_rate)
        self._notes = dict.fromkeys(left_out(scene))
        self.add(scene.bodies, scene.joints)

    @property
    def notes(self) -> tuple[str, ...]:
        """What of all that was brought in pymunk does otherwise or leaves out, a line each."""
        return tuple(self._notes)

    def add(self, bodies: Iterable[FlatBody], joints: Iterable[FlatJoint]) -> None:
        """Bring bodies and joints in. One-way shapes are solid from both sides."""
        bodies, joints = self._led.add(bodies), tuple(joints)
        self._notes |= dict.fromkeys([*one_way_shapes(bodies, chains=True), *other_joints(joints, KINDS)])
        for body in bodies:
            self._bodies[body.id] = add_body(self._space, body, solid=True)
        for joint in joints:
            add_joint(self._space, joint, self._bodies.get(joint.body_a), self._bodies.get(joint.body_b))

    def remove(self, names: Iterable[str]) -> None:
        """Take bodies out, with all that holds them."""
        names = tuple(names)
        self._led.remove(names)
        for name in names:
            body = self._bodies.pop(name)
            # pymunk's bodies know a constraint until garbage collection takes it, which may be long after its removal.
            holding = [constraint for constraint in body.constraints if constraint in self._space.constraints]
            self._space.remove(body, *body.shapes, *holding)

    def set_velocity(self, name: str, velocity: Vec, angular_velocity: float) -> None:
        """Give a body a velocity (m/s) and an angular velocity (rad/s)."""
        self._bodies[name].velocity, self._bodies[name].angular_velocity = velocity, angular_velocity

    def step(self) -> None:
        """Go on by one step."""
        self._led.lead(self)
        self._space.step(self._seconds)

    def pose(self, name: str) -> Pose:
        """Where a body is and how it moves."""
        body = self._bodies[name]
        return Pose(*body.position, math.cos(body.angle), math.sin(body.angle), *body.velocity, body.angular_velocity)

    def close(self) -> None:
        """Let go of all contacts. Nothing can be done with the run after it.

        Chipmunk frees a space shape by shape and goes through all contacts for each: minutes, where there are many.
        """
        for shape in self._space.shapes:
            shape.filter = _NOBODY
        self._space.collision_persistence = 0
        self._space.step(self._seconds)
        self._space.step(self._seconds)
