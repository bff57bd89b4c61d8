"""R.U.B.E. scenes: what the editor exports (b2dJson), and what it saves for itself (`.rube`).

Source: `b2dJson.cpp` of iforce2d/b2dJson (its loader tells the defaults), `loadrube.js` for what the loaders do with
files that leave out more than the editor does, and https://www.iforce2d.net/rube/json-structure.
"""

from __future__ import annotations

from typing import Any

from sandbox.formats.box2d.scene import write_world
from sandbox.formats.box2d.terms import TYPES, body_of, note_unread
from sandbox.formats.box2d.world import Body, MassData, World
from sandbox.formats.draft import Draft
from sandbox.formats.reading import MisreadError
from sandbox.formats.remarks import Remarks
from sandbox.formats.rube_joints import rube_joints
from sandbox.formats.rube_node import RubeNode, note_properties
from sandbox.formats.rube_shapes import drawn_fixtures, exported_fixtures

_WORLD = {"gravity", "velocityIterations", "positionIterations", "stepsPerSecond"}
_OF_THE_EDITOR = ("exportOptions", "autoClearForces", "collisionbitplanes", "hasDestructionListener",
                  "hasContactFilter", "hasContactListener", "id", "path")  # fmt: skip
"""What is of the program that made the file, or of the one that loads it."""


def is_rube(data: Any) -> bool:
    """Whether parsed JSON is a scene of R.U.B.E., exported or saved."""
    if not isinstance(data, dict) or {"bodies", "layers"} & data.keys():
        return False
    return isinstance(data.get("body"), list) or isinstance(data.get("metaworld"), dict) or data.keys() >= _WORLD


def read_rube(data: dict[str, Any], draft: Draft) -> None:
    """Bring all of the file into the draft. Raises `MisreadError`."""
    saved = isinstance(data.get("metaworld"), dict)
    root = RubeNode(data["metaworld"], ("metaworld",)) if saved else RubeNode(data)
    _Reader(root, "meta" if saved else "", draft.remarks).read(draft)


class _Reader:
    """`prefix` is what the editor puts before the names of lists in files that it saves for itself.

    There, fixtures are as they were drawn, and bodies and joints are referred to by their `id`, not by their number.
    """

    def __init__(self, root: RubeNode, prefix: str, remarks: Remarks) -> None:
        self._root, self._prefix, self._remarks = root, prefix, remarks

    def read(self, draft: Draft) -> None:
        root, remarks = self._root, self._remarks
        write_world(self._world(), draft)
        for image in root.nodes(self._prefix + "image"):
            remarks.note(image.place, "images are left out")
        for copied in root.nodes("metaobject"):
            remarks.note(copied.place, "objects of other files are left out: export the scene in R.U.B.E.")
        _note_settings(root, remarks)

    def _world(self) -> World:
        root = self._root
        by_id = bool(self._prefix)
        bodies, joints = (list(root.nodes(self._prefix + name)) for name in ("body", "joint"))
        numbers = {node.whole("id", k) if by_id else k: k for k, node in enumerate(bodies)}
        return World(
            gravity=root.vector("gravity"),
            sleeping=root.flag("allowSleep", True),
            warm_starting=root.flag("warmStarting", True),
            step_rate=root.number("stepsPerSecond"),
            bodies=[self._body(node) for node in bodies],
            joints=rube_joints(joints, numbers, by_id, self._remarks),
        )

    def _body(self, node: RubeNode) -> Body:
        body = body_of(node, TYPES[_type(node)], node.text("name"))
        body.awake = node.flag("awake", body.type == "static")
        body.active = node.flag("active", True)
        if node.has("massData-mass"):
            body.mass_data = MassData(
                node.number("massData-mass"), node.vector("massData-center"), node.number("massData-I")
            )
        made = drawn_fixtures if self._prefix else exported_fixtures
        for each in node.nodes("fixture"):
            note_properties(each, self._remarks)
            body.fixtures += made(each, self._remarks)
            note_unread(each, self._remarks, "path", "id")
        note_properties(node, self._remarks)
        note_unread(node, self._remarks, "path", "id", "massData-I", "massData-center")
        return body


def _type(node: RubeNode) -> int:
    """0 to 2, or the word for it in saved files."""
    given = node.value("type")
    if given in TYPES:
        return TYPES.index(given)
    kind = -1 if isinstance(given, str) else node.whole("type")
    if kind not in (0, 1, 2):
        raise MisreadError((*node.path, "type"), "must be 0 (static), 1 (kinematic) or 2 (dynamic)")
    return kind


def _note_settings(root: RubeNode, remarks: Remarks) -> None:
    if root.has("velocityIterations") | root.has("positionIterations"):
        remarks.note("", "numbers of iterations are left out: this engine has substeps")
    if not root.flag("continuousPhysics", True):
        remarks.note("", "continuous physics cannot be switched off: nothing passes through what is static")
    if root.flag("subStepping"):
        remarks.note("", "sub-stepping is left out")
    note_properties(root, remarks)
    note_unread(root, remarks, *_OF_THE_EDITOR)
