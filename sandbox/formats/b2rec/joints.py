"""Joints of a recording as those of a Box2D world. Frames take the place of anchors, axes and reference angles."""

from __future__ import annotations

import math

from sandbox.formats.b2rec.made import Made, Values, angle_of
from sandbox.formats.box2d.world import Body, Joint, Spring
from sandbox.formats.reading import place_of
from sandbox.formats.remarks import Remarks

_USUAL_TUNING = (60.0, 2.0)
_ANY_FORCE = 1e15
"""The most that a scene has; Box2D says "any" by the greatest number that there is."""


def joint_of(made: Made, number: int, numbers: dict[int, int], bodies: list[Body], remarks: Remarks) -> Joint:
    """The joint between the bodies, by their numbers."""
    values = made.values
    place = place_of(("joint", number), made.kind)
    (_, turn_a), (_, turn_b) = (tuple(values[key].values()) for key in ("localFrameA", "localFrameB"))
    a, b = numbers[values["bodyA"]], numbers[values["bodyB"]]
    apart = bodies[b].angle - bodies[a].angle
    joint = Joint(
        place=place,
        name="",
        kind=made.kind,
        a=a,
        b=b,
        collide=values["collideConnected"],
        anchor_a=values["localFrameA"]["p"],
        anchor_b=values["localFrameB"]["p"],
        axis=turn_a,
        # Box2D sees angles from -180 to 180 degrees.
        reference_angle=apart - math.remainder(apart + angle_of(turn_b) - angle_of(turn_a), math.tau),
    )
    if (values["constraintHertz"], values["constraintDampingRatio"]) != _USUAL_TUNING:
        remarks.note(place, "how stiff the joint itself is, is left out: joints hold here")
    if made.kind == "weld":
        joint.linear_spring = Spring(values["linearHertz"], values["linearDampingRatio"])
        joint.spring = Spring(values["angularHertz"], values["angularDampingRatio"])
    elif made.kind == "motor":
        _drive(joint, values, remarks)
    elif made.kind == "distance":
        _distance(joint, values, remarks)
    else:
        _hinge_or_slide(joint, values)
    return joint


def _hinge_or_slide(joint: Joint, values: Values) -> None:
    if values.get("enableSpring"):
        joint.spring = Spring(values["hertz"], values["dampingRatio"])
        joint.rest = values.get("targetAngle", values.get("targetTranslation"))
    if values.get("enableLimit"):
        joint.lower = values.get("lowerAngle", values.get("lowerTranslation"))
        joint.upper = values.get("upperAngle", values.get("upperTranslation"))
    if values.get("enableMotor"):
        joint.motor_speed = values["motorSpeed"]
        joint.max_motor = min(values["maxMotorForce" if joint.kind == "prismatic" else "maxMotorTorque"], _ANY_FORCE)


def _distance(joint: Joint, values: Values, remarks: Remarks) -> None:
    joint.length = values["length"]
    limited = values["enableLimit"] and values["minLength"] < values["maxLength"]
    if not values["enableSpring"] or (values["enableLimit"] and not limited):
        return  # a rod
    joint.spring = Spring(values["hertz"], values["dampingRatio"])
    if limited:
        joint.lower, joint.upper = max(values["minLength"], 0.0), values["maxLength"]
    if values["enableMotor"]:
        remarks.note(joint.place, "the motor of a distance joint is left out")
    if values["lowerSpringForce"] > -_ANY_FORCE or values["upperSpringForce"] < _ANY_FORCE:
        remarks.note(joint.place, "the greatest force of a distance joint's spring is left out")


def _drive(joint: Joint, values: Values, remarks: Remarks) -> None:
    """Springs, or friction; a scene has no joint that is both, nor one that drives a velocity."""
    pulls = values["linearHertz"] > 0.0 and values["maxSpringForce"] > 0.0
    turns = values["angularHertz"] > 0.0 and values["maxSpringTorque"] > 0.0
    rubs = values["maxVelocityForce"] > 0.0 or values["maxVelocityTorque"] > 0.0
    if pulls or turns:
        joint.kind = "drive"
        joint.linear_spring = Spring(values["linearHertz"], values["linearDampingRatio"])
        joint.spring = Spring(values["angularHertz"], values["angularDampingRatio"])
        joint.max_force = min(values["maxSpringForce"], _ANY_FORCE) if pulls else 0.0
        joint.max_torque = min(values["maxSpringTorque"], _ANY_FORCE) if turns else 0.0
        if rubs:
            remarks.note(joint.place, "the velocity that a motor joint drives is left out: its springs are kept")
        return
    joint.kind = "friction"
    joint.max_force = min(values["maxVelocityForce"], _ANY_FORCE)
    joint.max_torque = min(values["maxVelocityTorque"], _ANY_FORCE)
    if values["linearVelocity"] != (0.0, 0.0) or values["angularVelocity"]:
        remarks.note(joint.place, "the velocity that a motor joint drives is left out: it brakes")
