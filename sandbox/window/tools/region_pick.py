"""Which region lies under the pointer."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.render.camera import Vec
from sandbox.world.state import State


def region_at(state: State, point: Vec) -> str | None:
    """What commands call the smallest region with an area that holds a point (m); None if none does."""
    found = [row for row in range(len(state.regions)) if _holds(state, row, point)]
    row = min(found, key=lambda row: _extent(state, row), default=None)
    return None if row is None else state.census.regions.called(row)


def _holds(state: State, row: int, point: Vec) -> bool:
    region: Any = state.regions[row]
    edges: Any = state.edges[region.first_edge : region.first_edge + region.edge_count]
    if not len(edges) and not region.disc_radius:
        return False
    beyond = edges.normal_x * point[0] + edges.normal_y * point[1] - edges.offset
    near = np.hypot(point[0] - region.disc_x, point[1] - region.disc_y) <= region.disc_radius
    return bool((beyond <= 0.0).all() and (near or not region.disc_radius))


def _extent(state: State, number: int) -> float:
    """How wide a region is at least: twice the radius of its disc, or between two edges that face each other, m."""
    row: Any = state.regions[number]
    if row.disc_radius:
        return 2.0 * float(row.disc_radius)
    edges: Any = state.edges[row.first_edge : row.first_edge + row.edge_count]
    widths = [
        a.offset + b.offset for a in edges for b in edges if a.normal_x * b.normal_x + a.normal_y * b.normal_y < -0.99
    ]
    return float(min(widths, default=np.inf))
