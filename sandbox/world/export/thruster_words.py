"""The thrusters of a body as entries of a file, with the forces and the schedule of now."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from sandbox.world.export.numbers import pair
from sandbox.world.export.present import Present
from sandbox.world.export.schedule_words import write_schedule

Words = dict[str, Any]


def thruster_words(present: Present, row: int, entries: Sequence[Words]) -> list[Words]:
    """All thrusters of a body."""
    found = [dict(entry) for entry in entries]
    name = present.state.names[row]
    for entry, index in zip(found, np.flatnonzero(present.state.thrusters.body == row).tolist(), strict=False):
        thruster, first = present.state.thrusters[index], present.start.thrusters[index]
        if (thruster.force_x, thruster.force_y) != (first.force_x, first.force_y):
            entry["force"] = pair(thruster.force_x, thruster.force_y)
        write_schedule(present, entry, thruster, first, name)
    return found
