"""Commands that change joints: plain data, checked as a whole before it is applied."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, TypeAlias

from sandbox.engine.active.wake import wake_bodies
from sandbox.engine.commands.checks import check_fields, title
from sandbox.engine.commands.joint_settings import MOTORS, SPRINGS, SetJoint, set_joint
from sandbox.errors import CommandError
from sandbox.world import joint_records as kinds
from sandbox.world.state import State

_SWITCHES = ("spring", "limit", "motor", "collide", "enabled", "broken_step")
"""Columns that say what hangs together and which rows a joint has."""

__all__ = [
    "BreakJoint",
    "JointCommand",
    "SetJoint",
    "SetLimits",
    "SetMotor",
    "SetSpring",
    "SetTarget",
    "apply_joint_command",
    "joint_bodies",
]


@dataclass(frozen=True)
class SetMotor:
    """Run the motor of a revolute, prismatic or wheel joint at `speed` (rad/s or m/s); None switches it off.

    `strongest` (N m or N) is the most it gives; None leaves that as it is.
    """

    joint: str
    speed: float | None
    strongest: float | None = None


@dataclass(frozen=True)
class SetLimits:
    """Give a revolute, prismatic, wheel or distance joint limits (rad or m); None on a side: no limit there."""

    joint: str
    lower: float | None
    upper: float | None


@dataclass(frozen=True)
class SetSpring:
    """Give a joint a spring toward `rest` (rad or m; of a distance joint its length); None as `hertz`: no spring."""

    joint: str
    hertz: float | None
    damping_ratio: float = 0.0
    rest: float | None = None


@dataclass(frozen=True)
class SetTarget:
    """Move the target of a target joint, in the world (m)."""

    joint: str
    target: tuple[float, float]


@dataclass(frozen=True)
class BreakJoint:
    """Break a joint for good."""

    joint: str


JointCommand: TypeAlias = SetMotor | SetLimits | SetSpring | SetTarget | SetJoint | BreakJoint


def apply_joint_command(state: State, index: int, command: JointCommand) -> bool:
    """Apply a command to joint `index`; True if that changes what hangs together or which rows the joint has.

    Raises `CommandError`, and changes nothing, if it cannot be done.
    """
    check_fields(command)
    joint = state.joints[index]
    before = [int(joint[name]) for name in _SWITCHES]
    match command:
        case SetMotor():
            _set_motor(joint, command)
        case SetLimits():
            _set_limits(joint, command)
        case SetSpring():
            _set_spring(joint, command)
        case SetTarget():
            _require(joint, (kinds.TARGET,), command, "target")
            joint.point_ax, joint.point_ay = command.target
        case SetJoint():
            set_joint(state, joint, command)
        case BreakJoint():
            _break(state, joint)
    wake_bodies(state, joint_bodies(state, joint))
    return before != [int(joint[name]) for name in _SWITCHES]


def joint_bodies(state: State, joint: Any) -> list[int]:
    """The rows of the bodies that a joint holds; of a gear, those of the joints it couples."""
    parts = [joint] if joint.joint_1 < 0 else [state.joints[joint.joint_1], state.joints[joint.joint_2]]
    return [int(body) for part in parts for body in (part.body_a, part.body_b) if body >= 0]


def _require(joint: Any, allowed: tuple[int, ...], command: JointCommand, what: str) -> None:
    if int(joint.kind) not in allowed:
        raise CommandError(f"{title(command)}: this kind of joint has no {what}")


def _set_motor(joint: Any, command: SetMotor) -> None:
    _require(joint, MOTORS, command, "motor")
    joint.motor = int(command.speed is not None)
    joint.motor_speed = command.speed or 0.0
    if command.strongest is not None:
        joint.max_motor = command.strongest


def _set_limits(joint: Any, command: SetLimits) -> None:
    _require(joint, SPRINGS, command, "limits")
    lower = -math.inf if command.lower is None else command.lower
    upper = math.inf if command.upper is None else command.upper
    if lower > upper:
        raise CommandError(f"{title(command)}: lower must not be greater than upper")
    joint.lower, joint.upper = lower, upper
    joint.limit = int(command.lower is not None or command.upper is not None)


def _set_spring(joint: Any, command: SetSpring) -> None:
    _require(joint, SPRINGS, command, "spring")
    joint.spring = int(command.hertz is not None)
    joint.hertz, joint.damping_ratio = command.hertz or 0.0, command.damping_ratio
    if command.rest is None:
        return
    if int(joint.kind) == kinds.DISTANCE:
        joint.length = command.rest
    else:
        joint.rest = command.rest


def _break(state: State, joint: Any) -> None:
    if joint.broken_step < 0:
        joint.broken_step = state.counters[0].step_count
        state.counters[0].broken_count += 1
