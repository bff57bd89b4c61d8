"""A scene as a world of planck.js, as its `Serializer.fromJson` reads it.

Source: `src/serializer/index.ts` of piqnt/planck.js 1.x: a list of objects that refer to each other by number, the
world first; bodies, fixtures and joints stand in the order opposite to that in which they are made. Fields of bodies
that the serializer does not write, such as damping, its reader takes all the same.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from sandbox.formats.export.common import note_foreign, note_settings
from sandbox.formats.export.planck_joints import PlanckJoint
from sandbox.formats.export.planck_shapes import planck_shapes, vector
from sandbox.formats.remarks import Remarks
from sandbox.scene.flat import FlatBody, FlatJoint, FlatShape
from sandbox.scene.scene import Scene

_ALL = 0xFFFFFFFF
_SLOW = 1.0
"""`Settings.velocityThreshold`, m/s."""


def planck_text(scene: Scene, remarks: Remarks) -> str:
    """The JSON of the world."""
    flat = scene.flatten()
    note_foreign(flat, remarks)
    note_settings(scene, remarks, {"units_per_meter"})
    if scene.settings.restitution_threshold != _SLOW and any(s.restitution for b in flat.bodies for s in b.shapes):
        remarks.note("", f"impacts slower than {_SLOW:g} m/s do not bounce there")
    shapes = [shape for body in scene.bodies for shape in body.shapes]
    if any(getattr(shape, "ghosts", None) for shape in shapes):
        remarks.note("", "ghosts of chains are left out")
    if flat.settings.units_per_meter != 1.0:
        remarks.note("", f"set Settings.lengthUnitsPerMeter = {flat.settings.units_per_meter:g} there")
    writer = _Writer(remarks)
    writer.write_bodies(flat.bodies, any(None in (each.body_a, each.body_b) for each in flat.joints))
    writer.write_joints(flat.joints)
    return json.dumps(writer.finished(flat.gravity), indent=1, allow_nan=False) + "\n"


class _Writer:
    def __init__(self, remarks: Remarks) -> None:
        self._remarks = remarks
        self._entries: list[dict[str, Any]] = [{}]
        self._bodies: list[int] = []
        self._joints: list[int] = []
        self._flat: dict[str | None, FlatBody] = {}
        self._index: dict[str | None, int] = {}
        self._joint_index: dict[str, int] = {}
        self._joined: dict[str, FlatJoint] = {}

    def finished(self, gravity: tuple[float, float]) -> list[dict[str, Any]]:
        self._entries[0] = {
            "gravity": vector(gravity), "bodies": [_reference(index, "Body") for index in reversed(self._bodies)],
            "joints": [_reference(index, "Joint") for index in reversed(self._joints)],
        }  # fmt: skip
        return self._entries

    def write_bodies(self, bodies: Sequence[FlatBody], with_world: bool) -> None:
        for body in bodies:
            fixtures = [self._fixture(*part) for part in planck_shapes(body.shapes, self._remarks, body.id)]
            self._flat[body.id] = body
            self._index[body.id] = self._add(_body(body, fixtures))
            self._bodies.append(self._index[body.id])
            if None not in (body.mass, body.inertia, body.center) or (body.mass is not None):
                self._remarks.note(body.id, "a mass of its own is left out: it is that of the shapes")
        if with_world:  # what joints to the world hold on to
            self._index[None] = self._add({"type": "static", "position": vector((0.0, 0.0)), "angle": 0.0,
                                           "fixtures": []})  # fmt: skip
            self._bodies.append(self._index[None])

    def write_joints(self, joints: Sequence[FlatJoint]) -> None:
        for joint in sorted(joints, key=lambda each: each.kind == "gear"):
            a, b = self._flat.get(str(joint.body_a)), self._flat.get(str(joint.body_b))
            data = PlanckJoint(joint, a, b, self._remarks).data()
            coupled = self._coupled(joint) if joint.kind == "gear" else {}
            if data is None or coupled is None:
                continue
            ends = {key: _reference(self._index[name], "Body") for key, name in
                    (("bodyA", joint.body_a), ("bodyB", joint.body_b)) if name in self._index}  # fmt: skip
            self._joint_index[joint.id] = self._add({**data, **ends, **coupled})
            self._joined[joint.id] = joint
            self._joints.append(self._joint_index[joint.id])

    def _coupled(self, gear: FlatJoint) -> dict[str, Any] | None:
        """What a gear of planck.js holds: two joints, and the second body of each."""
        names = gear.joints or ("", "")
        if not all(name in self._joint_index for name in names):
            self._remarks.note(gear.id, "a gear is left out: one of its joints is")
            return None
        one, two = (self._joined[name].body_b for name in names)
        return {
            "bodyA": _reference(self._index[one], "Body"), "bodyB": _reference(self._index[two], "Body"),
            "joint1": _reference(self._joint_index[names[0]], "Joint"),
            "joint2": _reference(self._joint_index[names[1]], "Joint"),
        }  # fmt: skip

    def _fixture(self, shape: FlatShape, geometry: dict[str, Any], share: float) -> int:
        data = {
            "friction": shape.friction, "restitution": shape.restitution,
            "density": 0.0 if shape.sensor else shape.density * share, "isSensor": shape.sensor,
            "filterGroupIndex": shape.group, "filterCategoryBits": shape.category,
            "filterMaskBits": 0xFFFF if shape.mask == _ALL else shape.mask,
        }  # fmt: skip
        if shape.mask == _ALL and shape.category > 0xFFFF:
            data["filterMaskBits"] = _ALL
        return self._add(data | {"shape": _reference(self._add(geometry), "Shape")})

    def _add(self, entry: dict[str, Any]) -> int:
        self._entries.append(entry)
        return len(self._entries) - 1


def _body(body: FlatBody, fixtures: Sequence[int]) -> dict[str, Any]:
    data: dict[str, Any] = {
        "type": body.type, "name": body.id, "bullet": body.bullet, "position": vector(body.position),
        "angle": body.angle, "linearVelocity": vector(body.velocity), "angularVelocity": body.angular_velocity,
    }  # fmt: skip
    more = {
        "linearDamping": body.linear_damping, "angularDamping": body.angular_damping,
        "fixedRotation": body.fixed_rotation,
    }  # fmt: skip
    data |= {key: value for key, value in more.items() if value}
    if body.gravity_scale != 1.0:
        data["gravityScale"] = body.gravity_scale
    if body.sleep_speed == 0.0:
        data["allowSleep"] = False
    return data | {"fixtures": [_reference(index, "Fixture") for index in reversed(fixtures)]}


def _reference(index: int, kind: str) -> dict[str, Any]:
    return {"refIndex": index, "refType": kind}
