"""What views need of the world that they look at."""

from __future__ import annotations

from typing import Protocol

from sandbox.engine.commands.base import Command
from sandbox.world.state import State


class ViewedWorld(Protocol):
    """As much of a world as views know."""

    @property
    def state(self) -> State:
        """Its records."""

    def apply(self, command: Command) -> None:
        """Apply a command."""
