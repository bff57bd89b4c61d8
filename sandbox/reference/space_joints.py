"""Joints of a flat scene as pymunk's constraints."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import pymunk

from sandbox.scene.flat import FlatJoint

KINDS = ("revolute", "weld", "distance")
"""The kinds of joints that are made; all others are left out."""


def add_joint(space: pymunk.Space, flat: FlatJoint, a: pymunk.Body | None, b: pymunk.Body | None) -> list[Any]:
    """The constraints that make one joint of `a` and `b` (None: the world) where they are; none for other `KINDS`."""
    one, two = a or space.static_body, b or space.static_body
    found = list(_constraints(flat, one, two))
    for constraint in found:
        constraint.collide_bodies = flat.collide
    space.add(*found)
    return found


def _constraints(flat: FlatJoint, a: pymunk.Body, b: pymunk.Body) -> Iterator[Any]:
    if flat.kind == "distance":
        yield from _distance(flat, a, b)
    elif flat.kind == "weld":
        yield pymunk.PivotJoint(a, b, flat.anchor_a)
        yield pymunk.GearJoint(a, b, b.angle - a.angle, 1.0)
    elif flat.kind == "revolute":
        yield pymunk.PivotJoint(a, b, flat.anchor_a)
        yield from _about_the_hinge(flat, a, b)


def _about_the_hinge(flat: FlatJoint, a: pymunk.Body, b: pymunk.Body) -> Iterator[Any]:
    """Limits, motor and spring of a hinge; its angle counts from the pose of now."""
    start = b.angle - a.angle
    if math.isfinite(flat.lower) or math.isfinite(flat.upper):
        yield pymunk.RotaryLimitJoint(a, b, start + flat.lower, start + flat.upper)
    if flat.motor_speed is not None:
        motor = pymunk.SimpleMotor(a, b, -flat.motor_speed)
        motor.max_force = flat.max_motor
        yield motor
    if flat.hertz is not None:
        stiffness, damping = _spring(flat, 1.0 / a.moment + 1.0 / b.moment)
        # pymunk's angle of a spring is that of the first body against the second.
        yield pymunk.DampedRotarySpring(a, b, -(start + flat.rest), stiffness, damping)


def _distance(flat: FlatJoint, a: pymunk.Body, b: pymunk.Body) -> Iterator[Any]:
    anchors = a.world_to_local(flat.anchor_a), b.world_to_local(flat.anchor_b)
    length = flat.length if flat.length is not None else math.dist(flat.anchor_a, flat.anchor_b)
    limited = math.isfinite(flat.lower) or math.isfinite(flat.upper)
    if limited:
        yield pymunk.SlideJoint(a, b, *anchors, max(0.0, flat.lower), flat.upper)
    if flat.hertz is not None:
        yield pymunk.DampedSpring(a, b, *anchors, length, *_spring(flat, 1.0 / a.mass + 1.0 / b.mass))
    elif not limited:
        pin = pymunk.PinJoint(a, b, *anchors)
        pin.distance = length
        yield pin


def _spring(flat: FlatJoint, mobility: float) -> tuple[float, float]:
    """(stiffness, damping) of a spring that swings what has this `mobility` (1/kg or 1/(kg m^2)) as `flat` says."""
    omega = 2.0 * math.pi * (flat.hertz or 0.0)
    return omega * omega / mobility, 2.0 * flat.damping_ratio * omega / mobility
