"""Whether what a function is given is a world."""

from __future__ import annotations

from typing import Any

from sandbox.arguments import shown
from sandbox.errors import ArgumentError
from sandbox.world.state import State


def check_world(call: str, world: Any) -> None:
    """Raise `ArgumentError` unless `world` has the records of one: here, nobody knows the class."""
    if not isinstance(getattr(world, "state", None), State):
        raise ArgumentError(f"{call}: takes a World, not {shown(world)}")
