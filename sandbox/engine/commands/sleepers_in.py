"""Who sleeps in the area of a region."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.tables import Integers
from sandbox.world.records import DYNAMIC
from sandbox.world.state import State


def sleepers_in(state: State, region: Any) -> Integers:
    """Rows of the sleeping bodies that may reach into a region."""
    bodies: Any = state.bodies
    found = (bodies.type == DYNAMIC) & (bodies.awake == 0)
    for edge in state.edges[region.first_edge : region.first_edge + region.edge_count]:
        found &= edge.normal_x * bodies.center_x + edge.normal_y * bodies.center_y - edge.offset <= bodies.extent
    if region.disc_radius > 0.0:
        x, y = bodies.center_x - region.disc_x, bodies.center_y - region.disc_y
        found &= np.sqrt(x * x + y * y) <= region.disc_radius + bodies.extent
    return np.flatnonzero(found)
