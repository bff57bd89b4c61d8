"""Bodies that come or go one after another, gathered to come or go at once.

A command costs more than its rows: whatever knows of rows is brought up to date after each. So those of one kind wait
until something else is to be done or asked for, and are one command then. What comes of it is the same.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.delete import Delete
from sandbox.engine.commands.spawn import Spawn

Done: TypeAlias = Callable[[str | None], None]
"""What to call when a command was applied; with the reason if it was refused."""


class Gathering:
    """Commands of one kind that wait. `apply` returns why one is refused, or None."""

    def __init__(self, apply: Callable[[Command], str | None]) -> None:
        self._apply = apply
        self._waiting: list[tuple[Command, Done]] = []
        self.names: set[str] = set()
        """What those that wait are about: ids of bodies that go, names of those that come."""

    def waits(self, kind: type[Command]) -> bool:
        """Whether commands of that kind wait."""
        return bool(self._waiting) and type(self._waiting[0][0]) is kind

    def add(self, command: Spawn | Delete, names: Sequence[str], done: Done) -> None:
        """Let a command wait; those of another kind are done first."""
        if not self.waits(type(command)):
            self.finish()
        self._waiting.append((command, done))
        self.names.update(names)

    def finish(self) -> None:
        """Do all that waits. If it cannot be done at once, each by itself, as far as it can."""
        waiting, self._waiting, self.names = self._waiting, [], set()
        commands = [command for command, _ in waiting]
        at_once = len(waiting) > 1 and self._apply(_joined(commands)) is None
        for command, done in waiting:
            done(None if at_once else self._apply(command))


def _joined(commands: Sequence[Command]) -> Command:
    """One command that does the same: of spawns of bodies, or of deletions by lists of ids."""
    spawns = [command.bodies for command in commands if isinstance(command, Spawn)]
    if spawns:
        return Spawn([entry for bodies in spawns for entry in ([bodies] if isinstance(bodies, dict) else bodies)])
    return Delete([name for command in commands if isinstance(command, Delete) for name in command.bodies])
