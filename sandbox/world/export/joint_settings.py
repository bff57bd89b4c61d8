"""The settings of a joint as fields of a file: all that does not depend on where its bodies are."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import isinf
from typing import Any

from sandbox.geometry.rotation import RADIANS_PER_DEGREE
from sandbox.scene.joints import JOINTS, Joint
from sandbox.world.export.numbers import degrees, fitted
from sandbox.world.export.present import Present

Words = dict[str, Any]


@dataclass(frozen=True)
class Angle:
    """An angle or angular speed in radians, for a field in degrees."""

    radians: float


_SPRING = ("hertz", "damping_ratio")
_TURNING_SPRING = ("angular_hertz", "angular_damping_ratio")
PLAIN: dict[str, tuple[str, ...]] = {
    "distance": ("damping_ratio",),
    "revolute": ("damping_ratio",),
    "prismatic": ("damping_ratio",),
    "wheel": ("damping_ratio",),
    "weld": (*_SPRING, *_TURNING_SPRING),
    "gear": ("ratio",),
    "pulley": ("ratio",),
    "motor": (*_SPRING, *_TURNING_SPRING, "max_force", "max_torque"),
    "target": (*_SPRING, "max_force"),
    "friction": ("max_force", "max_torque"),
}
"""For each kind, the fields that its record holds under the same names."""
STRENGTH = {"revolute": "max_torque", "prismatic": "max_force", "wheel": "max_torque"}
"""For each kind with a motor, the field that limits it."""
SPRUNG = ("distance", "revolute", "prismatic", "wheel")


def settings(kind: str, joint: Any) -> Iterator[tuple[str, Any]]:
    """Fields and values; None where there is no spring, motor or limit."""
    yield "collide", bool(joint.collide)
    yield "enabled", bool(joint.enabled)
    for name in ("break_force", "break_torque", *PLAIN[kind]):
        yield name, finite(joint[name])
    if kind in SPRUNG:
        yield "hertz", float(joint.hertz) if joint.spring else None
    if kind in STRENGTH:
        speed = float(joint.motor_speed)
        yield "motor_speed", None if not joint.motor else speed if kind == "prismatic" else Angle(speed)
        yield STRENGTH[kind], finite(joint.max_motor)


def finite(value: Any) -> float | None:
    """A limit; None for an infinite one."""
    return None if isinf(value) else float(value)


def put(present: Present, words: Words, name: str, value: Any) -> None:
    """Write a field of a joint, unless the entry says the same already."""
    model = JOINTS[words["type"]]
    if _same(_said(model, words, name), value):
        return
    value = degrees(value.radians) if isinstance(value, Angle) else value
    inside = fitted(model, name, value)
    if inside != value:
        present.remarks.note(f"{name} past the limit of scene files is cut to it", words["id"])
    words.pop(name, None)
    if inside != model.model_fields[name].default:
        words[name] = inside


def _said(model: type[Joint], words: Words, name: str) -> Any:
    """What an entry says about a field, given or by default."""
    return words[name] if name in words else model.model_fields[name].get_default()


def _same(said: Any, value: Any) -> bool:
    if isinstance(value, Angle):
        return isinstance(said, (int, float)) and said * RADIANS_PER_DEGREE == value.radians
    return bool((list(said) if isinstance(said, tuple) else said) == value)
