"""Joints of R.U.B.E. scenes."""

from __future__ import annotations

from sandbox.formats.box2d.world import Joint, Spring
from sandbox.formats.remarks import Remarks
from sandbox.formats.rube_node import RubeNode, note_properties

_LIMITED = {"revolute", "prismatic", "wheel"}


def rube_joints(root: RubeNode, remarks: Remarks) -> list[Joint]:
    """Gears last: their numbers count so, as b2dJson writes and reads them."""
    nodes = list(root.nodes("joint"))
    for node in nodes:
        note_properties(node, remarks)
    return [_joint(node) for node in sorted(nodes, key=lambda node: node.text("type") == "gear")]


def _joint(node: RubeNode) -> Joint:
    kind = node.text("type")
    joint = Joint(
        place=node.place,
        name=node.text("name"),
        kind=kind,
        a=node.whole("bodyA", -1),
        b=node.whole("bodyB", -1),
        collide=node.flag("collideConnected"),
        anchor_a=node.vector("anchorA"),
        anchor_b=node.vector("anchorB"),
        axis=node.vector("localAxisA", node.vector("localAxis1", (1.0, 0.0))),
        reference_angle=node.number("refAngle"),
        length=node.number("maxLength" if kind == "rope" else "length"),
        spring=_spring(node, kind),
        ratio=node.number("ratio", 1.0),
        max_force=node.number("maxForce"),
        max_torque=node.number("maxTorque"),
    )
    if kind in _LIMITED and node.flag("enableLimit"):
        joint.lower, joint.upper = node.number("lowerLimit"), node.number("upperLimit")
    if kind in _LIMITED and node.flag("enableMotor"):
        joint.motor_speed = node.number("motorSpeed")
        joint.max_motor = node.number("maxMotorForce" if kind == "prismatic" else "maxMotorTorque")
    _more(node, joint)
    return joint


def _spring(node: RubeNode, kind: str) -> Spring:
    hertz, ratio = ("springFrequency", "springDampingRatio") if kind == "wheel" else ("frequency", "dampingRatio")
    return Spring(node.number(hertz), node.number(ratio), node.number("stiffness"), node.number("damping"))


def _more(node: RubeNode, joint: Joint) -> None:
    """What a few kinds have alone."""
    if joint.kind == "motor":
        joint.offset = node.vector("linearOffset", joint.anchor_a)  # editors before 1.7 put it there
        joint.angle = joint.reference_angle
        joint.correction = node.number("correctionFactor", 0.3)
    elif joint.kind == "mouse":
        joint.target = node.vector("target")
    elif joint.kind == "gear":
        joint.joints = (node.whole("joint1"), node.whole("joint2"))
    elif joint.kind == "pulley":
        joint.ground = (node.vector("groundAnchorA"), node.vector("groundAnchorB"))
        joint.lengths = (node.number("lengthA"), node.number("lengthB"))
