"""Joints of a flat scene as joints of planck.js."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from sandbox.formats.export.common import angle_between, finite, in_body, limited
from sandbox.formats.export.planck_shapes import vector
from sandbox.formats.numbers import turned
from sandbox.formats.remarks import Remarks
from sandbox.scene.flat import FlatBody, FlatJoint

Data = dict[str, Any]
_NO_LIMIT = 1e9
"""How far a slide or hinge goes that has a limit at its other end only, m or rad."""


class PlanckJoint:
    """Makes the entry of one joint; `a` and `b` are its bodies, None the world."""

    def __init__(self, joint: FlatJoint, a: FlatBody | None, b: FlatBody | None, remarks: Remarks) -> None:
        self._joint, self._a, self._b, self._remarks = joint, a, b, remarks

    def data(self) -> Data | None:
        """The entry without its bodies, or None with a remark."""
        joint = self._joint
        makers: dict[str, Callable[[], Data]] = {
            "distance": self._distance, "revolute": self._revolute, "prismatic": self._prismatic, "weld": self._weld,
            "wheel": self._wheel, "pulley": self._pulley, "motor": self._motor, "target": self._mouse,
            "friction": self._friction, "gear": self._gear,
        }  # fmt: skip
        if not joint.enabled:
            self._note("a joint that is switched off is left out")
            return None
        return {"name": joint.id, "collideConnected": joint.collide, **makers[joint.kind]()}

    def _note(self, text: str) -> None:
        self._remarks.note(self._joint.id, text)

    def _anchors(self) -> Data:
        joint = self._joint
        return {
            "localAnchorA": vector(in_body(self._a, joint.anchor_a)),
            "localAnchorB": vector(in_body(self._b, joint.anchor_b)),
        }  # fmt: skip

    def _distance(self) -> Data:
        joint = self._joint
        if joint.hertz is None and joint.lower <= 0.0 and math.isfinite(joint.upper):
            return {"type": "rope-joint", **self._anchors(), "maxLength": joint.upper}
        if limited(joint):
            self._note("limits of a spring's length are left out")
        length = joint.length if joint.length is not None else math.dist(joint.anchor_a, joint.anchor_b)
        spring = {"frequencyHz": joint.hertz or 0.0, "dampingRatio": joint.damping_ratio}
        return {"type": "distance-joint", **self._anchors(), "length": length, **spring}

    def _revolute(self) -> Data:
        self._note_spring()
        return {
            "type": "revolute-joint", **self._anchors(), **self._limits("Angle"), **self._motor_of("Torque"),
            "referenceAngle": angle_between(self._a, self._b),
        }  # fmt: skip

    def _prismatic(self) -> Data:
        self._note_spring()
        return {
            "type": "prismatic-joint", **self._anchors(), **self._limits("Translation"), **self._motor_of("Force"),
            "localAxisA": self._axis(), "referenceAngle": angle_between(self._a, self._b),
        }  # fmt: skip

    def _wheel(self) -> Data:
        joint = self._joint
        if limited(joint):
            self._note("limits of a suspension are left out")
        if joint.rest:
            self._note("the rest of a suspension is where it stands at the start")
        spring = {"frequencyHz": joint.hertz or 0.0, "dampingRatio": joint.damping_ratio}
        return {
            "type": "wheel-joint", **self._anchors(), "localAxisA": self._axis(), **self._motor_of("Torque"), **spring
        }  # fmt: skip

    def _weld(self) -> Data:
        joint = self._joint
        if joint.hertz:
            self._note("a weld gives way to turning only")
        spring = {"frequencyHz": joint.angular_hertz, "dampingRatio": joint.angular_damping_ratio}
        return {"type": "weld-joint", **self._anchors(), "referenceAngle": angle_between(self._a, self._b), **spring}

    def _friction(self) -> Data:
        joint = self._joint
        strength = {"maxForce": finite(joint.max_force), "maxTorque": finite(joint.max_torque)}
        return {"type": "friction-joint", **self._anchors(), **strength}

    def _motor(self) -> Data:
        """It drives the origin of the second body, which goes along with its anchor."""
        joint, b = self._joint, self._b
        self._note("a motor joint's stiffness is a correction factor of 0.3")
        (x, y), (ax, ay) = joint.points[0], joint.anchor_b
        origin = b.position if b else (0.0, 0.0)
        there = turned((origin[0] - ax, origin[1] - ay), joint.angle)
        return {
            "type": "motor-joint", "maxForce": finite(joint.max_force), "maxTorque": finite(joint.max_torque),
            "correctionFactor": 0.3, "linearOffset": vector(in_body(self._a, (x + there[0], y + there[1]))),
            "angularOffset": joint.angle + angle_between(self._a, b),
        }  # fmt: skip

    def _mouse(self) -> Data:
        joint = self._joint
        return {
            "type": "mouse-joint", "target": vector(joint.points[0]), "maxForce": finite(joint.max_force),
            "frequencyHz": joint.hertz or 0.0, "dampingRatio": joint.damping_ratio,
            "_localAnchorB": vector(in_body(self._b, joint.anchor_b)),
        }  # fmt: skip

    def _pulley(self) -> Data:
        joint = self._joint
        one, two = joint.points
        return {
            "type": "pulley-joint", **self._anchors(), "groundAnchorA": vector(one), "groundAnchorB": vector(two),
            "lengthA": math.dist(one, joint.anchor_a), "lengthB": math.dist(two, joint.anchor_b),
            "ratio": joint.ratio,
        }  # fmt: skip

    def _gear(self) -> Data:
        return {"type": "gear-joint", "ratio": self._joint.ratio}

    def _axis(self) -> dict[str, float]:
        return vector(turned(self._joint.axis, -self._a.angle) if self._a else self._joint.axis)

    def _limits(self, what: str) -> Data:
        joint = self._joint
        if not limited(joint):
            return {"enableLimit": False, f"lower{what}": 0.0, f"upper{what}": 0.0}
        lower, upper = max(joint.lower, -_NO_LIMIT), min(joint.upper, _NO_LIMIT)
        return {"enableLimit": True, f"lower{what}": lower, f"upper{what}": upper}

    def _motor_of(self, what: str) -> Data:
        joint = self._joint
        if joint.motor_speed is None:
            return {"enableMotor": False, "motorSpeed": 0.0, f"maxMotor{what}": 0.0}
        return {"enableMotor": True, "motorSpeed": joint.motor_speed, f"maxMotor{what}": finite(joint.max_motor)}

    def _note_spring(self) -> None:
        if self._joint.hertz is not None:
            self._note("the spring of a hinge or slide is left out")
