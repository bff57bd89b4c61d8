"""Joints of R.U.B.E. scenes."""

from __future__ import annotations

from sandbox.formats.box2d.terms import note_unread
from sandbox.formats.box2d.world import Joint, Spring
from sandbox.formats.remarks import Remarks
from sandbox.formats.rube_node import RubeNode, note_properties

_LIMITED = {"revolute", "prismatic", "wheel"}
_OUTCOMES = ("jointSpeed", "path", "id")
"""What the editor tells of a joint that is no property of it."""

Numbers = dict[int, int]
"""The number of a body, or joint, by what a file calls it."""


def rube_joints(nodes: list[RubeNode], bodies: Numbers, by_id: bool, remarks: Remarks) -> list[Joint]:
    """Gears last: where joints have no ids, their numbers count so, as b2dJson writes and reads them."""
    ordered = sorted(nodes, key=lambda node: node.text("type") == "gear")
    joints = {node.whole("id", k) if by_id else k: k for k, node in enumerate(ordered)}
    return [_joint(node, bodies, joints, remarks) for node in ordered]


def _joint(node: RubeNode, bodies: Numbers, joints: Numbers, remarks: Remarks) -> Joint:
    kind = node.text("type")
    joint = Joint(
        place=node.place,
        name=node.text("name"),
        kind=kind,
        a=bodies.get(node.whole("bodyA", -1), -1),
        b=bodies.get(node.whole("bodyB", -1), -1),
        collide=node.flag("collideConnected"),
        anchor_a=node.vector("anchorA"),
        anchor_b=node.vector("anchorB"),
        axis=node.vector("localAxisA", node.vector("localAxis1", (1.0, 0.0))),
        reference_angle=node.number("refAngle", node.number("referenceAngle")),
        length=node.number("maxLength" if kind == "rope" else "length"),
        spring=_spring(node, kind),
        ratio=node.number("ratio", 1.0),
        max_force=node.strength("maxForce"),
        max_torque=node.strength("maxTorque"),
    )
    if kind in _LIMITED:
        _bound(node, joint)
    _more(node, joint, joints)
    note_properties(node, remarks)
    note_unread(node, remarks, *_OUTCOMES)
    return joint


def _bound(node: RubeNode, joint: Joint) -> None:
    """Limits and motor, which stand there switched off as well."""
    limits = node.number("lowerLimit"), node.number("upperLimit")
    if node.flag("enableLimit"):
        joint.lower, joint.upper = limits
    speed = node.number("motorSpeed")
    strength = {key: node.strength(key) for key in ("maxMotorForce", "maxMotorTorque")}
    if node.flag("enableMotor"):
        joint.motor_speed = speed
        joint.max_motor = strength["maxMotorForce" if joint.kind == "prismatic" else "maxMotorTorque"]


def _spring(node: RubeNode, kind: str) -> Spring:
    hertz, ratio = ("springFrequency", "springDampingRatio") if kind == "wheel" else ("frequency", "dampingRatio")
    return Spring(node.number(hertz), node.number(ratio), node.number("stiffness"), node.number("damping"))


def _more(node: RubeNode, joint: Joint, joints: Numbers) -> None:
    """What a few kinds have alone."""
    if joint.kind == "motor":
        joint.offset = node.vector("linearOffset", joint.anchor_a)  # editors before 1.7 put it there
        joint.angle = joint.reference_angle
        joint.correction = node.number("correctionFactor", 0.3)
    elif joint.kind == "mouse":
        joint.target = node.vector("target")
    elif joint.kind == "gear":
        joint.joints = joints.get(node.whole("joint1"), -1), joints.get(node.whole("joint2"), -1)
    elif joint.kind == "pulley":
        joint.ground = (node.vector("groundAnchorA"), node.vector("groundAnchorB"))
        joint.lengths = (node.number("lengthA"), node.number("lengthB"))
    elif joint.kind == "distance" and node.has("minLength") and node.has("maxLength"):
        joint.lower, joint.upper = node.number("minLength"), node.number("maxLength")  # Box2D 2.4
