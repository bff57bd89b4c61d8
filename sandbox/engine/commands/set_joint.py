"""The command that changes the settings of any joint, by the names that they have in a scene file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from typing import Any, ClassVar, Self

from sandbox.engine.commands.base import Vec
from sandbox.engine.commands.checks import title
from sandbox.engine.commands.joint_command import MOTORS, SPRINGS, JointCommand
from sandbox.errors import CommandError, SceneError
from sandbox.geometry.rotation import RADIANS_PER_DEGREE
from sandbox.scene.flat import FlatJoint
from sandbox.world import joint_records as kinds
from sandbox.world.joint_pose import coordinate, pulley_length
from sandbox.world.state import State

_FIXED = ("id", "type", "bodies", "joints", "anchor", "anchors", "axis", "wheels")
"""What makes a joint the one that it is: fields of a scene that no command changes."""
_STAND_IN: dict[str, Any] = {
    "id": "joint", "bodies": ("a", "b"), "joints": ("a", "b"), "anchor": (0.0, 0.0),
    "anchors": ((0.0, 0.0), (1.0, 0.0)), "wheels": ((0.0, 0.0), (1.0, 0.0)),
    "axis": (1.0, 0.0), "target": (0.0, 0.0), "max_force": 0.0,
}  # fmt: skip
"""Values for fields that a scene needs, but the command does not give."""

ANGLES: dict[str, tuple[str, ...]] = {
    "revolute": ("lower", "upper", "rest", "motor_speed"),
    "wheel": ("motor_speed",),
    "motor": ("angle",),
}
"""For each kind of joint, the settings that are angles or angular speeds."""
_MAY_BE_ANGLES = {name for names in ANGLES.values() for name in names}


@dataclass(frozen=True)
class SetJoint(JointCommand):
    """Change the settings of a joint; what is None stays as it is.

    Fields are those of a scene file, with the same limits and units, as far as the kind of joint has them; but angles
    are in radians, as everywhere in Python, unless `radians` is False: then they are degrees, as in a file. `enabled`
    switches the joint on or off; one that is broken stays broken. `hertz` begins a spring and `motor_speed` a motor
    where there is none. A new `ratio` counts from the pose of now. `offset` and `angle` of a motor, `rest`, `lower`
    and `upper` count from the pose the joint began with. An infinite `break_force`, `break_torque`, `max_force` or
    `max_torque` is no limit, where a scene may have none. What the joint holds wakes.
    """

    UNLIMITED: ClassVar[frozenset[str]] = frozenset({"break_force", "break_torque", "max_force", "max_torque"})
    enabled: bool | None = None
    collide: bool | None = None
    break_force: float | None = None
    break_torque: float | None = None
    max_force: float | None = None
    max_torque: float | None = None
    hertz: float | None = None
    damping_ratio: float | None = None
    angular_hertz: float | None = None
    angular_damping_ratio: float | None = None
    rest: float | None = None
    length: float | None = None
    min: float | None = None
    max: float | None = None
    lower: float | None = None
    upper: float | None = None
    motor_speed: float | None = None
    ratio: float | None = None
    offset: Vec | None = None
    angle: float | None = None
    target: Vec | None = None
    radians: bool = True

    def __post_init__(self) -> None:
        if all(getattr(self, name) is None for name in _MAY_BE_ANGLES):  # it says nothing: be equal to one without it
            object.__setattr__(self, "radians", True)

    def change(self, state: State, joint: Any) -> None:
        """Write the new settings. Raises `CommandError`, and changes nothing, for what no scene may have."""
        given = {name: value for name in _SETTINGS if (value := getattr(self, name)) is not None}
        flat = _checked(joint, given, self)
        lower = flat.lower if given.keys() & {"lower", "min"} else float(joint.lower)
        upper = flat.upper if given.keys() & {"upper", "max"} else float(joint.upper)
        if lower > upper:
            low, high = ("min", "max") if int(joint.kind) == kinds.DISTANCE else ("lower", "upper")
            raise CommandError(f"{title(self)}: {low} must not be greater than {high}")
        if given.keys() & {"lower", "upper", "min", "max"}:
            joint.lower, joint.upper, joint.limit = lower, upper, 1
        for name in given.keys() - {"lower", "upper", "min", "max"}:
            _write(state, joint, name, flat)

    def to_words(self) -> dict[str, Any]:
        """The fields as a recording has them: angles are degrees, as in a scene file, unless it says otherwise."""
        words = {name: value for name, value in super().to_words().items() if name != "radians"}
        return {**words, "radians": True} if self.radians and words.keys() & _MAY_BE_ANGLES else words

    @classmethod
    def from_words(cls, words: Mapping[str, Any]) -> Self:
        """The command that the fields of a recording stand for."""
        return super().from_words({"radians": not words.keys() & _MAY_BE_ANGLES, **words})


_SETTINGS = tuple(field.name for field in fields(SetJoint) if field.name not in ("joint", "radians"))


def _checked(joint: Any, given: Mapping[str, Any], command: SetJoint) -> FlatJoint:
    """The fields must be those of the kind, and their values such as a scene may have; gives them in radians."""
    from sandbox.scene.joints import JOINTS

    kind = kinds.KINDS[int(joint.kind)]
    model = JOINTS[kind]
    known = [name for name in model.model_fields if name not in _FIXED]
    stray = next((name for name in given if name not in known), None)
    if stray is not None:
        raise CommandError(f"{title(command)}: a {kind} joint has no {stray}; it has {', '.join(known)}")
    needed = {name: _STAND_IN[name] for name in model.model_fields if name in _STAND_IN}
    angles = {name: given[name] for name in ANGLES.get(kind, ()) if name in given} if command.radians else {}
    endless = {name: None for name, value in given.items() if command.is_unlimited(name, value)}
    in_degrees = {name: angle / RADIANS_PER_DEGREE for name, angle in angles.items()}
    try:
        flat = model(**{**needed, "type": kind, **given, **in_degrees, **endless}).flat()
    except SceneError as error:
        raise CommandError(f"{title(command)}: {error.problems[0].message}") from None
    return replace(flat, **angles)  # as they were given: there and back they could round


def _write(state: State, joint: Any, name: str, flat: FlatJoint) -> None:
    match name:
        case "ratio":
            joint.length += (flat.ratio - joint.ratio) * _second(state, joint)
            joint.ratio = flat.ratio
        case "offset":  # the axis of a motor is that of the world, as it was in the frame of a
            x, y = flat.points[0]
            joint.point_ax, joint.point_ay = joint.axis_x * x - joint.axis_y * y, joint.axis_y * x + joint.axis_x * y
        case "angle":
            joint.reference_angle += flat.angle - joint.rest
            joint.rest = flat.angle
        case "target":
            joint.point_ax, joint.point_ay = flat.points[0]
        case "max_force" | "max_torque" if int(joint.kind) in MOTORS:
            joint.max_motor = flat.max_motor
        case _:
            joint[name] = getattr(flat, name)
    if name == "hertz" and int(joint.kind) in SPRINGS:
        joint.spring = 1
    if name == "motor_speed":
        joint.motor = 1


def _second(state: State, joint: Any) -> float:
    """What a pulley or gear weighs with its ratio, at the pose of now."""
    if int(joint.kind) == kinds.PULLEY:
        return pulley_length(state, joint, "b")
    return coordinate(state, state.joints[joint.joint_2])
