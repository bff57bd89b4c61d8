"""Commands of a hand that drags bodies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from sandbox.arguments import shown
from sandbox.engine.commands.base import Vec
from sandbox.engine.commands.body_command import BodyCommand, needs_dynamic
from sandbox.engine.commands.checks import title
from sandbox.errors import CommandError
from sandbox.world.state import State

DRAG_HERTZ = 5.0
DRAG_DAMPING_RATIO = 0.7
_MOST = 9810.0
"""Acceleration (m/s^2) that a drag can give, if nothing else is said."""


@dataclass(frozen=True)
class StartDrag(BodyCommand):
    """Take hold of a dynamic body at a world `point` (m); pull it there with at most `max_force` (N).

    Without `max_force` the limit is a thousand times the body's weight at 1 g.
    """

    point: Vec
    max_force: float | None = None

    only_pushes = True

    def change(self, state: State, row: int) -> None:
        """Begin a drag, or take hold anew of a body that is dragged."""
        body = state.bodies[row]
        needs_dynamic(state.body_words(row)[1], self)
        rows = [drag for drag in state.drags if drag.body == row] or [drag for drag in state.drags if drag.body < 0]
        if not rows:
            raise CommandError(f"{title(self)}: {len(state.drags)} bodies are dragged already; end one first")
        drag = rows[0]
        dx, dy = self.point[0] - body.center_x, self.point[1] - body.center_y
        drag.body = row
        drag.target_x, drag.target_y = self.point
        drag.local_x = body.rotation_cos * dx + body.rotation_sin * dy
        drag.local_y = body.rotation_cos * dy - body.rotation_sin * dx
        drag.hertz, drag.damping_ratio = DRAG_HERTZ, DRAG_DAMPING_RATIO
        drag.max_force = (
            self.max_force if self.max_force is not None else _MOST * state.settings[0].units_per_meter * body.mass
        )
        drag.impulse_x = drag.impulse_y = 0.0


@dataclass(frozen=True)
class MoveDrag(BodyCommand):
    """Move the target of a body's drag (m)."""

    target: Vec

    only_pushes = True

    def change(self, state: State, row: int) -> None:
        """Write the target."""
        drag = _drag_of(state, row, self.body)
        drag.target_x, drag.target_y = self.target


@dataclass(frozen=True)
class EndDrag(BodyCommand):
    """Let go of a body."""

    only_pushes = True

    def change(self, state: State, row: int) -> None:
        """Free the row of the drag."""
        _drag_of(state, row, self.body).body = -1


def _drag_of(state: State, row: int, name: str) -> Any:
    for drag in state.drags:
        if drag.body == row:
            return drag
    raise CommandError(f"{shown(name)} is not being dragged; start with StartDrag")
