"""Joints of a flat scene as constraints of pymunk."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sandbox.formats.export.common import angle_between, in_body, limited, mass_of
from sandbox.scene.flat import FlatBody, FlatJoint

KINDS = ("revolute", "weld", "distance")
"""The kinds of joints that are made."""

Constraint = tuple[str, str, float]
"""The class of pymunk, its arguments after the bodies, and its greatest force."""


def joint_lines(joint: FlatJoint, a: FlatBody | None, b: FlatBody | None) -> Iterator[Constraint]:
    """The constraints that make one joint; None is the world."""
    anchors = f"{in_body(a, joint.anchor_a)}, {in_body(b, joint.anchor_b)}"
    start = angle_between(a, b)
    if joint.kind == "distance":
        yield from _distance(joint, anchors, _mobility(a) + _mobility(b))
        return
    yield "PivotJoint", anchors, math.inf
    if joint.kind == "weld":
        yield "GearJoint", f"{start!r}, 1.0", math.inf
        return
    if limited(joint):
        low, high = (repr(value) if math.isfinite(value) else f"{'-' if value < 0 else ''}math.inf"
                     for value in (start + joint.lower, start + joint.upper))  # fmt: skip
        yield "RotaryLimitJoint", f"{low}, {high}", math.inf
    if joint.motor_speed is not None:
        yield "SimpleMotor", f"{-joint.motor_speed!r}", joint.max_motor
    if joint.hertz is not None:
        # pymunk's angle of a spring is that of the first body against the second.
        spring = _spring(joint, _turning(a) + _turning(b))
        yield "DampedRotarySpring", f"{-(start + joint.rest)!r}, {spring}", math.inf


def _distance(joint: FlatJoint, anchors: str, mobility: float) -> Iterator[Constraint]:
    length = joint.length if joint.length is not None else math.dist(joint.anchor_a, joint.anchor_b)
    if limited(joint):
        upper = repr(joint.upper) if math.isfinite(joint.upper) else "math.inf"
        yield "SlideJoint", f"{anchors}, {max(0.0, joint.lower)!r}, {upper}", math.inf
    if joint.hertz is not None:
        yield "DampedSpring", f"{anchors}, {length!r}, {_spring(joint, mobility)}", math.inf
    elif not limited(joint):
        yield "SlideJoint", f"{anchors}, {length!r}, {length!r}", math.inf


def _spring(joint: FlatJoint, mobility: float) -> str:
    """Stiffness and damping of a spring that swings what has this mobility as the joint says."""
    omega = 2.0 * math.pi * (joint.hertz or 0.0)
    if mobility <= 0.0:
        return "0.0, 0.0"
    return f"{omega * omega / mobility!r}, {2.0 * joint.damping_ratio * omega / mobility!r}"


def _mobility(body: FlatBody | None) -> float:
    return 1.0 / mass_of(body).mass if body is not None and body.type == "dynamic" else 0.0


def _turning(body: FlatBody | None) -> float:
    is_free = body is not None and body.type == "dynamic" and not body.fixed_rotation
    return 1.0 / mass_of(body).inertia if body is not None and is_free else 0.0
