"""The seam table after rows have come or gone."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sandbox.tables import Records, taken
from sandbox.world.flush import find_tiles, join_tiles, with_room_for_tiles
from sandbox.world.records import SEAMED
from sandbox.world.runs import runs
from sandbox.world.state import State


def reseam(state: State, old: Records, tiles_changed: bool) -> None:
    """Give `state` its own seam table again, laid out as in a world that is built from nothing.

    Its shapes still point into the table `old`. Where static tiles have come or gone, they are joined anew.
    """
    shapes = state.shapes
    own = own_seams(shapes)
    counts = np.where(own, shapes.vertex_count, 0)
    rows = taken(old, runs(shapes.seam_start, counts))
    start = np.array(shapes.seam_start)
    tiles = find_tiles(state.bodies, shapes)
    tiles = tiles[~own[tiles]]
    traits = np.array(shapes.traits[tiles])
    shapes.seam_start = np.cumsum(counts) - counts
    shapes.traits[tiles] &= ~SEAMED
    state.seams = with_room_for_tiles(state.bodies, shapes, rows)
    if tiles_changed:
        join_tiles(state.bodies, shapes, state.vertices, state.seams)
    elif len(tiles) >= 2:
        shapes.traits[tiles] = traits
        state.seams[len(rows) :] = old[runs(start[tiles], shapes.vertex_count[tiles])]


def own_seams(shapes: Records) -> NDArray[np.bool_]:
    """Which shapes have rows that came with them: parts of concave polygons, and links of chains."""
    own: NDArray[np.bool_] = ((shapes.traits & SEAMED) != 0) & ((shapes.part > 0) | (shapes.vertex_count < 3))
    return own
