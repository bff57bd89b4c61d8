"""R.U.B.E. scenes, as b2dJson writes them.

Source: `b2dJson.cpp` of iforce2d/b2dJson (its loader tells the defaults), and `loadrube.js` for what the loaders do
with files that leave out more than the editor does.
"""

from __future__ import annotations

import re
import struct
from typing import Any

import numpy as np

from sandbox.formats.box2d.scene import write_world
from sandbox.formats.box2d.world import Body, BodyType, Fixture, Joint, MassData, Outline, Spring, World
from sandbox.formats.draft import Draft
from sandbox.formats.reading import MisreadError, Node
from sandbox.formats.remarks import Remarks
from sandbox.scene.finding import Path

_TYPES: tuple[BodyType, ...] = ("static", "kinematic", "dynamic")
_HEX = re.compile(r"[0-9A-Fa-f]{8}")
_LIMITED = {"revolute", "prismatic", "wheel"}


def is_rube(data: Any) -> bool:
    """Whether parsed JSON is the export of a R.U.B.E. scene."""
    return isinstance(data, dict) and isinstance(data.get("body"), list) and not {"bodies", "layers"} & data.keys()


def read_rube(data: dict[str, Any], draft: Draft) -> None:
    """Bring all of the file into the draft. Raises `MisreadError`."""
    root = _RubeNode(data)
    remarks = draft.remarks
    write_world(_world(root, remarks), draft)
    for image in root.nodes("image"):
        remarks.note(image.place, "images are left out")
    _note_settings(root, remarks)


class _RubeNode(Node):
    """Numbers of 32 bits: as decimals, or as the eight hexadecimal digits of their bytes."""

    def number_of(self, value: Any, path: Path) -> float:
        if isinstance(value, str) and _HEX.fullmatch(value):
            value = struct.unpack(">f", bytes.fromhex(value))[0]
        number = super().number_of(value, path)
        with np.errstate(over="ignore"):
            short = np.float32(number)
        # 0.20000000298023224 is what a float makes of 0.2: the shortest decimal that is the same float.
        return float(str(short)) if float(short) == number else number


def _world(root: _RubeNode, remarks: Remarks) -> World:
    return World(
        gravity=root.vector("gravity"),
        sleeping=root.flag("allowSleep", True),
        warm_starting=root.flag("warmStarting", True),
        step_rate=root.number("stepsPerSecond"),
        bodies=[_body(node, remarks) for node in root.nodes("body")],
        joints=_joints(root, remarks),
    )


def _note_settings(root: _RubeNode, remarks: Remarks) -> None:
    for key in ("velocityIterations", "positionIterations"):
        if root.has(key):
            remarks.note("", "numbers of iterations are left out: this engine has substeps")
    if not root.flag("continuousPhysics", True):
        remarks.note("", "continuous physics cannot be switched off: nothing passes through what is static")
    if root.flag("subStepping"):
        remarks.note("", "sub-stepping is left out")
    _note_properties(root, remarks)


def _note_properties(node: _RubeNode, remarks: Remarks) -> None:
    if node.data.get("customProperties"):
        remarks.note(node.place, "custom properties are left out")


def _body(node: _RubeNode, remarks: Remarks) -> Body:
    kind = node.whole("type")
    if kind not in (0, 1, 2):
        raise MisreadError((*node.path, "type"), "must be 0 (static), 1 (kinematic) or 2 (dynamic)")
    _note_properties(node, remarks)
    return Body(
        place=node.place,
        name=node.text("name"),
        type=_TYPES[kind],
        position=node.vector("position"),
        angle=node.number("angle"),
        velocity=node.vector("linearVelocity"),
        spin=node.number("angularVelocity"),
        linear_damping=node.number("linearDamping"),
        angular_damping=node.number("angularDamping"),
        gravity_scale=node.number("gravityScale", 1.0),
        fixed_rotation=node.flag("fixedRotation"),
        bullet=node.flag("bullet"),
        allow_sleep=node.flag("allowSleep", True),
        awake=node.flag("awake", kind == 0),
        active=node.flag("active", True),
        mass_data=_mass(node),
        fixtures=[made for each in node.nodes("fixture") if (made := _fixture(each, remarks))],
    )


def _mass(node: _RubeNode) -> MassData | None:
    if not node.has("massData-mass"):
        return None
    return MassData(node.number("massData-mass"), node.vector("massData-center"), node.number("massData-I"))


def _fixture(node: _RubeNode, remarks: Remarks) -> Fixture | None:
    outline = _outline(node)
    _note_properties(node, remarks)
    if outline is None:
        remarks.note(node.place, "a fixture without a circle, polygon, edge or chain is left out")
        return None
    return Fixture(
        place=node.place,
        outline=outline,
        density=node.number("density"),
        friction=node.number("friction"),
        restitution=node.number("restitution"),
        sensor=node.flag("sensor"),
        category=node.whole("filter-categoryBits", 1),
        mask=node.whole("filter-maskBits", 0xFFFF),
        group=node.whole("filter-groupIndex"),
    )


def _outline(node: _RubeNode) -> Outline | None:
    if circle := node.node("circle"):
        return Outline("circle", [circle.vector("center")], circle.number("radius"))
    if edge := node.node("edge"):
        ends = [edge.vector("vertex1"), edge.vector("vertex2")]
        return _ghosted(edge, Outline("chain", ends), ("hasVertex0", "vertex0"), ("hasVertex3", "vertex3"))
    if loop := node.node("loop"):
        return Outline("chain", loop.points("vertices"), closed=True)
    if chain := node.node("chain"):
        points = chain.points("vertices")
        if len(points) > 3 and points[0] == points[-1]:
            return Outline("chain", points[:-1], closed=True)
        line = Outline("chain", points)
        return _ghosted(chain, line, ("hasPrevVertex", "prevVertex"), ("hasNextVertex", "nextVertex"))
    if polygon := node.node("polygon"):
        return Outline("polygon", polygon.points("vertices"))
    return None


def _ghosted(node: _RubeNode, line: Outline, before: tuple[str, str], after: tuple[str, str]) -> Outline:
    line.before = node.vector(before[1]) if node.flag(before[0]) else None
    line.after = node.vector(after[1]) if node.flag(after[0]) else None
    return line


def _joints(root: _RubeNode, remarks: Remarks) -> list[Joint]:
    """Gears last: their numbers count so, as b2dJson writes and reads them."""
    nodes = list(root.nodes("joint"))
    for node in nodes:
        _note_properties(node, remarks)
    return [_joint(node) for node in sorted(nodes, key=lambda node: node.text("type") == "gear")]


def _joint(node: _RubeNode) -> Joint:
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


def _spring(node: _RubeNode, kind: str) -> Spring:
    hertz, ratio = ("springFrequency", "springDampingRatio") if kind == "wheel" else ("frequency", "dampingRatio")
    return Spring(node.number(hertz), node.number(ratio), node.number("stiffness"), node.number("damping"))


def _more(node: _RubeNode, joint: Joint) -> None:
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
