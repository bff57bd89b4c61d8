"""What tests of joints are built from: worlds with joints, and what can be measured on them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from sandbox.engine.world import World
from sandbox.scene.flat import FlatBody, FlatJoint, FlatScene, Vec
from tests.flat import AWAKE, body, box

G = 9.81


def joint(name: str, kind: str, a: str | None, b: str | None, at: Vec | None = None, **fields: Any) -> FlatJoint:
    """A joint; `at` is the anchor on both bodies."""
    anchors = {} if at is None else {"anchor_a": at, "anchor_b": at}
    return FlatJoint(name, kind, a, b, **{**anchors, **fields})


def jointed(bodies: tuple[FlatBody, ...], joints: tuple[FlatJoint, ...], **fields: Any) -> World:
    """A world of bodies and joints that never sleeps unless `settings` say otherwise."""
    return World(FlatScene(bodies, **{"settings": AWAKE, **fields}, joints=joints))


def row(count: int, kind: str = "revolute", pin: str = "start", **shape: Any) -> tuple[list[FlatBody], list[FlatJoint]]:
    """Planks of 1 m by 0.25 m along the x axis from 0 on, each joined to the next; pinned to the world at its start
    or at "both" ends."""
    planks = [body(f"p{k}", box(1.0, 0.25, **shape), position=(k + 0.5, 0.0)) for k in range(count)]
    ends = range(count + 1) if pin == "both" else range(count)
    joints = [
        joint(f"j{k}", kind, f"p{k - 1}" if k else None, f"p{k}" if k < count else None, (float(k), 0.0)) for k in ends
    ]
    return planks, joints


def gap(world: World) -> float:
    """Largest distance (m) of the two anchors of any joint."""
    found = 0.0
    for name in world.joint_names:
        (ax, ay), (bx, by) = world.joint(name).anchors
        found = max(found, math.hypot(bx - ax, by - ay))
    return found


def largest_gain(world: World, steps: int) -> float:
    """The most energy (J) that a world gains in one of so many steps."""
    found, before = 0.0, energy(world)
    for _ in range(steps):
        world.step()
        now = energy(world)
        found, before = max(found, now - before), now
    return found


def energy(world: World) -> float:
    """Kinetic and potential energy of all bodies, J."""
    b = world.state.bodies
    kinetic = b.mass * (b.velocity_x**2 + b.velocity_y**2) + b.inertia * b.angular_velocity**2
    return float(np.sum(0.5 * kinetic + b.mass * G * b.center_y))
