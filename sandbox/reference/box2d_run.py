"""A scene that Box2D steps, by way of pyb2d3 (the `bench` extra)."""

from __future__ import annotations

import importlib.metadata
import math
from collections.abc import Iterable
from typing import Any

from sandbox.errors import MissingDependencyError
from sandbox.reference.box2d_shapes import add_shapes
from sandbox.reference.led import Led
from sandbox.reference.own_mass import own_mass
from sandbox.reference.run import Pose, left_out, one_way_shapes, other_joints
from sandbox.scene.flat import FlatBody, FlatJoint, FlatScene, Vec

_HERTZ, _DAMPING_RATIO = 30.0, 10.0
"""Box2D's own stiffness of contacts, which cannot be left as it is where the speed of pushing out is set."""

_JOINT_KINDS = ("revolute", "weld", "distance")
_WIDEST = 0.99 * math.pi
"""Box2D's widest limits of a hinge, rad."""
_SAME_ANGLE = 1e-3
_STRONGEST = 1e30
"""Stands for motors and springs without a bound, in single precision."""


def require_pyb2d3() -> Any:
    """The package pyb2d3. Raises `MissingDependencyError` where it is not installed."""
    try:
        import pyb2d3
    except ImportError as error:
        text = "Box2D is reached through pyb2d3, which is not installed: python -m pip install pyb2d3"
        raise MissingDependencyError(text) from error
    return pyb2d3


class Box2dRun:
    """A world of Box2D, on one thread, with the scene's substeps and its own contacts of 30 Hz.

    Raises `MissingDependencyError` without pyb2d3.
    """

    def __init__(self, scene: FlatScene) -> None:
        self._b2 = require_pyb2d3()
        self.label = f"Box2D (pyb2d3 {importlib.metadata.version('pyb2d3')})"
        settings = scene.settings
        self._unit = settings.units_per_meter
        self._b2.set_length_units_per_meter(self._unit)  # of the process
        threshold = settings.restitution_threshold * self._unit
        self._world = self._b2.World(gravity=scene.gravity, restitution_threshold=threshold)
        self._world.sleeping_enabled = settings.sleeping
        self._world.set_contact_tuning(_HERTZ, _DAMPING_RATIO, settings.push_out_speed * self._unit)
        self._seconds, self._substeps = 1.0 / settings.step_rate, settings.substeps
        self._types = {
            "static": self._b2.BodyType.STATIC, "kinematic": self._b2.BodyType.KINEMATIC,
            "dynamic": self._b2.BodyType.DYNAMIC,
        }  # fmt: skip
        self._bodies: dict[str | None, Any] = {None: self._world.create_body(self._b2.body_def())}
        self._led = Led(scene.settings.step_rate)
        self._notes = dict.fromkeys(left_out(scene))
        self.add(scene.bodies, scene.joints)

    @property
    def notes(self) -> tuple[str, ...]:
        """What of all that was brought in Box2D does otherwise or leaves out, a line each."""
        return tuple(self._notes)

    def add(self, bodies: Iterable[FlatBody], joints: Iterable[FlatJoint]) -> None:
        """Bring bodies and joints in."""
        bodies, joints = self._led.add(bodies), tuple(joints)
        self._notes |= dict.fromkeys([*one_way_shapes(bodies, chains=False), *other_joints(joints, _JOINT_KINDS)])
        for body in bodies:
            self._bodies[body.id] = self._add_body(body)
        for joint in joints:
            self._add_joint(joint)

    def remove(self, names: Iterable[str]) -> None:
        """Take bodies out, with the joints that hold them."""
        names = tuple(names)
        self._led.remove(names)
        for name in names:
            self._bodies.pop(name).destroy()

    def set_velocity(self, name: str, velocity: Vec, angular_velocity: float) -> None:
        """Give a body a velocity (m/s) and an angular velocity (rad/s)."""
        body = self._bodies[name]
        body.linear_velocity, body.angular_velocity = velocity, angular_velocity

    def step(self) -> None:
        """Go on by one step."""
        self._led.lead(self)
        self._world.step(self._seconds, self._substeps)

    def pose(self, name: str) -> Pose:
        """Where a body is and how it moves."""
        body = self._bodies[name]
        at, velocity, turn = body.position, body.linear_velocity, body.rotation
        return Pose(at.x, at.y, turn.c, turn.s, velocity.x, velocity.y, body.angular_velocity)

    def close(self) -> None:
        """Give back what it holds; nothing else may be asked after it."""
        self._bodies.clear()

    def _add_body(self, flat: FlatBody) -> Any:
        definition = self._b2.body_def(
            type=self._types[flat.type], position=flat.position, rotation=self._b2.Rot(flat.angle),
            linear_velocity=flat.velocity, angular_velocity=flat.angular_velocity, gravity_scale=flat.gravity_scale,
            linear_damping=flat.linear_damping, angular_damping=flat.angular_damping, is_bullet=flat.bullet,
            fixed_rotation=flat.fixed_rotation, enable_sleep=flat.sleep_speed > 0.0,
            sleep_threshold=flat.sleep_speed * self._unit,
        )  # fmt: skip
        body = self._world.create_body(definition)
        add_shapes(self._b2, body, flat.shapes)
        if flat.type == "dynamic" and (flat.mass, flat.inertia, flat.center) != (None, None, None):
            data = self._b2.MassData()
            data.mass, data.center, data.rotational_inertia = own_mass(flat)
            body.mass_data = data
        return body

    def _add_joint(self, flat: FlatJoint) -> None:
        a, b = self._bodies[flat.body_a], self._bodies[flat.body_b]
        given: dict[str, Any] = {
            "local_anchor_a": a.local_point(flat.anchor_a), "local_anchor_b": b.local_point(flat.anchor_b),
            "collide_connected": flat.collide,
        }  # fmt: skip
        start = b.angle - a.angle
        if flat.hertz is not None and flat.kind == "revolute" and abs(start + flat.rest) > _SAME_ANGLE:
            self._notes["springs of hinges draw both bodies to the same angle: pyb2d3 lets no other be set"] = None
        if flat.kind == "revolute":
            self._world.create_revolute_joint(a, b, **given, **_about_the_hinge(flat, start))
        elif flat.kind == "weld":
            hertz = {"linear_hertz": flat.hertz or 0.0, "angular_hertz": flat.angular_hertz}
            self._world.create_weld_joint(a, b, **given, reference_angle=start, **hertz)
        elif flat.kind == "distance":
            self._world.create_distance_joint(a, b, **given, **_along_the_rod(flat))


def _about_the_hinge(flat: FlatJoint, start: float) -> dict[str, Any]:
    """Limits, motor and spring of a hinge whose bodies are turned by `start` against each other (rad)."""
    found: dict[str, Any] = {"reference_angle": start}
    if math.isfinite(flat.lower) or math.isfinite(flat.upper):
        found |= {
            "enable_limit": True,
            "lower_angle": max(flat.lower, -_WIDEST),
            "upper_angle": min(flat.upper, _WIDEST),
        }
    if flat.motor_speed is not None:
        torque = min(flat.max_motor, _STRONGEST)
        found |= {"enable_motor": True, "motor_speed": flat.motor_speed, "max_motor_torque": torque}
    if flat.hertz is not None:
        found |= {"enable_spring": True, "hertz": flat.hertz, "damping_ratio": flat.damping_ratio}
    return found


def _along_the_rod(flat: FlatJoint) -> dict[str, Any]:
    length = flat.length if flat.length is not None else math.dist(flat.anchor_a, flat.anchor_b)
    found: dict[str, Any] = {"length": length}
    if math.isfinite(flat.lower) or math.isfinite(flat.upper):
        found |= {"enable_limit": True, "min_length": max(flat.lower, 0.0), "max_length": min(flat.upper, _STRONGEST)}
        found |= {"enable_spring": True, "hertz": 0.0}
    if flat.hertz is not None:
        found |= {"enable_spring": True, "hertz": flat.hertz, "damping_ratio": flat.damping_ratio}
    return found
