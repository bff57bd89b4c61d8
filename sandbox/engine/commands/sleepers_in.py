"""Who sleeps in the area of a region."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.engine.active.wake import sleepers
from sandbox.tables import Integers, plain
from sandbox.world.state import State


def sleepers_in(state: State, region: Any) -> Integers:
    """Rows of the sleeping bodies that may reach into a region."""
    rows = sleepers(state)
    if len(rows) == 0:
        return rows
    bodies = plain(state.bodies)
    center_x, center_y, extent = (bodies[name][rows] for name in ("center_x", "center_y", "extent"))
    found = np.ones(len(rows), np.bool_)
    for edge in state.edges[region.first_edge : region.first_edge + region.edge_count]:
        found &= edge.normal_x * center_x + edge.normal_y * center_y - edge.offset <= extent
    if region.disc_radius > 0.0:
        x, y = center_x - region.disc_x, center_y - region.disc_y
        found &= np.sqrt(x * x + y * y) <= region.disc_radius + extent
    return rows[found]
