"""The command that changes the gravity of the world."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sandbox.engine.commands.base import Command, CommandTarget, Touched, Vec
from sandbox.world.records import DYNAMIC


@dataclass(frozen=True)
class SetGravity(Command):
    """Change the gravity of the world (m/s^2). Wakes everything."""

    gravity: Vec

    def apply(self, target: CommandTarget) -> Touched:
        """Write the gravity and wake all sleepers."""
        setting, bodies = target.state.settings[0], target.state.bodies
        setting.gravity_x, setting.gravity_y = self.gravity
        asleep = np.flatnonzero((bodies.type == DYNAMIC) & (bodies.awake == 0))
        bodies.awake[asleep], bodies.sleep_time[asleep], bodies.island[asleep] = 1, 0.0, 0
        return Touched()
