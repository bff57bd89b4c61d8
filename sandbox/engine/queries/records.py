"""Memory of the queries of one world: made at the first question, never hashed, never saved."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sandbox._jit import interpreted
from sandbox.engine.broad_phase.grid import LEVEL_SPACE, LEVELS, SPARSE, head_count
from sandbox.engine.records.colliders import GRID_BOX
from sandbox.tables import Field, Integers, Records, Table
from sandbox.world.records import VERTEX
from sandbox.world.state import State

MAX_CORE = 64
"""Vertices of a shape that is asked about."""
SPARE_CORES = 3 * MAX_CORE
"""Rows at the end of the turned cores: the mirrored core of the question, then its sum with a core of the world."""

NOTHING = -1
"""The `generation` of an index that knows of no box."""

INDEX = Table(
    "index",
    (
        Field("generation", "-", "that of the active set when it was brought up to date, or `NOTHING`", "i8"),
        Field("settled", "-", "how many bodies had been laid to rest by then", "i8"),
        Field("anew", "-", "1 where all was laid out anew then", "i8"),
        Field("shapes", "-", "how many there were", "i8"),
        Field("kept", "-", "boxes that have been laid out to be kept", "i8"),
        Field("taken", "-", "those of them that were taken out since", "i8"),
        Field("kept_regions", "-", "levels with many of them", "i8"),
        Field("kept_sparse", "-", "those on the other levels", "i8"),
        Field("loose", "-", "shapes that are laid out each time", "i8"),
        Field("idle", "-", "those that did not move, over all times since", "i8"),
    ),
)
"""One row: what is known of the grid."""

REGION = Table(
    "region",
    (
        Field("level", "-", "cells are 2**level times the base cell wide", "i8"),
        Field("count", "-", "boxes on this level", "i8"),
        Field("cells_per_metre", "1/m", "inverse width of its cells"),
        Field("lower_x", "m", "bounds of the middles of its boxes"),
        Field("lower_y", "m", ""),
        Field("upper_x", "m", ""),
        Field("upper_y", "m", ""),
        Field("first_box", "-", "row in `ordered` of the first box of its part of the grid", "i8"),
        Field("boxes", "-", "boxes of that part, on all levels", "i8"),
        Field("first_head", "-", "row in `heads` of the first bucket of that part", "i8"),
        Field("heads", "-", "buckets of that part, and one more", "i8"),
    ),
)
"""One row a level with many boxes: where it is populated. The last row has the bounds of all boxes, the one before it
of those that are kept."""

QUESTION = Table(
    "question",
    (
        Field("region_count", "-", "levels with many boxes", "i8"),
        Field("sparse_count", "-", "boxes on the other levels", "i8"),
        Field("mask", "-", "categories that are seen", "i8"),
        Field("category", "-", "what the query counts as to the masks of shapes; 0 passes over their masks", "i8"),
        Field("group", "-", "as for shapes", "i8"),
        Field("types", "-", "bit set of the body types that are seen", "i8"),
        Field("sensors", "-", "1: sensors are seen too", "i8"),
        Field("count", "-", "vertices of the mirrored core", "i8"),
        Field("radius", "m", "rounding of the query shape"),
        Field("extent", "m", "farthest point of the query shape from its reference point"),
        Field("lower_x", "m", "bounds of the query shape from its reference point"),
        Field("lower_y", "m", ""),
        Field("upper_x", "m", ""),
        Field("upper_y", "m", ""),
    ),
)
"""What is asked, but for the place: the filter and the query shape."""

WALK = Table(
    "walk",
    (
        Field("x", "m", "where the reference point starts"),
        Field("y", "m", ""),
        Field("translation_x", "m", "where it goes"),
        Field("translation_y", "m", ""),
        Field("limit", "1", "fraction of the way that still matters"),
        Field("lower_x", "m", "bounds of what is swept, from the reference point"),
        Field("lower_y", "m", ""),
        Field("upper_x", "m", ""),
        Field("upper_y", "m", ""),
        Field("first_stage", "-", "rows of the regions that are gone through, from here", "i8"),
        Field("end_stage", "-", "to before here", "i8"),
        Field("stage", "-", "-1 sparse boxes, then the row of the region", "i8"),
        Field("by_columns", "-", "1 when lines of cells are columns, 0 rows", "i8"),
        Field("line", "-", "line of cells under way", "i8"),
        Field("turn", "-", "1 or -1: to the next line", "i8"),
        Field("lines_left", "-", "", "i8"),
        Field("cell", "-", "next cell of the line", "i8"),
        Field("last_cell", "-", "", "i8"),
        Field("first", "-", "found: rows of the ordered boxes, from `first` to before `end`", "i8"),
        Field("end", "-", "", "i8"),
        Field("level", "-", "found: only boxes of this level count", "i8"),
        Field("low_x", "-", "found: only boxes of these cells count", "i8"),
        Field("high_x", "-", "", "i8"),
        Field("low_y", "-", "", "i8"),
        Field("high_y", "-", "", "i8"),
    ),
)
"""How far a walk through the grid has come."""

HIT = Table(
    "hit",
    (
        Field("shape_index", "-", "row of the shape; -1 for none", "i8"),
        Field("body", "-", "index of its body; -1 for none", "i8"),
        Field("fraction", "1", "of the way; for proximity the distance in metres"),
        Field("x", "m", "point of the hit"),
        Field("y", "m", ""),
        Field("normal_x", "1", "outward unit normal of what was hit"),
        Field("normal_y", "1", ""),
    ),
)
"""One row an answer."""


class QueryTables(NamedTuple):
    """The tables of a world's state that its queries read."""

    bodies: Records
    shapes: Records
    vertices: Records

    @classmethod
    def of(cls, state: State) -> QueryTables:
        """Those of `state`."""
        return cls(state.bodies, state.shapes, state.vertices)


class QueryGrid(NamedTuple):
    """The grid of all shapes, in two parts, each with buckets of its own: of what is kept, and of what is loose.

    `ordered` has the boxes of the one part and then those of the other, bucket by bucket, `heads` tells where each
    bucket begins, `sparse` which boxes are on levels with few, `regions` where the other levels are populated. `levels`
    is scratch.
    """

    ordered: Records
    heads: Integers
    sparse: Integers
    regions: Records
    levels: Integers


class Memory(NamedTuple):
    """The grid, and one question at a time.

    `info` is one row of `INDEX`: what is known of the grid. `places` tells for each shape where its box is in
    `grid.ordered`, if it is kept, or `LOOSE`; `loose` lists those. `cores` are those of all shapes in world axes, each
    from its body's centre, and at the end those of the question; `boxes` is scratch. `question` and `walk` have one
    row, `hidden` a 1 for each body that is passed over.
    """

    info: Records
    places: Integers
    loose: Integers
    cores: Records
    boxes: Records
    grid: QueryGrid
    question: Records
    walk: Records
    hidden: Integers

    @classmethod
    def of(cls, bodies: int, shapes: int, vertices: int) -> Memory:
        """Memory for so many rows."""
        info = INDEX.zeros(1)
        info.generation = NOTHING
        return cls(
            info=info,
            places=np.zeros(shapes, np.int64),
            loose=np.zeros(shapes, np.int64),
            cores=VERTEX.zeros(vertices + SPARE_CORES),
            boxes=GRID_BOX.zeros(shapes),
            grid=QueryGrid(
                ordered=GRID_BOX.zeros(2 * shapes),
                heads=np.zeros(2 * interpreted(head_count)(shapes), np.int64),
                sparse=np.zeros(2 * SPARSE * LEVELS, np.int64),
                regions=REGION.zeros(2 * LEVELS + 2),
                levels=np.zeros(LEVEL_SPACE, np.int64),
            ),
            question=QUESTION.zeros(1),
            walk=WALK.zeros(1),
            hidden=np.zeros(bodies, np.int64),
        )

    def holds(self, state: State) -> bool:
        """Whether it has room for all rows of a state."""
        vertices = len(self.cores) - SPARE_CORES
        room = len(self.hidden), len(self.places), vertices
        return all(have >= rows for have, rows in zip(room, map(len, _tables(state)), strict=True))

    @classmethod
    def for_state(cls, state: State, times: int = 1) -> Memory:
        """Memory for all rows of a state, or for so many times as many."""
        return cls.of(*(times * len(table) for table in _tables(state)))


def _tables(state: State) -> tuple[Records, Records, Records]:
    return state.bodies, state.shapes, state.vertices
