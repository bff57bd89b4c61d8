"""The command that changes the gravity of the world."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.engine.active.wake import wake_all
from sandbox.engine.commands.base import Command, CommandTarget, Touched, Vec


@dataclass(frozen=True)
class SetGravity(Command):
    """Change the gravity of the world (m/s^2). Wakes everything."""

    gravity: Vec

    def apply(self, target: CommandTarget) -> Touched:
        """Write the gravity and wake all sleepers."""
        setting = target.state.settings[0]
        setting.gravity_x, setting.gravity_y = self.gravity
        return Touched(bodies=wake_all(target.state))
