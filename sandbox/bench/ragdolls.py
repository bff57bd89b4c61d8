"""Ragdolls, and the rain of them: Box2D's `shared/human.c` and `CreateRain`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.delete import Delete
from sandbox.engine.commands.spawn import Spawn

Words = dict[str, Any]

_ROWS, _COLUMNS, _GROUP = 5, 40, 5
_SPAN, _STOREY = 250.0, 45.0
_EVERY = 8
_TORQUE, _HERTZ, _DAMPING_RATIO = 0.05, 5.0, 0.5


class _Bone(NamedTuple):
    """A capsule that stands upright at the height `y` (m), from `low` to `high` about it.

    A hinge at the height `pivot` joins it to its `parent`; its limits are in half turns, counted from an angle that is
    itself `turned` against the pose at the start. `share` is its part of the friction of joints.
    """

    name: str
    parent: str
    y: float
    low: float
    high: float
    radius: float
    share: float = 1.0
    pivot: float = 0.0
    lower: float = 0.0
    upper: float = 0.0
    turned: float = 0.0
    damping: float = 0.0
    foot: bool = False


def _bones() -> Iterator[_Bone]:
    yield _Bone("hip", "", 0.95, -0.02, 0.02, 0.095)
    yield _Bone("torso", "hip", 1.2, -0.135, 0.135, 0.09, 0.5, 1.0, -0.25, 0.0)
    yield _Bone("head", "torso", 1.475, -0.038, 0.039, 0.075, 0.25, 1.4, -0.3, 0.1, damping=0.1)
    for side in ("left", "right"):
        thigh = f"thigh-{side}"
        yield _Bone(thigh, "hip", 0.775, -0.125, 0.125, 0.06, 1.0, 0.9, -0.05, 0.4)
        yield _Bone(f"shin-{side}", thigh, 0.475, -0.155, 0.125, 0.045, 0.5, 0.625, -0.5, -0.02, foot=True)
    for side in ("left", "right"):
        arm = f"arm-{side}"
        yield _Bone(arm, "torso", 1.225, -0.125, 0.125, 0.035, 0.5, 1.35, -0.1, 0.8)
        yield _Bone(f"hand-{side}", arm, 0.975, -0.125, 0.125, 0.03, 0.1, 1.1, -0.2, 0.3, turned=0.25, damping=0.1)


BONES = tuple(_bones())


def ragdoll(name: str, x: float, y: float, group: int) -> tuple[list[Words], list[Words]]:
    """(bodies, hinges) of a ragdoll that stands at (x, y); its parts do not collide with each other."""
    bodies = [_body(bone, name, x, y, group) for bone in BONES]
    return bodies, [_hinge(bone, name, x, y) for bone in BONES if bone.parent]


def _body(bone: _Bone, name: str, x: float, y: float, group: int) -> Words:
    skin = {"friction": 0.2, "group": -group, "category": "human", "mask": ["default", "human"]}
    shapes: list[Words] = [{"capsule": [[0.0, bone.low], [0.0, bone.high]], "radius": bone.radius, **skin}]
    if bone.foot:
        sole = [[-0.03, -0.185], [0.11, -0.185], [0.11, -0.16], [-0.03, -0.14]]
        shapes.append({"polygon": sole, "radius": 0.015, **skin, "friction": 0.05, "mask": ["default"]})
    return {
        "id": f"{name}-{bone.name}", "position": [x, y + bone.y], "shapes": shapes, "sleep_speed": 0.1,
        "linear_damping": bone.damping,
    }  # fmt: skip


def _hinge(bone: _Bone, name: str, x: float, y: float) -> Words:
    rest = 180.0 * bone.turned
    return {
        "id": f"{name}-{bone.name}", "type": "revolute", "bodies": [f"{name}-{bone.parent}", f"{name}-{bone.name}"],
        "anchor": [x, y + bone.pivot], "lower": 180.0 * bone.lower + rest, "upper": 180.0 * bone.upper + rest,
        "motor_speed": 0.0, "max_torque": bone.share * _TORQUE,
        "hertz": _HERTZ, "damping_ratio": _DAMPING_RATIO, "rest": rest,
    }  # fmt: skip


def rain(step: int) -> Sequence[Command]:
    """Every eighth step a column of 25 ragdolls, five over each floor; when all columns are there, for the oldest."""
    if step % _EVERY:
        return ()
    generation, column = divmod(step // _EVERY, _COLUMNS)
    bodies, joints = [], []
    for name, x, y, group in _places(generation, column):
        some, hinges = ragdoll(name, x, y, group)
        bodies += some
        joints += hinges
    if generation == 0:
        return (Spawn(bodies, joints),)
    old = [f"{name}-{bone.name}" for name, *_ in _places(generation - 1, column) for bone in BONES]
    return Delete(old), Spawn(bodies, joints)


def _places(generation: int, column: int) -> Iterator[tuple[str, float, float, int]]:
    """(name, x, y, group) of the ragdolls of a column."""
    for row in range(_ROWS):
        for k in range(_GROUP):
            x = -0.5 * _SPAN + _SPAN / _COLUMNS * (column + 0.5) + 0.5 * k
            yield f"doll-{generation}-{row}-{column}-{k}", x, 40.0 + _STOREY * row, k + 1
