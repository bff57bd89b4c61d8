"""A command of a run that the world refuses: told with its number, name, step and time."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from sandbox.engine.world import World
from sandbox.errors import REFUSALS, RefusedCommandError


@contextmanager
def telling_refusal(index: int, command: Any, world: World) -> Iterator[None]:
    """While the command of that index is applied to a world. Raises `RefusedCommandError` for a refusal."""
    try:
        yield
    except REFUSALS as error:
        name = type(command).__name__
        raise RefusedCommandError(index, name, world.step_count, world.time, str(error)) from error
