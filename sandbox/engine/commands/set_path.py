"""The command that stops driven bodies, lets them go on, or puts them elsewhere on their paths."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sandbox.engine.commands.body_command import BodyCommand
from sandbox.engine.commands.checks import title
from sandbox.errors import CommandError
from sandbox.tables import plain
from sandbox.world.state import State


@dataclass(frozen=True)
class SetPath(BodyCommand):
    """Change how a body follows its path; what is None stays as it is.

    `enabled` lets it go on, or stops it where it is. With `time` (s) it goes on from there: it moves in one step to
    where it would be, at the speed that takes.
    """

    enabled: bool | None = None
    time: float | None = None

    def change(self, state: State, row: int) -> None:
        """Write to the row of the path."""
        rows = np.flatnonzero(plain(state.paths)["body"] == row)
        if not len(rows):
            raise CommandError(f"{title(self)}: the body has no path; give it one in the scene")
        path = state.paths[rows[0]]
        if self.enabled is not None:
            path.enabled = int(self.enabled)
        if self.time is not None:
            path.steps = round(self.time / float(state.settings[0].step_seconds))
