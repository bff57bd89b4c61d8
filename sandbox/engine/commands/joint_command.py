"""What all commands to one joint have in common: they find it by its id, change it, and wake what it holds."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import Any

from sandbox.engine.active.wake import wake_bodies
from sandbox.engine.commands.base import Command, CommandTarget, Touched
from sandbox.engine.commands.checks import title
from sandbox.errors import CommandError
from sandbox.world import joint_records as kinds
from sandbox.world.state import State

SPRINGS = (kinds.DISTANCE, kinds.REVOLUTE, kinds.PRISMATIC, kinds.WHEEL)
"""Kinds that may have a spring and limits."""
MOTORS = (kinds.REVOLUTE, kinds.PRISMATIC, kinds.WHEEL)
"""Kinds that may have a motor."""
_SWITCHES = ("spring", "limit", "motor", "collide", "enabled", "broken_step")
"""Columns that say what hangs together and which rows a joint has in the solver."""


@dataclass(frozen=True)
class JointCommand(Command):
    """A command to the joint of that id."""

    joint: str

    def apply(self, target: CommandTarget) -> Touched:
        """Change the joint and wake the bodies that it holds."""
        state, joint = target.state, target.state.joints[target.directory.joint(self.joint)]
        before = [int(joint[name]) for name in _SWITCHES]
        self.change(state, joint)
        wake_bodies(state, joint_bodies(state, joint))
        return Touched(joints=before != [int(joint[name]) for name in _SWITCHES])

    @abstractmethod
    def change(self, state: State, joint: Any) -> None:
        """Change the joint's record. Raises `CommandError`, and changes nothing, if it cannot be done."""


def joint_bodies(state: State, joint: Any) -> list[int]:
    """The rows of the bodies that a joint holds; of a gear, those of the joints it couples."""
    parts = [joint] if joint.joint_1 < 0 else [state.joints[joint.joint_1], state.joints[joint.joint_2]]
    return [int(body) for part in parts for body in (part.body_a, part.body_b) if body >= 0]


def require(joint: Any, allowed: tuple[int, ...], command: JointCommand, what: str) -> None:
    """Raise `CommandError` unless a joint is of a kind that has `what`."""
    if int(joint.kind) not in allowed:
        raise CommandError(f"{title(command)}: this kind of joint has no {what}")
