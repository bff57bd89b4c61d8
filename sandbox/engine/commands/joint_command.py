"""What all commands to one joint have in common: they find it by its id, change it, and wake what it holds."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import Any

import numpy as np

from sandbox._plain_rows import plain_rows
from sandbox.engine.active.wake import wake_bodies
from sandbox.engine.commands.base import Command, CommandTarget, Touched
from sandbox.engine.commands.checks import title
from sandbox.errors import CommandError
from sandbox.tables import Integers, plain
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
        state, row = target.state, target.directory.joint(self.joint)
        joints = plain_rows(plain(state.joints))
        joint = joints[row]
        before = [joint[name] for name in _SWITCHES]
        self.change(state, joint)
        woken = wake_bodies(state, _held(joints, joint))
        return Touched(joints=before != [joint[name] for name in _SWITCHES], bodies=woken)

    @abstractmethod
    def change(self, state: State, joint: Any) -> None:
        """Change the joint's record. Raises `CommandError`, and changes nothing, if it cannot be done."""


def _held(joints: Any, joint: Any) -> list[int]:
    """The rows of the bodies that a joint holds. A gear has none of its own, but those of the joints it couples."""
    coupled = [joints[row] for row in (joint.joint_1, joint.joint_2) if row >= 0]
    return [body for each in (joint, *coupled) for body in (each.body_a, each.body_b) if body >= 0]


def held_bodies(state: State, rows: Integers) -> Integers:
    """The rows of the bodies that some joints hold; of a gear, those of the joints it couples."""
    if len(rows) == 0:
        return rows
    joints = plain(state.joints)
    coupled = np.concatenate([joints[name][rows] for name in ("joint_1", "joint_2")])
    rows = np.concatenate([rows, coupled[coupled >= 0]])
    bodies = np.concatenate([joints[name][rows] for name in ("body_a", "body_b")])
    return bodies[bodies >= 0]


def require(joint: Any, allowed: tuple[int, ...], command: JointCommand, what: str) -> None:
    """Raise `CommandError` unless a joint is of a kind that has `what`."""
    if int(joint.kind) not in allowed:
        raise CommandError(f"{title(command)}: this kind of joint has no {what}")
