"""A small scene and what is done to it: enough for every group of a fingerprint to have something in it."""

from __future__ import annotations

from typing import Any

import sandbox
from sandbox import (
    ApplyForce,
    ApplyImpulse,
    EndDrag,
    Explode,
    MoveDrag,
    SetGravity,
    SetMotor,
    SetPose,
    SetSurface,
    StartDrag,
)

STEPS = 150

DATA: dict[str, Any] = {
    "title": "A box of things",
    "gravity": [0, -9.81],
    "materials": {"wood": {"friction": 0.4}},
    "bodies": [
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 0.6], "material": "wood"},
        {"id": "ball", "shapes": [{"circle": 0.4, "restitution": 0.6}], "position": [0.3, 2.2]},
        {"id": "pill", "shapes": [{"capsule": [[-0.4, 0], [0.4, 0]], "radius": 0.2}], "position": [2, 1.5]},
        {"id": "slab", "shapes": [{"box": [2, 0.5]}], "position": [5, 0.25]},
        {"id": "stone", "shapes": [{"box": [0.8, 0.8]}], "position": [5.2, 0.9]},
        {"id": "hub", "shapes": [{"circle": 0.3}], "position": [-3, 3]},
        {"id": "arm", "shapes": [{"box": [1.6, 0.2]}], "position": [-3, 3]},
    ],
    "joints": [
        {"id": "pin", "type": "revolute", "bodies": ["hub"], "anchor": [-3, 3]},
        {"id": "motor", "type": "revolute", "bodies": ["hub", "arm"], "anchor": [-3, 3], "motor_speed": 90},
    ],
    "settings": {"steps": STEPS},
    "expect": [{"always": True, "above": -1}],
}

COMMANDS = (
    (0, SetSurface("ball", friction=0.25)),
    (10, StartDrag("crate", (0.3, 0.8), 400.0)),
    (12, MoveDrag("crate", (1.0 / 3.0, 2.5))),
    (12, ApplyImpulse("ball", (0.1, 0.7), point=(0.3, 1.0))),
    (30, EndDrag("crate")),
    (40, SetMotor("motor", -2.5)),
    (50, ApplyForce("pill", (3.0, 80.0), 5.0)),
    (60, SetPose("pill", (1.0, 4.0), 1.25)),
    (90, Explode((0.0, 0.0), 3.0, 2.0)),
    (120, SetGravity((0.5, -9.0))),
)


def scene(**changes: Any) -> sandbox.Scene:
    """The scene, with other fields where given."""
    return sandbox.Scene(**{**DATA, **changes})


def recording() -> sandbox.Recording:
    """The scene with the commands, recorded."""
    return sandbox.record(scene(), STEPS, COMMANDS)
