"""Regions come and go: their rows are added at the end or taken out, with the half-planes that bound them, of which a
region may get others.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.scene.flat import FlatRegion
from sandbox.tables import extended, plain, without
from sandbox.world.build_fields import build_regions
from sandbox.world.directory import Directory
from sandbox.world.field_records import EDGE
from sandbox.world.region_area import side_count
from sandbox.world.state import State


def add_regions(state: State, flat: Sequence[FlatRegion]) -> None:
    """Add regions after all others. Their times count from the coming step on."""
    now = int(state.counters[0].step_count)
    regions, edges = map(plain, build_regions(flat, state.census.scene.settings.step_rate, now))
    regions["first_edge"] += len(state.edges)
    state.regions, state.edges = extended(state.regions, regions), extended(state.edges, edges)


def remove_regions(state: State, directory: Directory, gone: NDArray[np.bool_]) -> None:
    """Take out the marked regions."""
    regions = plain(state.regions)
    counts = regions["edge_count"]
    state.edges = without(state.edges, np.repeat(~gone, counts))
    regions["first_edge"] -= np.cumsum(np.where(gone, counts, 0))
    state.regions = without(state.regions, ~gone)
    directory.remove(regions=state.census.regions.remove(np.flatnonzero(gone).tolist()))


def put_sides(state: State, index: int, sides: Sequence[tuple[float, float, float]]) -> None:
    """Bound a region that has sides by others, half-planes (normal x, normal y, offset); a surface stays its last."""
    regions: Any = state.regions
    first, before = int(regions[index].first_edge), side_count(state, index)
    if len(sides) != before:
        kept = plain(state.edges)
        edges = EDGE.zeros(len(kept) + len(sides) - before)
        plain(edges)[:first] = kept[:first]
        plain(edges)[first + len(sides) :] = kept[first + before :]
        state.edges = edges
        regions[index].edge_count += len(sides) - before
        plain(regions)["first_edge"][index + 1 :] += len(sides) - before
    for row, side in zip(state.edges[first : first + len(sides)], sides, strict=True):
        row.normal_x, row.normal_y, row.offset = side
