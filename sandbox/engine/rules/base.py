"""What rules need of the world that they are for."""

from __future__ import annotations

from typing import Protocol

from sandbox.engine.commands.base import Command
from sandbox.engine.events.events import Events
from sandbox.world.directory import Directory
from sandbox.world.state import State


class RuledWorld(Protocol):
    """As much of a world as rules know."""

    @property
    def state(self) -> State:
        """Its records."""

    @property
    def directory(self) -> Directory:
        """From ids to rows."""

    @property
    def events(self) -> Events:
        """What happened in the last step."""

    def apply(self, command: Command) -> None:
        """Apply a command."""
