"""Between which sides of the whole the corners of tiles lie, where other tiles go on from there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sandbox.tables import Floats, Integers
from sandbox.world.runs import owners, runs
from sandbox.world.tile_edges import NEAR, OUT
from sandbox.world.tile_outlines import Corners, Outlines, Tiles

_FAR = 1e-4
"""A tile this far from a corner, in metres, has no say there."""
_MOST_AROUND = 64
"""Where more tiles than this lie around a corner, it is not looked for who goes on there: each would be held against
all, and what so many make up is no outline that a body could catch on.
"""
NONE = -1
"""In the place of an edge: no side of the whole ends or begins there."""


def sides_at_corners(
    outlines: Outlines, one: Tiles, two: Tiles, first: Floats, last: Floats
) -> tuple[Corners, Corners]:
    """For each corner of the tiles in `one`, the edges with whose normals sides of the whole end and begin there.

    `first` and `last` are where the edges of these tiles show, as `shown_edges` has them; -1 stands for no edge: the
    corner lies within the whole.
    """
    tiles = np.unique(one)
    corners, own = outlines.corners(tiles), np.repeat(tiles, outlines.counts[tiles])
    ends = last[np.searchsorted(corners, outlines.before[corners])] == 1.0
    begins = (first == 0.0) & (last > 0.0)
    arriving, leaving = np.where(ends, outlines.before[corners], NONE), np.where(begins, corners, NONE)
    beside_lines = np.isin(own, one[outlines.flat[two]])
    asking = ~(ends & begins) | beside_lines
    near = _Company.of(outlines, (corners, own, np.flatnonzero(asking)), one, two)
    buried = np.zeros(len(corners), np.bool_)
    buried[near.places[near.heights < -NEAR]] = True
    crowded = np.bincount(near.places, minlength=len(corners)) > _MOST_AROUND
    search = _Search(outlines, corners, own, near.only(~(buried | crowded)[near.places]))
    if beside_lines.any():
        search.branch_off(np.flatnonzero(ends & begins), arriving, leaving)
    search.go_on(arriving, leaving)
    before = np.where(arriving == NONE, leaving, arriving)
    after = np.where(leaving == NONE, arriving, leaving)
    return np.where(buried, NONE, before), np.where(buried, NONE, after)


@dataclass(frozen=True)
class _Company:
    """Who is near corners: the place of each corner in a list, the tile, and how far the corner is outside of it (m).

    Sorted by place and tile.
    """

    places: Integers
    tiles: Tiles
    heights: Floats

    @classmethod
    def of(cls, outlines: Outlines, asking: tuple[Corners, Tiles, Integers], one: Tiles, two: Tiles) -> _Company:
        """Those of the places in a list of corners and their tiles, among the tiles beside their own."""
        corners, own, places = asking
        starts = np.searchsorted(one, own[places])
        counts = np.searchsorted(one, own[places], side="right") - starts
        where, tiles = np.repeat(places, counts), two[runs(starts, counts)]
        rows, heights = outlines.within(outlines.x[corners[where]], outlines.y[corners[where]], tiles, _FAR)
        return cls(where[rows], tiles[rows], heights)

    def only(self, kept: NDArray[np.bool_]) -> _Company:
        return _Company(self.places[kept], self.tiles[kept], self.heights[kept])


@dataclass(frozen=True)
class _Search:
    """Looks for the tile with whose edges the outline of the whole goes on from a corner."""

    outlines: Outlines
    corners: Corners
    own: Tiles
    near: _Company

    def go_on(self, arriving: Corners, leaving: Corners) -> None:
        """Fill in the edges that lack: of the first tile that touches the corner and whose edge shows there."""
        touching = self.near.only(self.near.heights <= NEAR)
        found, first, counts = np.unique(touching.places, return_index=True, return_counts=True)
        for k in range(int(counts.max(initial=0))):
            places, tiles = found[counts > k], touching.tiles[first[counts > k] + k]
            lacking = (arriving[places] == NONE) | (leaving[places] == NONE)
            places, tiles = places[lacking], tiles[lacking]
            to, off = self._through(places, tiles)
            for edges, ahead, sides in ((to, -1.0, arriving), (off, 1.0, leaving)):
                asked = (sides[places] == NONE) & (edges != NONE)
                free = self._is_free(places[asked], tiles[asked], edges[asked], ahead)
                sides[places[asked][free]] = edges[asked][free]

    def branch_off(self, whole: Integers, arriving: Corners, leaving: Corners) -> None:
        """Where both edges of a corner show and a line without a radius begins there, which covers neither, it parts
        what lies outside in two. Put that part in the place of both which juts out, or does least turn inwards."""
        outlines, near = self.outlines, self.near
        lines = near.only(outlines.flat[near.tiles] & (near.heights <= NEAR) & np.isin(near.places, whole))
        places, first = np.unique(lines.places, return_index=True)
        tiles = lines.tiles[first]
        to, off = self._through(places, tiles)
        parts = []
        for edges, ahead, before, after in ((to, -1.0, to, leaving[places]), (off, 1.0, arriving[places], off)):
            bend, ends = outlines.bend(before, after), np.flatnonzero(edges != NONE)
            free = np.zeros(len(places), np.bool_)
            free[ends] = self._is_free(places[ends], tiles[ends], edges[ends], ahead)
            parts.append(np.where(free, bend, -np.inf))
        into, out = parts
        first_part, second_part = (into >= out) & (into > -np.inf), out > into
        arriving[places[first_part]], leaving[places[second_part]] = to[first_part], off[second_part]

    def _through(self, places: Integers, tiles: Tiles) -> tuple[Corners, Corners]:
        """The edges of tiles that arrive at and leave corners on their outlines: the same one between two corners.

        Where a line without a radius ends, those are its two sides; between its ends nobody can tell which one.
        """
        outlines, corners = self.outlines, self.corners[places]
        x, y = outlines.x[corners], outlines.y[corners]
        highest, best = np.full(len(tiles), -np.inf), outlines.starts[tiles]
        to, off = np.full(len(tiles), NONE), np.full(len(tiles), NONE)
        for k in range(int(outlines.counts[tiles].max(initial=0))):
            rows = np.flatnonzero(outlines.counts[tiles] > k)
            edge = outlines.starts[tiles[rows]] + k
            across, up = outlines.x[edge] - x[rows], outlines.y[edge] - y[rows]
            here = np.sqrt(across * across + up * up) <= 2.0 * NEAR
            for found, side in ((to, outlines.before[edge]), (off, edge)):
                fits = here & (found[rows] == NONE) & (outlines.lengths[side] > 0.0)
                found[rows[fits]] = side[fits]
            height = outlines.height(x[rows], y[rows], edge)
            higher = height > highest[rows]
            highest[rows[higher]], best[rows[higher]] = height[higher], edge[higher]
        best = np.where(outlines.flat[tiles], NONE, best)
        between = (to == NONE) & (off == NONE)
        return np.where(between, best, to), np.where(between, best, off)

    def _is_free(self, places: Integers, tiles: Tiles, edges: Corners, ahead: float) -> NDArray[np.bool_]:
        """Whether edges of tiles show just ahead of (1) or behind (-1) corners."""
        outlines, corners = self.outlines, self.corners[places]
        normal_x, normal_y = outlines.normal_x[edges], outlines.normal_y[edges]
        x = outlines.x[corners] + 4.0 * OUT * ahead * -normal_y + OUT * normal_x
        y = outlines.y[corners] + 4.0 * OUT * ahead * normal_x + OUT * normal_y
        starts = np.searchsorted(self.near.places, places)
        counts = np.searchsorted(self.near.places, places, side="right") - starts
        asked, others = owners(counts), self.near.tiles[runs(starts, counts)]
        others_only = others != tiles[asked]
        asked = np.concatenate([asked[others_only], np.arange(len(places))])
        others = np.concatenate([others[others_only], self.own[places]])
        blocking, _ = outlines.within(x[asked], y[asked], others, NEAR)
        free = np.ones(len(places), np.bool_)
        free[asked[blocking]] = False
        return free
