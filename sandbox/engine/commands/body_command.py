"""What all commands to one body have in common: they find it by its id, change it, and wake it."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import ClassVar

from sandbox.engine.active.wake import keep_awake, wake_body
from sandbox.engine.commands.base import Command, CommandTarget, Touched
from sandbox.engine.commands.checks import title
from sandbox.errors import CommandError
from sandbox.tables import WholeWords
from sandbox.world.records import DYNAMIC, KINEMATIC
from sandbox.world.records import BodyPlace as At
from sandbox.world.state import State

GOES_ON = Touched(active_set=False)
"""What a command has touched that only pushes an awake body."""


@dataclass(frozen=True)
class BodyCommand(Command):
    """A command to the body of that id."""

    body: str

    only_pushes: ClassVar[bool] = False
    """Whether it changes nothing of an awake dynamic body but how it goes on."""

    def apply(self, target: CommandTarget) -> Touched:
        """Change the body and wake it."""
        state, row = target.state, target.directory.body(self.body)
        numbers, flags = state.body_words(row)
        goes_on = self.only_pushes and flags[At.TYPE] == DYNAMIC and flags[At.AWAKE] == 1
        self.change(state, row)
        if goes_on:  # what it touches is awake
            keep_awake(numbers, flags)
            return GOES_ON
        if self.only_pushes and flags[At.TYPE] == KINEMATIC:  # what that touches wakes in the step, if it moves
            return Touched(bodies=(row,))
        return Touched(bodies=wake_body(state, row))

    @abstractmethod
    def change(self, state: State, row: int) -> None:
        """Change the body of that row. Raises `CommandError`, and changes nothing, if it cannot be done."""


def needs_dynamic(flags: WholeWords, command: BodyCommand) -> None:
    """Raise `CommandError` unless a body, its row as whole numbers, is dynamic."""
    if flags[At.TYPE] != DYNAMIC:
        raise CommandError(f"{title(command)}: only a dynamic body can be pushed or dragged")
