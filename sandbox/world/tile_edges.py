"""What shows of the edges of tiles: what other tiles cover from their ends on is left off."""

from __future__ import annotations

import numpy as np

from sandbox.tables import Floats, Integers
from sandbox.world.tile_outlines import Corners, Outlines, Tiles, kept

NEAR = 1e-6
"""What is this near, in metres, is flush."""
_BEFORE_SORTING = 3
"""So often all stretches that begin within what is covered are taken at once: where hundreds of tiles lie over each
other few are left to be sorted."""
OUT = 3e-6
"""How far outside of an edge it has to be solid to count as covered, in metres."""


def shown_edges(outlines: Outlines, one: Tiles, two: Tiles) -> tuple[Corners, Floats, Floats]:
    """The edges of all tiles in `one`, and from where to where each shows, as shares of its length; 1 to 0 if nowhere.

    `one` and `two` are pairs of tiles that lie side by side, all of a tile in `one`, sorted.
    """
    edges = outlines.corners(np.unique(one))
    covered, begins, ends = _covers(outlines, one, two)
    place = np.searchsorted(edges, covered)
    near = 2.0 * NEAR / np.maximum(outlines.lengths[edges], 4.0 * NEAR)
    first = _grown(place, begins, ends, near)
    last = -_grown(place, -ends, -begins, near, -1.0)
    first = np.where(first <= near, 0.0, first)
    last = np.where(last >= 1.0 - near, 1.0, last)
    visible = last - first > near
    return edges, np.where(visible, first, 1.0), np.where(visible, last, 0.0)


def _covers(outlines: Outlines, one: Tiles, two: Tiles) -> tuple[Corners, Floats, Floats]:
    """Edges that run within another tile, and from where to where, as shares of their lengths."""
    edges, tiles = outlines.corners(one), np.repeat(two, outlines.counts[one])
    out = np.where(outlines.lengths > 0.0, OUT, 0.0)  # whichever way a line goes on from its end
    out_x, out_y = out * outlines.normal_x, out * outlines.normal_y
    after = outlines.after
    start_x, start_y = outlines.x + out_x, outlines.y + out_y
    x, y = start_x.take(edges), start_y.take(edges)
    way_x = ((outlines.x[after] + out_x) - start_x).take(edges)
    way_y = ((outlines.y[after] + out_y) - start_y).take(edges)
    starts, lasts = outlines.starts[tiles], outlines.counts[tiles] - 1
    first, last = np.zeros(len(edges)), np.ones(len(edges))
    for k in range(int(lasts.max(initial=-1)) + 1):
        line = starts + np.minimum(k, lasts)  # a tile with fewer edges is asked for its last one again
        height = outlines.height(x, y, line) - NEAR
        rise = way_x * outlines.normal_x[line] + way_y * outlines.normal_y[line]
        level = (np.abs(rise) <= 1e-12 * np.abs(height)) | (rise == 0.0)
        crossing = -height / np.where(level, 1.0, rise)
        first = np.where(level | (rise > 0.0), first, np.maximum(first, crossing))
        last = np.where(level | (rise < 0.0), last, np.minimum(last, crossing))
        left = (first < last) & ~(level & (height > 0.0))
        edges, x, y, way_x, way_y, starts, lasts, first, last = kept(
            left, edges, x, y, way_x, way_y, starts, lasts, first, last
        )
    return edges, first, last


def _grown(place: Integers, begins: Floats, ends: Floats, near: Floats, start: float = 0.0) -> Floats:
    """How far from `start` on each edge is covered without a gap; the stretches of an edge are taken as they begin."""
    reached = np.full(len(near), start)
    for _ in range(_BEFORE_SORTING):
        joins = begins <= reached[place] + near[place]
        np.maximum.at(reached, place[joins], ends[joins])
        place, begins, ends = kept(ends > reached[place], place, begins, ends)
    order = np.lexsort((ends, begins, place))
    place, begins, ends = place[order], begins[order], ends[order]
    found, first, counts = np.unique(place, return_index=True, return_counts=True)
    for k in range(int(counts.max(initial=0))):
        rows = first[counts > k] + k
        edge = found[counts > k]
        grows = (begins[rows] <= reached[edge] + near[edge]) & (ends[rows] > reached[edge])
        reached[edge] = np.where(grows, ends[rows], reached[edge])
    return reached
