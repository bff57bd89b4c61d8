"""What the broad phase knows of shapes, and where the grid keeps them."""

from __future__ import annotations

from typing import NamedTuple

from sandbox.tables import Field, Integers, Records, Table

BOX = Table(
    "box",
    (
        Field("lower_x", "m", "bounds of the shape, its margin and its displacement during the step"),
        Field("lower_y", "m", ""),
        Field("upper_x", "m", ""),
        Field("upper_y", "m", ""),
        Field("cell_x", "-", "cell of the box's middle, on the grid of its level", "i8"),
        Field("cell_y", "-", "", "i8"),
        Field("level", "-", "cells of its grid are 2**level m wide", "i8"),
        Field("shape_index", "-", "row of the shape", "i8"),
    ),
)
"""One row a shape, one cache line: all that the grid looks at before it finds an overlap."""

FILTER = Table(
    "filter",
    (
        Field("body", "-", "index of the body", "i8"),
        Field("moves", "-", "`ACTIVE`, `SLEEPS`, `DRIVEN` or 0, see `proxies`", "i8"),
        Field("category", "-", "", "i8"),
        Field("mask", "-", "", "i8"),
        Field("group", "-", "", "i8"),
        Field("confined", "-", "1 when it may meet something immovable during the step", "i8"),
    ),
)
"""One row a shape: what decides whether two overlapping boxes are a pair."""

PROXY = Table(
    "proxy",
    (
        Field("center_x", "m", "centre of mass of its body"),
        Field("center_y", "m", "centre of mass of its body"),
        Field("velocity_x", "m/s", "of its body"),
        Field("velocity_y", "m/s", "of its body"),
        Field("speed", "m/s", "of its body"),
        Field("swing", "m/s", "fastest that its core can turn"),
        Field("margin", "m", "half of the speculative margin of its pairs at low speed"),
        Field("extent", "m", "of its body"),
        Field("traits", "-", "bits of the shape and of how it moves, see `proxies`", "i4"),
        Field("body", "-", "index of the body", "i4"),
        Field("vertex_start", "-", "", "i8"),
        Field("vertex_count", "-", "", "i8"),
        Field("radius", "m", ""),
        Field("friction", "1", ""),
        Field("restitution", "1", ""),
        Field("rolling_resistance", "m", ""),
        Field("surface_speed", "m/s", ""),
    ),
)
"""One row a shape, two cache lines: all that the narrow phase asks of the shapes of a slow pair and their bodies."""

RESTING_GRID = Table(
    "resting_grid",
    (
        Field("cell", "m", "width of the cells of its level 0"),
        Field("used", "-", "its levels with many boxes", "i8"),
        Field("sparse", "-", "its boxes on other levels", "i8"),
        Field("lower_x", "m", "bounds of all its boxes"),
        Field("lower_y", "m", ""),
        Field("upper_x", "m", ""),
        Field("upper_y", "m", ""),
    ),
)
"""One row: what is known of a grid that is kept."""

PAIR = Table("pair", (Field("shape_a", "-", "", "i4"), Field("shape_b", "-", "", "i4")))


class Colliders(NamedTuple):
    """Shapes in the world, a row each; `cores` has a row for each core vertex, in world axes from the body's centre."""

    cores: Records
    boxes: Records
    filters: Records
    proxies: Records


class RestingGrid(NamedTuple):
    """A grid that is kept as long as its shapes rest: `info` is one row, the others are as those of a `Grid`."""

    info: Records
    heads: Integers
    levels: Integers


class Grid(NamedTuple):
    """The uniform grid and the pairs that it proposes.

    `ordered` has boxes bucket by bucket, `heads` where each bucket begins, `levels` the levels in use. Where it is
    split, those of `apart` come first, then those of `resting`. `spare_boxes` and `sorted_pairs` are scratch.
    """

    spare_boxes: Records
    ordered: Records
    heads: Integers
    levels: Integers
    resting: RestingGrid
    apart: RestingGrid
    pairs: Records
    sorted_pairs: Records
