"""The command of a player: a control is pressed, moved, or let go."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.engine.commands.base import Command, CommandTarget, Touched, Vec


@dataclass(frozen=True)
class Control(Command):
    """Hold a control of the scene: `value` from -1 to 1, 0 lets go. It stays so until the next such command.

    `pointer` is where the mouse is (m); None leaves that as it is. The control acts before the next step.
    """

    name: str
    value: float = 1.0
    pointer: Vec | None = None

    def apply(self, target: CommandTarget) -> Touched:
        """Note it for the next step."""
        row = target.state.controls[target.directory.control(self.name)]
        before, row.value = float(row.value), self.value
        if before == 0.0 and self.value != 0.0:
            row.pressed = 1
        elif before != 0.0 and self.value == 0.0:
            row.released = 1
        if self.pointer is not None:
            row.pointer_x, row.pointer_y = self.pointer
        return Touched(active_set=False)
