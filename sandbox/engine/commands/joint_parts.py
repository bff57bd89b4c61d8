"""Commands that change one part of a joint, its motor, limits, spring or target, and the one that breaks it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, ClassVar

from sandbox.engine.commands.base import Vec
from sandbox.engine.commands.checks import title
from sandbox.engine.commands.joint_command import MOTORS, SPRINGS, JointCommand, require
from sandbox.errors import CommandError
from sandbox.world import joint_records as kinds
from sandbox.world.state import State


@dataclass(frozen=True)
class SetMotor(JointCommand):
    """Run the motor of a revolute, prismatic or wheel joint at `speed` (rad/s or m/s); None switches it off.

    `strongest` (N m or N) is the most it gives, infinity for any; None leaves that as it is.
    """

    UNLIMITED: ClassVar[frozenset[str]] = frozenset({"strongest"})
    speed: float | None
    strongest: float | None = None

    def change(self, state: State, joint: Any) -> None:
        """Write the motor."""
        require(joint, MOTORS, self, "motor")
        joint.motor = int(self.speed is not None)
        joint.motor_speed = self.speed or 0.0
        if self.strongest is not None:
            joint.max_motor = self.strongest


@dataclass(frozen=True)
class SetLimits(JointCommand):
    """Give a revolute, prismatic, wheel or distance joint limits (rad or m); None on a side: no limit there."""

    lower: float | None
    upper: float | None

    def change(self, state: State, joint: Any) -> None:
        """Write the limits."""
        require(joint, SPRINGS, self, "limits")
        lower = -math.inf if self.lower is None else self.lower
        upper = math.inf if self.upper is None else self.upper
        if lower > upper:
            raise CommandError(f"{title(self)}: lower must not be greater than upper")
        _check_length(joint, upper, self, "upper")
        joint.lower, joint.upper = lower, upper
        joint.limit = int(self.lower is not None or self.upper is not None)


@dataclass(frozen=True)
class SetSpring(JointCommand):
    """Give a joint a spring toward `rest` (rad or m; of a distance joint its length); None as `hertz`: no spring."""

    hertz: float | None
    damping_ratio: float = 0.0
    rest: float | None = None

    def change(self, state: State, joint: Any) -> None:
        """Write the spring."""
        require(joint, SPRINGS, self, "spring")
        _check_length(joint, self.rest or 0.0, self, "rest")
        joint.spring = int(self.hertz is not None)
        joint.hertz, joint.damping_ratio = self.hertz or 0.0, self.damping_ratio
        if self.rest is None:
            return
        if int(joint.kind) == kinds.DISTANCE:
            joint.length = self.rest
        else:
            joint.rest = self.rest


def _check_length(joint: Any, value: float, command: JointCommand, what: str) -> None:
    """What is the length of a distance joint must not be negative."""
    if int(joint.kind) == kinds.DISTANCE and value < 0.0:
        raise CommandError(f"{title(command)}: {what} is a length here, and must not be negative")


@dataclass(frozen=True)
class SetTarget(JointCommand):
    """Move the target of a target joint, in the world (m)."""

    target: Vec

    def change(self, state: State, joint: Any) -> None:
        """Write the target."""
        require(joint, (kinds.TARGET,), self, "target")
        joint.point_ax, joint.point_ay = self.target


@dataclass(frozen=True)
class BreakJoint(JointCommand):
    """Break a joint for good."""

    def change(self, state: State, joint: Any) -> None:
        """Note the step at which it broke."""
        if joint.broken_step < 0:
            joint.broken_step = state.counters[0].step_count
            state.counters[0].broken_count += 1
