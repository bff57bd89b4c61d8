"""R.U.B.E. scenes, as b2dJson writes them.

Source: `b2dJson.cpp` of iforce2d/b2dJson (its loader tells the defaults), and `loadrube.js` for what the loaders do
with files that leave out more than the editor does.
"""

from __future__ import annotations

from typing import Any

from sandbox.formats.box2d.scene import write_world
from sandbox.formats.box2d.world import Body, BodyType, Fixture, MassData, Outline, World
from sandbox.formats.draft import Draft
from sandbox.formats.reading import MisreadError
from sandbox.formats.remarks import Remarks
from sandbox.formats.rube_joints import rube_joints
from sandbox.formats.rube_node import RubeNode, note_properties

_TYPES: tuple[BodyType, ...] = ("static", "kinematic", "dynamic")


def is_rube(data: Any) -> bool:
    """Whether parsed JSON is the export of a R.U.B.E. scene."""
    return isinstance(data, dict) and isinstance(data.get("body"), list) and not {"bodies", "layers"} & data.keys()


def read_rube(data: dict[str, Any], draft: Draft) -> None:
    """Bring all of the file into the draft. Raises `MisreadError`."""
    root = RubeNode(data)
    remarks = draft.remarks
    write_world(_world(root, remarks), draft)
    for image in root.nodes("image"):
        remarks.note(image.place, "images are left out")
    _note_settings(root, remarks)


def _world(root: RubeNode, remarks: Remarks) -> World:
    return World(
        gravity=root.vector("gravity"),
        sleeping=root.flag("allowSleep", True),
        warm_starting=root.flag("warmStarting", True),
        step_rate=root.number("stepsPerSecond"),
        bodies=[_body(node, remarks) for node in root.nodes("body")],
        joints=rube_joints(root, remarks),
    )


def _note_settings(root: RubeNode, remarks: Remarks) -> None:
    for key in ("velocityIterations", "positionIterations"):
        if root.has(key):
            remarks.note("", "numbers of iterations are left out: this engine has substeps")
    if not root.flag("continuousPhysics", True):
        remarks.note("", "continuous physics cannot be switched off: nothing passes through what is static")
    if root.flag("subStepping"):
        remarks.note("", "sub-stepping is left out")
    note_properties(root, remarks)


def _body(node: RubeNode, remarks: Remarks) -> Body:
    kind = node.whole("type")
    if kind not in (0, 1, 2):
        raise MisreadError((*node.path, "type"), "must be 0 (static), 1 (kinematic) or 2 (dynamic)")
    note_properties(node, remarks)
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


def _mass(node: RubeNode) -> MassData | None:
    if not node.has("massData-mass"):
        return None
    return MassData(node.number("massData-mass"), node.vector("massData-center"), node.number("massData-I"))


def _fixture(node: RubeNode, remarks: Remarks) -> Fixture | None:
    outline = _outline(node)
    note_properties(node, remarks)
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


def _outline(node: RubeNode) -> Outline | None:
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


def _ghosted(node: RubeNode, line: Outline, before: tuple[str, str], after: tuple[str, str]) -> Outline:
    line.before = node.vector(before[1]) if node.flag(before[0]) else None
    line.after = node.vector(after[1]) if node.flag(after[0]) else None
    return line
