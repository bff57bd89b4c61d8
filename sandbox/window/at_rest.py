"""How much of a world sleeps, in words."""

from __future__ import annotations

import numpy as np

from sandbox.engine.world import World
from sandbox.tables import plain
from sandbox.world.records import DYNAMIC


def asleep(world: World) -> str:
    """`all`, or how many dynamic bodies sleep; empty where none does. One that is frozen does not sleep."""
    bodies = plain(world.state.bodies)
    movable = (bodies["type"] == DYNAMIC) & (bodies["frozen_step"] < 0)
    count = int(np.count_nonzero(movable & (bodies["awake"] == 0)))
    return "" if not count else "all" if count == np.count_nonzero(movable) else f"{count:,}"
