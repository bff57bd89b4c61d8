"""Worlds of planck.js, as its `Serializer.toJson` writes them: a flat list in which objects refer to each other.

Source: `src/serializer` and the `_serialize` methods of piqnt/planck.js 1.x. Bodies stand there in the order opposite
to that in which they were made; the list is turned, so that a scene begins with the first.
"""

from __future__ import annotations

from typing import Any

from sandbox.formats.box2d.scene import write_world
from sandbox.formats.box2d.terms import TYPES, body_of, chain_of, edge_of, note_unread
from sandbox.formats.box2d.world import Body, Fixture, Joint, Outline, Spring, World
from sandbox.formats.draft import Draft
from sandbox.formats.reading import MisreadError, Node, place_of
from sandbox.formats.remarks import Remarks

_OF_THE_SOLVER = ("impulse", "gamma", "bias", "mass")
"""What some joints write of the step that they were in."""


def is_planck(data: Any) -> bool:
    """Whether parsed JSON is a serialised planck.js world."""
    first = data[0] if isinstance(data, list) and data else None
    return isinstance(first, dict) and isinstance(first.get("bodies"), list) and "gravity" in first


def read_planck(data: list[Any], draft: Draft) -> None:
    """Bring all of the file into the draft. Raises `MisreadError`."""
    reader = _Reader(data, draft.remarks)
    write_world(reader.world(), draft)


class _Reader:
    def __init__(self, data: list[Any], remarks: Remarks) -> None:
        self._data, self._remarks = data, remarks
        self._bodies: dict[int, int] = {}
        self._joints: dict[int, int] = {}

    def world(self) -> World:
        root = self._at(0)
        self._bodies = {index: number for number, index in enumerate(self._references(root, "bodies"))}
        self._joints = {index: number for number, index in enumerate(self._references(root, "joints"))}
        return World(
            gravity=root.vector("gravity"),
            bodies=[self._body(self._at(index)) for index in self._bodies],
            joints=[self._joint(self._at(index)) for index in self._joints],
        )

    def _at(self, index: int, path: tuple[str | int, ...] = ()) -> Node:
        if not 0 <= index < len(self._data) or not isinstance(self._data[index], dict):
            raise MisreadError(path, f"refers to entry {index}, which is no object of this file")
        return Node(self._data[index], (index,))

    def _references(self, node: Node, key: str) -> list[int]:
        return [self._index(each) for each in node.nodes(key)][::-1]

    def _index(self, reference: Node) -> int:
        index = reference.whole("refIndex", -1)
        self._at(index, reference.path)
        return index

    def _body(self, node: Node) -> Body:
        kind = next((each for each in TYPES if each == node.text("type", "static")), None)
        if kind is None:
            raise MisreadError((*node.path, "type"), 'must be "static", "kinematic" or "dynamic"')
        body = body_of(node, kind, _name(node))
        made = (self._fixture(self._at(index)) for index in self._references(node, "fixtures"))
        body.fixtures = [fixture for fixture in made if fixture]
        note_unread(node, self._remarks)
        return body

    def _fixture(self, node: Node) -> Fixture | None:
        reference = node.node("shape")
        if reference is not None and reference.has("refIndex"):
            reference = self._at(self._index(reference))
        outline = None if reference is None else _outline(reference)
        if outline is None:
            self._remarks.note(node.place, "a fixture without a circle, polygon, edge or chain is left out")
            return None
        fixture = Fixture(
            place=node.place,
            outline=outline,
            density=node.number("density"),
            friction=node.number("friction", 0.2),
            restitution=node.number("restitution"),
            sensor=node.flag("isSensor"),
            category=node.whole("filterCategoryBits", 1),
            mask=node.whole("filterMaskBits", 0xFFFF),
            group=node.whole("filterGroupIndex"),
        )
        note_unread(node, self._remarks)
        return fixture

    def _joint(self, node: Node) -> Joint:
        kind = node.text("type").removesuffix("-joint")
        joint = Joint(
            place=place_of(node.path, _name(node) or kind),
            name=_name(node),
            kind=kind,
            a=self._number(node, "bodyA", self._bodies),
            b=self._number(node, "bodyB", self._bodies),
            collide=node.flag("collideConnected"),
            anchor_a=node.vector("localAnchorA"),
            anchor_b=node.vector("localAnchorB"),
            axis=node.vector("localAxisA", (1.0, 0.0)),
            reference_angle=node.number("referenceAngle"),
            length=node.number("maxLength" if kind == "rope" else "length"),
            spring=Spring(node.number("frequencyHz"), node.number("dampingRatio")),
            ratio=node.number("ratio", 1.0),
            max_force=node.strength("maxForce"),
            max_torque=node.strength("maxTorque"),
        )
        _limits(node, joint)
        self._more(node, joint)
        note_unread(node, self._remarks, *_OF_THE_SOLVER)
        return joint

    def _more(self, node: Node, joint: Joint) -> None:
        """What a few kinds have alone."""
        if joint.kind == "motor":
            joint.offset, joint.angle = node.vector("linearOffset"), node.number("angularOffset")
            joint.correction = node.number("correctionFactor", 0.3)
        elif joint.kind == "mouse":
            joint.anchor_b, joint.target = node.vector("_localAnchorB"), node.vector("target")
        elif joint.kind == "gear":
            joint.joints = self._number(node, "joint1", self._joints), self._number(node, "joint2", self._joints)
        elif joint.kind == "pulley":
            joint.ground = (node.vector("groundAnchorA"), node.vector("groundAnchorB"))
            joint.lengths = (node.number("lengthA"), node.number("lengthB"))

    def _number(self, node: Node, key: str, known: dict[int, int]) -> int:
        """Which of the bodies, or joints, a reference means; -1 if none."""
        reference = node.node(key)
        index = reference.whole("refIndex", -1) if reference else -1
        return known.get(index, -1)


def _name(node: Node) -> str:
    """What `sandbox export` adds; planck.js has no names."""
    name = node.value("name")
    return name if isinstance(name, str) else ""


def _limits(node: Node, joint: Joint) -> None:
    slides = joint.kind == "prismatic"
    names = ("lowerTranslation", "upperTranslation") if slides else ("lowerAngle", "upperAngle")
    limits = node.number(names[0]), node.number(names[1])
    if node.flag("enableLimit"):
        joint.lower, joint.upper = limits
    speed, strength = node.number("motorSpeed"), node.strength("maxMotorForce" if slides else "maxMotorTorque")
    if node.flag("enableMotor"):
        joint.motor_speed, joint.max_motor = speed, strength


def _outline(shape: Node) -> Outline | None:
    kind = shape.text("type")
    if kind == "circle":
        return Outline("circle", [shape.vector("p")], shape.number("radius"))
    if kind in ("polygon", "box"):
        return Outline("polygon", shape.points("vertices"))
    if kind == "edge":
        return edge_of(shape)
    if kind == "chain":
        return chain_of(shape, shape.flag("isLoop"))
    return None
