"""What all commands to one body have in common: they find it by its id, change it, and wake it."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import ClassVar

from sandbox.engine.active.wake import wake_body
from sandbox.engine.commands.base import Command, CommandTarget, Touched
from sandbox.engine.commands.checks import title
from sandbox.errors import CommandError
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC
from sandbox.world.state import State


@dataclass(frozen=True)
class BodyCommand(Command):
    """A command to the body of that id."""

    body: str

    only_pushes: ClassVar[bool] = False
    """Whether it changes nothing of an awake dynamic body but how it goes on."""

    def apply(self, target: CommandTarget) -> Touched:
        """Change the body and wake it."""
        state, row = target.state, target.directory.body(self.body)
        body = state.bodies[row]
        goes_on = self.only_pushes and body.type == DYNAMIC and body.awake == 1
        self.change(state, row)
        wake_body(state, row)
        return Touched(active_set=not goes_on)

    @abstractmethod
    def change(self, state: State, row: int) -> None:
        """Change the body of that row. Raises `CommandError`, and changes nothing, if it cannot be done."""


def needs_dynamic(body: Records, command: BodyCommand) -> None:
    """Raise `CommandError` unless a body is dynamic."""
    if body.type != DYNAMIC:
        raise CommandError(f"{title(command)}: only a dynamic body can be pushed or dragged")
