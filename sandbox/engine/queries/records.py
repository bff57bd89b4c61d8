"""Memory of the queries of one world: made at the first question, never hashed, never saved."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sandbox.engine.broad_phase.grid import LEVEL_SPACE, LEVELS, head_count
from sandbox.engine.records.colliders import GRID_BOX
from sandbox.tables import Field, Integers, Records, Table
from sandbox.world.records import VERTEX
from sandbox.world.state import State

MAX_CORE = 64
"""Vertices of a shape that is asked about."""
SPARE_CORES = 3 * MAX_CORE
"""Rows at the end of the turned cores: the mirrored core of the question, then its sum with a core of the world."""

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
    ),
)
"""One row a level with many boxes: where it is populated. The last row has the bounds of all boxes."""

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
    """The grid of all shapes: `ordered` has their boxes bucket by bucket, `heads` tells where each bucket begins,
    `levels` which levels are in use, `regions` where those are populated."""

    ordered: Records
    heads: Integers
    levels: Integers
    regions: Records


class Memory(NamedTuple):
    """The grid, and one question at a time.

    `cores` are those of all shapes in world axes, each from its body's centre, and behind them those of the question;
    `boxes` has a row a shape, `question` and `walk` have one row, `hidden` a 1 for each body that is passed over.
    """

    cores: Records
    boxes: Records
    grid: QueryGrid
    question: Records
    walk: Records
    hidden: Integers

    @classmethod
    def for_state(cls, state: State) -> Memory:
        """Memory for all bodies and shapes of `state`."""
        shapes = len(state.shapes)
        return cls(
            cores=VERTEX.zeros(len(state.vertices) + SPARE_CORES),
            boxes=GRID_BOX.zeros(shapes),
            grid=QueryGrid(
                ordered=GRID_BOX.zeros(shapes),
                heads=np.zeros(head_count(shapes), np.int64),
                levels=np.zeros(LEVEL_SPACE, np.int64),
                regions=REGION.zeros(LEVELS + 1),
            ),
            question=QUESTION.zeros(1),
            walk=WALK.zeros(1),
            hidden=np.zeros(len(state.bodies), np.int64),
        )
