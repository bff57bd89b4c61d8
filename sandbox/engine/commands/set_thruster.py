"""The command that changes the thrusters of a body."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from sandbox.engine.commands.base import CommandTarget, Touched, Vec
from sandbox.engine.commands.body_command import BodyCommand
from sandbox.engine.commands.checks import title
from sandbox.engine.commands.switch import switch
from sandbox.errors import CommandError, SceneError
from sandbox.tables import plain
from sandbox.world.state import State


@dataclass(frozen=True)
class SetThruster(BodyCommand):
    """Change a body's thrusters; what is None stays as it is.

    `force` [x, y] (N) is in the body's frame; `enabled` switches on or off from now on, whatever the schedule was.
    `thruster` is the number of one of them, from 0; None means all.
    """

    force: Vec | None = None
    enabled: bool | None = None
    thruster: int | None = None

    def apply(self, target: CommandTarget) -> Touched:
        """Change the thrusters and wake the body."""
        return replace(super().apply(target), schedules=self.enabled is not None)

    def change(self, state: State, row: int) -> None:
        """Write force and schedule."""
        thrusters = plain(state.thrusters)
        rows = np.flatnonzero(thrusters["body"] == row)
        if self.thruster is not None:
            if not 0 <= self.thruster < len(rows):
                raise CommandError(f"{title(self)}: the body has no thruster {self.thruster}, but {len(rows)}")
            rows = rows[self.thruster : self.thruster + 1]
        if len(rows) == 0:
            raise CommandError(f"{title(self)}: the body has no thrusters; give it some in the scene")
        if self.force is not None:
            _check_force(self, self.force)
            thrusters["force_x"][rows], thrusters["force_y"][rows] = self.force
        for one in rows if self.enabled is not None else ():
            switch(state.thrusters[one], self.enabled, state)


def _check_force(command: SetThruster, force: Vec) -> None:
    from sandbox.scene.thruster import Thruster

    try:
        Thruster(force=force)
    except SceneError as error:
        raise CommandError(f"{title(command)}: {error.problems[0].message}") from None
