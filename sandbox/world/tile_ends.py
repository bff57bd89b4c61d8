"""From the outlines of tiles to the vertices of cores: a line has two, each between two corners of its outline."""

from __future__ import annotations

import numpy as np

from sandbox.tables import Floats
from sandbox.world.runs import run_starts, runs
from sandbox.world.tile_outlines import Corners, Outlines, Tiles

Found = tuple[Corners, Corners, Floats, Floats]
"""The edges before and after corners, as `sides_at_corners` has them, and from where to where the edges from there on
show."""


def at_vertices(outlines: Outlines, tiles: Tiles, found: Found) -> Found:
    """What holds at the vertices of some tiles, from what was found at all of their corners.

    At the free end of a line all directions away from it lead out. Where another tile goes on from one of its two
    corners or both, at most one of them juts out of the whole, and that one tells; the other turns inwards, and the
    sides speak for themselves.
    """
    counts = outlines.vertices[tiles]
    of_line = np.repeat(counts == 2, counts)
    if not of_line.any():
        return found
    before, after, first, last = found
    corners, number = outlines.corners(tiles), runs(np.zeros(len(tiles), np.int64), counts)
    place = np.repeat(run_starts(outlines.counts[tiles]), counts) + np.where(of_line, 2 * number, number)
    across = np.where(of_line, np.searchsorted(corners, outlines.before[corners[place]]), place)
    edge, side, end = outlines.before[corners[across]], corners[place], corners[across]
    open_end = of_line & (before[across] == edge) & (after[across] == end) & (before[place] == end)
    open_end &= after[place] == side
    juts = outlines.bend(before[across], after[across]) > outlines.bend(before[place], after[place])
    chosen = np.where(juts, across, place)
    return (
        np.where(open_end, edge, before[chosen]),
        np.where(open_end, side, after[chosen]),
        first[place],
        last[place],
    )
